// Folders of images, videos and devices as sources of tp100-camera, and the images that they lack.

#include "camera/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <random>

#include "../programs/process.h"
#include "camera/watch.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace tp100::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Sources : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    write_bytes(folder_.file(name), text);
  }
  void draw(const std::string& name, int grey) const {
    cv::imwrite(folder_.file(name), cv::Mat(48, 64, CV_8U, cv::Scalar(grey)));
  }
  /// What is wrong with the source; empty if it is read to its end.
  static std::string problem(const std::string& source, std::optional<double> fps = {}) {
    return refusal([&] {
      const auto opened = camera::open_source(source, {.fps = fps});
      camera::Image image;
      while (opened->next(image)) {
      }
    });
  }
  /// A Motion JPEG video, which every OpenCV can write; each image has a different grey.
  std::string video(int images, double fps) const {
    const std::string path = folder_.file("video.avi");
    cv::VideoWriter writer(path, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           fps, {64, 48});
    for (int i = 0; i < images; ++i)
      writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(20 + 2 * i)));
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(Sources, AFolderIsReadInTheOrderOfItsNumbers) {
  draw("f10.png", 100);
  draw("f9.png", 90);
  draw("f11.png", 110);
  write(".hidden", "x");
  const auto source = camera::open_source(folder_.path().string(), {.fps = 20.0});
  camera::Image image;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(source->next(image));
    EXPECT_EQ(image.taken_ns, i * 50 * kNsPerMs);
    EXPECT_EQ(image.grey.at<unsigned char>(0, 0), 90 + 10 * i);
  }
  EXPECT_FALSE(source->next(image));
  EXPECT_FALSE(source->live());
}

TEST_F(Sources, TimesComeFromTheFileBesideTheImages) {
  draw("a.png", 10);
  draw("b.jpg", 20);
  write("times.csv", "file,t_s\r\nb.jpg,1.25\r\na.png,2.5\r\n");
  const auto files = camera::list_images(folder_.path().string(), {});
  ASSERT_EQ(files.size(), 2U);
  EXPECT_THAT(files[0].path, HasSubstr("b.jpg"));
  EXPECT_EQ(files[0].taken_ns, 1'250 * kNsPerMs);
  EXPECT_EQ(files[1].taken_ns, 2'500 * kNsPerMs);
}

TEST_F(Sources, BadTimesAreNamedByLine) {
  draw("a.png", 10);
  draw("b.png", 10);
  const auto error_of = [&](const std::string& times) {
    write("times.csv", times);
    return problem(folder_.path().string());
  };
  EXPECT_THAT(error_of("a.png,1\nb.png,1\n"), HasSubstr("times.csv:2: not later"));
  EXPECT_THAT(error_of("a.png,1\nb.png,nan\n"), HasSubstr("times.csv:2: t_s is 'nan'"));
  EXPECT_THAT(error_of("a.png,1\nb.png 2\n"), HasSubstr("times.csv:2: 1 values in 2 columns"));
  EXPECT_THAT(error_of("a.png,1\na.png,2\n"), HasSubstr("times.csv:2: named twice"));
  EXPECT_THAT(error_of("a.png,1\n"), HasSubstr("no time for b.png"));
  EXPECT_THAT(error_of("a.png,1\nb.png,2\nc.png,3\n"), HasSubstr("c.png is not in the folder"));
}

TEST_F(Sources, WhatIsNoImageInAFolderIsAnError) {
  const auto error = [&] { return problem(folder_.path().string(), 30.0); };
  EXPECT_THAT(error(), HasSubstr("no images"));
  draw("a.png", 10);
  EXPECT_EQ(error(), "");
  EXPECT_THAT(problem(folder_.path().string()), HasSubstr("--fps"));
  write("notes.txt", "hello");
  EXPECT_THAT(error(), HasSubstr("notes.txt: no image"));
  fs::remove(folder_.file("notes.txt"));
  write("b.png", "this is no image");
  EXPECT_THAT(error(), HasSubstr("b.png: cannot be read"));
  fs::remove(folder_.file("b.png"));
  fs::create_directory(folder_.file("c.png"));
  EXPECT_THAT(error(), HasSubstr("c.png: no image"));
}

// As a phone records it, or a camera that drops two images: five images and six more with 50 ms
// after each, and 150 ms after the one between them.
TEST(Video, ImagesThatWereDroppedLeaveAGapInItsTimes) {
  const auto source = camera::open_source(source_path("tests/camera/gap.mp4"), {});
  camera::ImageGaps gaps;
  camera::Image image;
  // The last images lie beyond the duration that the file states.
  for (int i = 0; i < 9; ++i) {
    ASSERT_TRUE(source->next(image)) << i;
    EXPECT_NEAR(to_s(image.taken_ns), (i < 6 ? i : i + 2) * 0.05, 1e-3) << i;
    EXPECT_EQ(gaps.number(image.taken_ns), static_cast<std::uint32_t>(i < 6 ? i + 1 : i + 3));
  }
  EXPECT_EQ(gaps.missing(), 2U);
}

TEST_F(Sources, AVideoHasItsOwnTimesAndIsAnErrorWhereItIsCutOff) {
  const std::string path = video(50, 25.0);
  const auto source = camera::open_source(path, {});
  camera::Image image;
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(source->next(image)) << i;
    EXPECT_NEAR(to_s(image.taken_ns), i * 0.04, 1e-4) << i;
    EXPECT_NEAR(image.grey.at<unsigned char>(20, 20), 20 + 2 * i, 3) << i;
  }
  EXPECT_FALSE(source->next(image));
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_THAT(problem(path), AnyOf(HasSubstr("ends after"), HasSubstr("cannot be read")));
  fs::resize_file(path, 0);
  EXPECT_THAT(problem(path), HasSubstr("cannot be read as a video"));
}

TEST_F(Sources, WhatIsNeitherIsAnErrorOfOneLine) {
  EXPECT_THAT(problem(folder_.file("nothing")), HasSubstr("no such video"));
  EXPECT_THAT(problem("997"), HasSubstr("/dev/video997"));
  write("text.mp4", "this is no video\n");
  EXPECT_THAT(problem(folder_.file("text.mp4")), HasSubstr("cannot be read as a video"));
  EXPECT_THAT(problem("/dev/null"), HasSubstr("cannot be opened as a camera"));
  // A list of other files is not accepted as a video.
  write("list.m3u8", "#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:9/a.ts\n#EXT-X-ENDLIST\n");
  EXPECT_THAT(problem(folder_.file("list.m3u8")), HasSubstr("cannot be read as a video"));
}

TEST(ImageGaps, DroppedImagesLeaveAGapInTheNumbersWhateverTheJitter) {
  camera::ImageGaps gaps;
  std::mt19937 random(2);
  std::normal_distribution<double> jitter(0.0, 0.003);
  std::uint32_t dropped = 0;
  for (std::uint32_t i = 1; i <= 500; ++i) {
    if (i > 10 && i < 500 && random() % 5 == 0) {
      ++dropped;
      continue;
    }
    const double late_s = std::clamp(jitter(random), -0.006, 0.006);
    EXPECT_EQ(gaps.number(from_s(i / 30.0 + late_s)), i);
  }
  EXPECT_GT(dropped, 40U);
  EXPECT_EQ(gaps.missing(), dropped);
}

TEST(ImageGaps, ACameraThatSlowsDownInTheDarkIsNotDroppingForLong) {
  camera::ImageGaps gaps;
  double t_s = 0.0;
  for (int i = 0; i < 50; ++i) gaps.number(from_s(t_s += 1.0 / 30.0));
  for (int i = 0; i < 200; ++i) gaps.number(from_s(t_s += 1.0 / 15.0));
  EXPECT_LT(gaps.missing(), 10U);
}

TEST(ImageGaps, AnImageThatIsNotNewerHasNoNumber) {
  camera::ImageGaps gaps;
  EXPECT_EQ(gaps.number(100), 1U);
  EXPECT_FALSE(gaps.number(100).has_value());
  EXPECT_FALSE(gaps.number(50).has_value());
  EXPECT_EQ(gaps.number(200), 2U);
}

TEST(DeviceImageTime, IsTheDriversWhereThatIsAMonotonicStampAndElseThatOfTheGrabbing) {
  const HostNs grabbed = 5'000 * kNsPerS, delay = 10 * kNsPerMs;
  EXPECT_EQ(camera::image_time(4'999'960.0, grabbed, delay), grabbed - 40 * kNsPerMs - delay);
  for (const double driver_ms : {0.0, -1.0, 1.7e12, 5'000'001.0, 4'998'000.0})
    EXPECT_EQ(camera::image_time(driver_ms, grabbed, delay), grabbed - delay) << driver_ms;
}

}  // namespace
}  // namespace tp100::test
