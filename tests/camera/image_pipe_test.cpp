// Images that another program writes into a pipe of tp100-camera.

#include "camera/image_pipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <future>
#include <memory>
#include <string>

#include "../support/temporary_folder.h"
#include "core/clock.h"
#include "support/refusal.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

/// A source that reads `bytes` (at most the capacity of a pipe), and then the end of the stream.
std::unique_ptr<camera::Source> source_of(const std::string& bytes, double delay_s = 0.0) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  EXPECT_EQ(::write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  ::close(ends[1]);
  return camera::open_image_pipe(ends[0], "pipe", {.fps = {}, .delay_s = delay_s});
}

std::string grey(const std::string& stamp, char value) {
  return "P5\n" + stamp + "3 2\n255\n" + std::string(6, value);
}

camera::Image next(camera::Source& source) {
  camera::Image image;
  EXPECT_TRUE(source.next(image));
  return image;
}

/// What is wrong with the stream; empty if it is read to its end.
std::string problem(const std::string& bytes) {
  return refusal([&] {
    const auto source = source_of(bytes);
    camera::Image image;
    while (source->next(image)) {
    }
  });
}

// A signal may arrive at any moment, also just before the source waits for the rest of an image.
TEST(ImagePipe, EndsWithinAnImageOnceItIsStopped) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int stop = ::eventfd(0, 0);
  ASSERT_GE(stop, 0);
  const auto source = camera::open_image_pipe(ends[0], "pipe", {.fps = {}, .stop_fd = stop});
  const std::string bytes = grey("", 7) + "P5\n3 2\n255\nxx";
  ASSERT_EQ(::write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  camera::Image image = next(*source);
  ASSERT_EQ(::eventfd_write(stop, 1), 0);
  EXPECT_FALSE(source->next(image));
  ::close(stop);
  ::close(ends[1]);
}

TEST(ImagePipe, GivesImagesWithTheirStampsInTheOrderInWhichTheyCome) {
  const auto source = source_of(grey("# taken_s 12.25\n", 7) + grey("# taken_s 12.5\n", 9));
  EXPECT_TRUE(source->live());
  EXPECT_TRUE(source->ends());
  camera::Image first = next(*source), second = next(*source);
  EXPECT_EQ(first.taken_ns, 12'250'000'000);
  EXPECT_EQ(second.taken_ns, 12'500'000'000);
  EXPECT_EQ(first.grey.size(), cv::Size(3, 2));
  // The second has not overwritten the first.
  EXPECT_EQ(first.grey.at<unsigned char>(1, 2), 7);
  EXPECT_EQ(second.grey.at<unsigned char>(1, 2), 9);
  EXPECT_FALSE(source->next(second));
}

TEST(ImagePipe, AnImageWithoutAStampWasTakenWhenItCameLessTheDelay) {
  const HostNs before = monotonic_now();
  const auto source = source_of(grey("# made by another program\n", 1), 0.04);
  const camera::Image image = next(*source);
  EXPECT_GE(image.taken_ns, before - 40 * kNsPerMs);
  EXPECT_LE(image.taken_ns, monotonic_now() - 40 * kNsPerMs);
}

TEST(ImagePipe, ColoursAreRedGreenAndBlue) {
  const auto source = source_of(std::string("P6 1 1 255\n") + "\xF0\x80\x10");
  const camera::Image image = next(*source);
  EXPECT_EQ(image.shown.at<cv::Vec3b>(0, 0), cv::Vec3b(0x10, 0x80, 0xF0));
  EXPECT_NEAR(image.grey.at<unsigned char>(0, 0), 0.299 * 0xF0 + 0.587 * 0x80 + 0.114 * 0x10, 1.0);
}

TEST(ImagePipe, PixelsThatLookLikeAHeaderAreJustPixels) {
  const auto source = source_of("P5 5 2 255\n#P5\n #P5\n " + grey("", 4));
  EXPECT_EQ(next(*source).grey.at<unsigned char>(0, 0), '#');
  EXPECT_EQ(next(*source).grey.at<unsigned char>(0, 0), 4);
}

TEST(ImagePipe, SaysWhatIsWrongWithWhichImage) {
  EXPECT_EQ(problem(""), "");
  EXPECT_THAT(problem("\x89PNG\r\n"), HasSubstr("not a netpbm image"));
  EXPECT_THAT(problem(grey("", 1) + "P4 1 1\n"), HasSubstr("image 2: not a netpbm image"));
  EXPECT_THAT(problem(grey("", 1).substr(0, 12)), HasSubstr("ends within its pixels"));
  EXPECT_THAT(problem("P5 3"), HasSubstr("ends within its header"));
  EXPECT_THAT(problem("P5 0 2 255\n"), HasSubstr("0 is not a number"));
  EXPECT_THAT(problem("P5 99999999999 2 255\n"), HasSubstr("is not a number"));
  EXPECT_THAT(problem("P5 3x 2 255\n"), HasSubstr("3x is not a number"));
  EXPECT_THAT(problem("P5 16384 16384 255\n"), HasSubstr("too large"));
  EXPECT_THAT(problem("P5 3 2 4095\n"), HasSubstr("write 8 bits"));
  EXPECT_THAT(problem(grey("# taken_s now\n", 1)), HasSubstr("no time after taken_s"));
  EXPECT_THAT(problem(grey("# taken_s\n", 1)), HasSubstr("no time after taken_s"));
  EXPECT_THAT(problem("P5 #" + std::string(5000, 'x')), HasSubstr("does not end"));
}

TEST(ImagePipe, AFifoIsOpenedByItsName) {
  const TemporaryFolder folder;
  const std::string path = folder.file("images");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  // Each end waits for the other one.
  const auto writing = std::async(std::launch::async, [&] {
    std::ofstream(path, std::ios::binary) << grey("# taken_s 1\n", 3);
  });
  const auto source = camera::open_source(path, {});
  camera::Image image = next(*source);
  EXPECT_EQ(image.taken_ns, kNsPerS);
  EXPECT_FALSE(source->next(image));
}

}  // namespace
}  // namespace tp100::test
