// The image as avr-gcc made it, on a simulated ATmega2560. Times are simulated.
#include <gtest/gtest.h>

#include <fstream>

#include "mega.h"
#include "wire/faults.h"
#include "wire/messages.h"

namespace tp100::image {
namespace {

using wire::Type;

const std::string kImages = TP100_BINARY_DIR "/firmware/";

class Image : public testing::Test {
 protected:
  void open_session() {
    mega_.run_ms(10);
    mega_.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    mega_.run_ms(5);
    wire::Parameters parameters{};
    parameters.boot_nonce = nonce();
    parameters.token = 5;
    parameters.counts_per_metre = 9300.0F;
    parameters.wheelbase_m = 0.27F;
    parameters.max_track_mps = 0.5F;
    parameters.max_track_mps2 = 2.0F;
    parameters.feed_forward = 1.5F;
    parameters.dead_band = 0.12F;
    parameters.max_yaw_radps = 2.0F;
    parameters.gyro_z_radps_per_lsb = 5.3e-4F;
    parameters.stall_ms = 500;
    parameters.command_life_ms = 200;
    parameters.yaw_window_ms = 100;
    mega_.send(parameters);
    mega_.run_ms(20);
  }
  std::uint32_t nonce() const { return mega_.last<wire::Hello>().boot_nonce; }
  void command(float speed_mps) {
    const auto sample = mega_.last<wire::Sample>();
    wire::Command command{};
    command.boot_nonce = nonce();
    command.sequence = ++sequence_;
    command.answers = sample.sequence;
    command.speed_mps = speed_mps;
    command.expiry_us = sample.device_us + 180000;
    mega_.send(command);
    mega_.run_ms(10);
  }
  void arm() {
    command(0.0F);
    mega_.send(wire::Arm{nonce(), 1, mega_.last<wire::Sample>().device_us + 200000});
    mega_.run_ms(5);
  }

  Mega mega_{kImages + "tp100.elf"};
  std::uint16_t sequence_ = 0;
};

TEST_F(Image, SaysHelloAtOnceAndThenEvery200Ms) {
  mega_.run_ms(20);
  ASSERT_EQ(mega_.count(Type::kHello), 1u);
  const auto hello = mega_.last<wire::Hello>();
  EXPECT_EQ(hello.protocol, wire::kProtocolVersion);
  EXPECT_EQ(hello.schema, wire::kSchemaHash);
  EXPECT_EQ(hello.board, static_cast<std::uint8_t>(wire::Board::kMega2560));
  EXPECT_EQ(hello.reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kPowerOn));
  EXPECT_NE(hello.boot_nonce, 0u);
  mega_.run_ms(1000);
  EXPECT_EQ(mega_.count(Type::kHello), 6u);
  EXPECT_EQ(mega_.bad_frames(), 0u);
}

TEST_F(Image, SamplesEvery5MsAndCountsEveryEdgeBothWays) {
  open_session();
  const std::size_t before = mega_.count(Type::kSample);
  mega_.turn(1, 100.0);
  mega_.run_ms(100);
  mega_.turn(0, 100.0);
  mega_.run_ms(10);
  const auto forward = mega_.last<wire::Sample>();
  EXPECT_NEAR(forward.left_counts, 1000, 2);
  EXPECT_EQ(forward.left_counts, forward.right_counts);
  mega_.turn(-1, 100.0);
  mega_.run_ms(100);
  mega_.turn(0, 100.0);
  mega_.run_ms(10);
  const auto back = mega_.last<wire::Sample>();
  EXPECT_NEAR(back.left_counts, 0, 2);
  EXPECT_EQ(back.left_counts, back.right_counts);
  EXPECT_NEAR(static_cast<double>(mega_.count(Type::kSample) - before), 44.0, 1.0);
  EXPECT_NEAR(back.battery_mv, 7500, 30);
}

TEST_F(Image, DrivesBothMotorsOnlyWhenArmedAndStopsWithin200MsOfTheLastCommand) {
  open_session();
  for (int i = 0; i < 10; ++i) command(0.3F);
  EXPECT_TRUE(mega_.motors_off());
  arm();
  ASSERT_EQ(mega_.last<wire::Acknowledge>().result, 0);
  for (int i = 0; i < 20; ++i) command(0.3F);
  EXPECT_GT(mega_.left_duty(), 0.2);
  EXPECT_GT(mega_.right_duty(), 0.2);
  for (int i = 0; i < 40; ++i) command(-0.3F);
  EXPECT_LT(mega_.left_duty(), -0.2);
  EXPECT_LT(mega_.right_duty(), -0.2);
  // The last command is up to 10 ms old.
  mega_.run_ms(100);
  EXPECT_FALSE(mega_.motors_off());
  mega_.run_ms(100);
  EXPECT_TRUE(mega_.motors_off());
  EXPECT_EQ(mega_.last<wire::Sample>().faults, fault_bit(wire::Fault::command_timeout));
}

TEST_F(Image, AFloodOfBytesLosesNoEdgeAndKeepsTheSamples) {
  open_session();
  mega_.send(std::vector<std::uint8_t>(5000, 0x55));
  const auto before = mega_.last<wire::Sample>();
  mega_.turn(1, 100.0);
  mega_.run_ms(100);
  mega_.turn(0, 100.0);
  mega_.run_ms(20);
  const auto after = mega_.last<wire::Sample>();
  EXPECT_NEAR(after.left_counts - before.left_counts, 1000, 2);
  EXPECT_EQ(after.left_counts, after.right_counts);
  EXPECT_GE(after.sequence - before.sequence, 22);
}

TEST(GoldenFrames, AreDecodedAndCodedByteForByteOnTheMega) {
  std::ifstream file(TP100_SOURCE_DIR "/tests/wire/golden_frames.txt");
  std::vector<std::uint8_t> golden;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    for (std::size_t at = line.rfind(' ') + 1; at + 1 < line.size(); at += 2) {
      golden.push_back(static_cast<std::uint8_t>(std::stoi(line.substr(at, 2), nullptr, 16)));
    }
  }
  ASSERT_GT(golden.size(), 300u);
  Mega mega(kImages + "image/golden_mega.elf");
  mega.run_ms(200);
  EXPECT_EQ(mega.bytes(), golden);
}

}  // namespace
}  // namespace tp100::image
