// What the firmware takes of an ATmega2560, in cycles of the emulated chip.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

#include "board_rig.h"
#include "chip_time.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace tp100::sim {
namespace {

constexpr double kCountsPerMetre = 11140.0;

double mps_of_edges(double per_channel_hz) { return 2.0 * per_channel_hz / kCountsPerMetre; }

/// Drives with every monitor at work: 200 Hz samples, 100 Hz commands, and edges of top speed.
struct Drive {
  explicit Drive(AvrRig& rig) : any(rig.board.core(), InterruptTime::kAny), loop(rig.board.core()) {
    rig.drive(0.18f);
    rig.forced_mps = 0.2;
    rig.run(300);
    const CpuCycles cycles = rig.board.core().cycle(), slept = loop.slept();
    const std::uint64_t interrupts = any.runs();
    loop.clear();
    rig.run(1000);
    const auto took = static_cast<double>(rig.board.core().cycle() - cycles);
    const auto entries =
        static_cast<double>((any.runs() - interrupts) * InterruptTime::kEntryCycles);
    busy = 1.0 - (static_cast<double>(loop.slept() - slept) - entries) / took;
  }
  InterruptTime any;
  LoopTime loop;
  double busy = 0.0;
};

bool keeps_count(double per_channel_hz) {
  AvrRig rig;
  if (!rig.boot()) return false;
  rig.be_ready();
  rig.forced_mps = mps_of_edges(per_channel_hz);
  rig.run(300);
  rig.forced_mps = 0.0;
  rig.run(200);
  return rig.last().left_counts == rig.left.counts() &&
         rig.last().right_counts == rig.right.counts() && rig.board.counters().rx_overruns == 0;
}

/// Prints a figure for scripts/bench, and expects that PROTOCOL.md names its limit.
void report(const char* what, double now, double limit_value, const char* unit) {
  std::ostringstream words;
  words << limit_value << ' ' << unit;
  const std::string limit = words.str();
  std::printf("{\"what\":\"%s\",\"now\":%.2f,\"limit\":\"%s\"}\n", what, now, limit.c_str());
  EXPECT_THAT(test::read_bytes(source_path("firmware/PROTOCOL.md")),
              testing::HasSubstr(std::string("| ") + what + " | " + limit + " |"));
}

// With less time left, a sample or a command would be late whenever the host sends more.
TEST(FirmwareBudget, DrivingLeavesHalfOfTheProcessor) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  const Drive drive(rig);
  ASSERT_EQ(rig.state(), wire::State::kRunning);
  const double longest_ms = 1e3 * static_cast<double>(drive.loop.longest()) / AvrCore::kHz;
  constexpr double kMostPercent = 45.0, kLongestMs = 2.5;
  report("processor busy while driving", 100.0 * drive.busy, kMostPercent, "%");
  report("longest pass of the main loop", longest_ms, kLongestMs, "ms");
  EXPECT_LE(100.0 * drive.busy, kMostPercent);
  EXPECT_LE(longest_ms, kLongestMs);
}

// An encoder of a faster robot loses edges above this rate, and the pose is wrong unnoticed.
TEST(FirmwareBudget, CountsEveryEdgeOfFourFastChannels) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  const InterruptTime left(rig.board.core(), 5), right(rig.board.core(), 4);
  rig.be_ready();
  rig.forced_mps = mps_of_edges(10'000.0);
  rig.run(200);
  const auto longest = std::max(left.longest(), right.longest());
  constexpr unsigned kMostCycles = 87;
  report("interrupt of an encoder's edge", static_cast<double>(longest), kMostCycles, "cycles");
  EXPECT_LE(longest, kMostCycles);
  // Finds the fastest rate of those above the limit, too, which scripts/bench shows.
  constexpr double kLeastKhz = 16.9;
  double counted_khz = 0.0;
  for (double khz = kLeastKhz; khz < 30.0 && keeps_count(1e3 * khz); khz += 0.5) counted_khz = khz;
  report("edges counted on each of four channels", counted_khz, kLeastKhz, "kHz");
  EXPECT_GE(counted_khz, kLeastKhz);
}

}  // namespace
}  // namespace tp100::sim
