// Tests the program tp100-camera on recordings of drawn images.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "../link/udp_receiver.h"
#include "../programs/process.h"
#include "core/arithmetic.h"
#include "core/clock.h"
#include "core/time.h"
#include "link/camera_message.h"
#include "link/udp.h"
#include "marker_scene.h"
#include "support/paths.h"
#include "text/format.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

constexpr double kFps = 20.0;

class CameraProgram : public testing::Test {
 protected:
  CameraProgram() {
    std::ofstream(folder_.file("lens.toml")) << camera::write_lens(lens_of(tilted_camera()));
    std::ofstream(view()) << camera::write_view(corner_view());
    fs::create_directory(images());
  }
  std::string view() const { return folder_.file("view.toml"); }
  std::string images() const { return folder_.file("images"); }
  std::string program() const { return build_path("bin/tp100-camera"); }
  static Pose drive(double t_s) {
    return {.x_m = -0.4 + 0.2 * t_s, .y_m = 0.1 + 0.05 * t_s, .yaw_rad = 0.3 + 0.5 * t_s};
  }
  /// Records the images of a drive that have these numbers.
  void record(const std::vector<int>& numbers) {
    Scene scene = corner_scene();
    std::ofstream times(folder_.file("images/times.csv"));
    for (const int i : numbers) {
      const std::string name = "p" + std::to_string(i) + ".png";
      cv::imwrite(images() + "/" + name, scene.image(drive(i / kFps)),
                  {cv::IMWRITE_PNG_COMPRESSION, 1});
      times << name << ',' << i / kFps << '\n';
    }
  }
  Finished watch(const std::string& source, const Words& more = {}) const {
    return run(joined({program(), source, "--view", view()}, more));
  }
  static void write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd, bytes.data(), bytes.size());
      ASSERT_GT(written, 0);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  /// tp100-camera, which sends to `receiver`.
  Words sending(const UdpReceiver& receiver, const Words& arguments) const {
    return joined({program(), "--send", "udp:" + std::to_string(receiver.port())}, arguments);
  }
  void expect_error(const Finished& finished, const std::string& text) const {
    EXPECT_EQ(finished.status, 2) << finished.output;
    EXPECT_EQ(lines(finished.output), 1U) << finished.output;
    EXPECT_THAT(finished.output, HasSubstr(text));
  }

  TemporaryFolder folder_;
};

TEST_F(CameraProgram, WritesTheDriveAsATumFile) {
  record({0, 1, 2, 3, 4, 5, 8, 9, 10, 11});
  const std::string tum = folder_.file("drive.tum");
  const Finished finished = watch(images(), {"--tum", tum});
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_THAT(finished.output, HasSubstr("images 10, dropped 2"));
  EXPECT_THAT(finished.output, HasSubstr("seen in 10"));
  std::istringstream file(read_bytes(tum));
  int rows = 0;
  for (std::string row; std::getline(file, row);) {
    if (row.starts_with("#")) continue;
    std::istringstream fields(row);
    double t_s, x, y, z, qx, qy, qz, qw;
    ASSERT_TRUE(fields >> t_s >> x >> y >> z >> qx >> qy >> qz >> qw) << row;
    const Pose truth = drive(t_s);
    EXPECT_LT(std::hypot(x - truth.x_m, y - truth.y_m), 0.001) << row;
    EXPECT_NEAR(wrap_angle(2.0 * std::atan2(qz, qw) - truth.yaw_rad), 0.0, 0.8 * kRadPerDeg);
    EXPECT_NEAR(qz * qz + qw * qw, 1.0, 1e-6);
    ++rows;
  }
  EXPECT_EQ(rows, 10);
}

TEST_F(CameraProgram, SendsWhatComesThroughAPipeWithTheStampsItHasUntilASignal) {
  UdpReceiver receiver;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  Process camera(sending(receiver, {"-", "--view", view()}), ends[0]);
  Scene scene = corner_scene();
  for (int i = 0; i < 4; ++i) {
    const cv::Mat image = scene.image(drive(i / kFps));
    const HostNs taken_ns = monotonic_now();
    write_all(ends[1], text::format("P5\n# taken_s %.6f\n%d %d\n255\n", to_s(taken_ns), image.cols,
                                    image.rows));
    write_all(ends[1], {reinterpret_cast<const char*>(image.data), image.total()});
    std::string datagram = receiver.wait(60'000);
    while (link::is_image(datagram)) datagram = receiver.wait(60'000);
    const auto message = link::decode_camera(datagram);
    ASSERT_TRUE(message.has_value()) << camera.output();
    EXPECT_NEAR(static_cast<double>(message->stamp_us), static_cast<double>(taken_ns) * 1e-3, 1.5);
    EXPECT_EQ(message->clock, link::monotonic_clock_name());
    EXPECT_EQ(message->sequence, static_cast<std::uint32_t>(i + 1));
    EXPECT_LT(message->age_us, 60'000'000);
    const Pose truth = drive(i / kFps);
    EXPECT_LT(std::hypot(message->x_m - truth.x_m, message->y_m - truth.y_m), 0.0015);
  }
  // Half an image, more than a pipe holds, so that the program has begun to read it.
  write_all(ends[1], "P5\n1920 1080\n255\n" + std::string(1'000'000, 'x'));
  camera.signal(SIGTERM);
  EXPECT_EQ(camera.wait(), 0) << camera.output();
  EXPECT_THAT(camera.output(), HasSubstr("seen in 4"));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(CameraProgram, SendsImagesOfAnyCameraAtARateAndSizeForPeople) {
  constexpr int kImages = 12;
  std::ofstream times(folder_.file("images/times.csv"));
  for (int i = 0; i < kImages; ++i) {
    const std::string name = std::to_string(i) + ".png";
    cv::imwrite(images() + "/" + name, cv::Mat(720, 1280, CV_8UC3, cv::Scalar(200, 60, 20 * i)));
    times << name << ',' << i / kFps << '\n';
  }
  times.close();
  UdpReceiver receiver;
  Process sender(sending(receiver, {images(), "--images-only"}));
  std::optional<std::int64_t> last_us;
  std::uint32_t received = 0;
  // Then all images wait in the socket.
  EXPECT_EQ(sender.wait(), 0) << sender.output();
  for (std::string datagram; !(datagram = receiver.wait(100)).empty();) {
    const auto message = link::decode_image(datagram);
    ASSERT_TRUE(message.has_value());
    EXPECT_EQ(message->clock, link::monotonic_clock_name());
    EXPECT_EQ(message->sequence, ++received);
    // Five of twenty images per second: every fourth, except those that a busy machine skips.
    if (last_us) {
      EXPECT_GE(message->stamp_us - *last_us, 150'000);
    }
    last_us = message->stamp_us;
    const cv::Mat image = cv::imdecode(
        std::vector<char>(message->jpeg.begin(), message->jpeg.end()), cv::IMREAD_UNCHANGED);
    EXPECT_EQ(image.size(), cv::Size(480, 270));
    const cv::Vec3b colour = image.at<cv::Vec3b>(135, 240);
    EXPECT_NEAR(colour[0], 200, 6);
    EXPECT_NEAR(colour[1], 60, 6);
  }
  EXPECT_GE(received, 1U);
  EXPECT_LE(received, 4U);
  EXPECT_THAT(sender.output(), HasSubstr("images sent " + std::to_string(received)));
}

TEST_F(CameraProgram, AnImageThatDoesNotCompressStillFitsIntoADatagram) {
  cv::Mat noise(1080, 1920, CV_8UC3);
  cv::randu(noise, 0, 255);
  cv::imwrite(images() + "/p.png", noise);
  camera::View wide = corner_view();
  wide.images.width_px = 480;
  std::ofstream(view()) << camera::write_view(wide);
  UdpReceiver receiver;
  Process sender(sending(receiver, {images(), "--view", view(), "--fps", "1"}));
  EXPECT_EQ(sender.wait(), 1) << sender.output();
  EXPECT_TRUE(link::decode_image(receiver.wait(100)).has_value());
}

TEST_F(CameraProgram, WhatIsWrongAtTheStartIsAnErrorOfOneLine) {
  record({0});
  expect_error(run({program()}), "SOURCE");
  expect_error(run({program(), images()}), "--view");
  expect_error(watch(images(), {"--images-only"}), "--images-only");
  expect_error(watch(images(), {"--send", "47100"}), "--send");
  expect_error(watch(images(), {"--tum", "/nowhere/drive.tum"}), "cannot be written");
  expect_error(watch(images(), {"--size", "big"}), "--size");
  expect_error(run({program(), images(), "--calibrate-lens", folder_.file("l.toml")}), "--board");
  std::ofstream(folder_.file("images/notes.txt")) << "no image";
  expect_error(watch(images(), {"--tum", folder_.file("t")}), "notes.txt");
  fs::remove(folder_.file("images/notes.txt"));
  fs::remove(folder_.file("lens.toml"));
  expect_error(watch(images(), {"--tum", folder_.file("t")}), "lens.toml");
}

TEST_F(CameraProgram, ARecordingWithoutTheMarkerFails) {
  Scene scene = corner_scene();
  cv::imwrite(images() + "/p.png", scene.empty_floor({}));
  const Finished finished = watch(images(), {"--fps", "30", "--tum", folder_.file("t")});
  EXPECT_EQ(finished.status, 1) << finished.output;
  EXPECT_THAT(finished.output, HasSubstr("no image shows marker 0"));
}

TEST_F(CameraProgram, PrintsMarkersAndBoards) {
  const std::string svg = folder_.file("marker.svg"), png = folder_.file("board.png");
  EXPECT_EQ(run({program(), "--print-marker", svg, "--view", view()}).status, 0);
  EXPECT_THAT(read_bytes(svg), HasSubstr("width=\"150mm\""));
  EXPECT_EQ(run({program(), "--print-board", png, "--board", "charuco:7x5:0.04:0.03"}).status, 0);
  EXPECT_FALSE(cv::imread(png).empty());
  EXPECT_EQ(run({program(), "--print-marker", svg, "--id", "999"}).status, 2);
}

}  // namespace
}  // namespace tp100::test
