// Samples of the robot's frames: encoder counts without glitches, order, and values in SI units.
#include "link/sample_intake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "support/sequence.h"

namespace tp100::link {
namespace {

constexpr double kDtS = 0.005;
constexpr double kMaxPerS = 6000.0;  // 30 counts per sample, and 4 that an interrupt may move

/// A board's encoder, whose count wraps, and the counts that the link makes of it.
struct Track {
  explicit Track(double max_per_s = kMaxPerS, std::int32_t from = 0)
      : counts(max_per_s), board(from) {
    counts.update(from, 0);
  }
  bool moves(std::int32_t by, double dt_s = kDtS) {
    board = static_cast<std::int32_t>(static_cast<std::uint32_t>(board) +
                                      static_cast<std::uint32_t>(by));
    return counts.update(board, std::llround(dt_s * 1e6));
  }
  EncoderCount counts;
  std::int32_t board;
};

TEST(EncoderCount, GoesOnBeyondTheWrapOfTheBoards) {
  const std::int32_t from = std::numeric_limits<std::int32_t>::max() - 3000;
  Track track(kMaxPerS, from);
  test::Sequence random(1);
  std::int64_t counts = from;
  EXPECT_EQ(track.counts.counts(), from) << "it begins with the board's own count";
  for (int i = 0; i < 20'000; ++i) {
    // Runs far forwards, then far back.
    const int step = random.below(40) - (i < 10'000 ? 5 : 34);
    ASSERT_TRUE(track.moves(step)) << i;
    ASSERT_EQ(track.counts.counts(), counts += step) << i;
  }
}

TEST(EncoderCount, MoreThanATrackCanDoInItsTimeIsAJump) {
  for (const int sign : {1, -1}) {
    for (const double dt_s : {0.005, 0.01, 0.1, 1.0}) {
      const int possible = static_cast<int>(std::lround(kMaxPerS * dt_s)) + 4;
      EXPECT_TRUE(Track().moves(sign * possible, dt_s)) << dt_s;
      EXPECT_FALSE(Track().moves(sign * (possible + 1), dt_s)) << dt_s;
    }
    EXPECT_TRUE(Track(0.0).moves(sign * 1'000'000)) << "there is no limit";
    EXPECT_TRUE(Track().moves(sign * 1'000'000, 0.0)) << "no time is known";
  }
}

TEST(EncoderCount, AJumpIsLeftOutAndTheTrackGoesOnAsItWent) {
  for (const std::int32_t jump : {125, -125, 500, -30000}) {
    Track track;
    for (int i = 0; i < 20; ++i) track.moves(7);
    EXPECT_FALSE(track.moves(7 + jump));
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(track.moves(7));
    EXPECT_EQ(track.counts.counts(), 41 * 7);
  }
}

// The way back of a glitch is part of it; one that comes again and again is a fault that the
// monitors of the tracks must see.
TEST(EncoderCount, ASecondJumpIsAcceptedUnlessItIsTheWayBackOrComesLongAfter) {
  for (int apart = 1; apart <= 240; ++apart) {
    Track track;
    for (int i = 0; i < 20; ++i) track.moves(7);
    EXPECT_FALSE(track.moves(507));
    for (int i = 1; i < apart; ++i) EXPECT_TRUE(track.moves(7));
    // 20 samples are 0.1 s, 200 are 1 s.
    EXPECT_EQ(track.moves(-493), apart > 20 && apart < 200) << apart;
  }
}

TEST(EncoderCount, WhatLastsIsAccepted) {
  Track track;
  int held = 0;
  for (int i = 0; i < 100; ++i) held += track.moves(90) ? 0 : 1;
  EXPECT_EQ(held, EncoderCount::kHeldInRow);
  EXPECT_EQ(track.counts.counts(), 90 * (100 - EncoderCount::kHeldInRow));
}

TEST(EncoderCount, NothingIsMadeUpForAJumpAfterALongGap) {
  for (const auto& [gap_s, made_up] : {std::pair{0.1, 400}, {0.101, 0}, {2.0, 0}}) {
    Track track;
    track.moves(20);
    EXPECT_FALSE(track.moves(20'000, gap_s));
    EXPECT_EQ(track.counts.counts(), 20 + made_up) << gap_s;
  }
}

TEST(EncoderCount, AnotherRobotsLimitAndAnotherBootsCountBeginAtOnce) {
  Track track;
  EXPECT_TRUE(track.moves(30));
  track.counts.set_limit(1000.0);
  EXPECT_FALSE(track.moves(30));
  for (int i = 0; i < EncoderCount::kHeldInRow; ++i) track.moves(30);
  track.counts.forget();
  EXPECT_TRUE(track.moves(70'000));
  EXPECT_EQ(track.counts.counts(), track.board);
  EXPECT_FALSE(track.moves(30)) << "jumps of the boot before do not count";
}

class Intake : public ::testing::Test {
 protected:
  Intake() {
    clock_.valid = true;
    clock_.reference_host_ns = 40 * kNsPerS;
    intake_.begin(true);
  }
  bool push(const wire::Sample& sample, DeviceUs device_us, HostNs after_ns = 3 * kNsPerMs) {
    return intake_.push(sample, device_us, clock_, clock_.to_host(device_us) + after_ns);
  }
  bool push_at(int sequence, DeviceUs device_us) {
    wire::Sample sample{};
    sample.sequence = static_cast<std::uint16_t>(sequence);
    return push(sample, device_us);
  }

  LinkCounters counters_{};
  SampleIntake intake_{counters_, kMaxPerS};
  ClockState clock_;
};

// From the LSBs of PROTOCOL.md: 32.8 a degree per second, 8192 a g, 340 a kelvin from 36.53.
TEST_F(Intake, ValuesAreInSiUnitsWithTheirSigns) {
  const wire::Sample sample{.sequence = 7,
                            .device_us = 0,
                            .left_counts = -20,
                            .right_counts = 21,
                            .gyro = {328, -656, 3280},
                            .accel = {8192, -4096, 2048},
                            .temperature = -3400,
                            .battery_mv = 7654,
                            .left_duty = -wire::kFullDuty,
                            .right_duty = wire::kFullDuty / 4,
                            .state = static_cast<std::uint8_t>(RobotState::kRunning),
                            .faults = 0x8001,
                            .last_command = 40'000,
                            .imu_age = 9};
  ASSERT_TRUE(push(sample, 5000));
  const Sample taken = intake_.take()[0];
  EXPECT_EQ(taken.sequence, 7);
  EXPECT_EQ(taken.device_us, 5000);
  EXPECT_EQ(taken.measured_ns, 40 * kNsPerS + 5 * kNsPerMs);
  EXPECT_EQ(taken.left_counts, -20);
  EXPECT_EQ(taken.right_counts, 21);
  const double degps[] = {10.0, -20.0, 100.0}, g[] = {1.0, -0.5, 0.25};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(taken.gyro_radps[axis], degps[axis] * std::numbers::pi / 180.0, 1e-6);
    EXPECT_NEAR(taken.accel_mps2[axis], g[axis] * 9.80665, 1e-9);
  }
  EXPECT_NEAR(taken.temperature_degc, 26.53, 1e-5);
  EXPECT_NEAR(taken.battery_v, 7.654, 1e-9);
  EXPECT_EQ(taken.left_duty, -1.0);
  EXPECT_EQ(taken.right_duty, 0.25);
  EXPECT_EQ(taken.state, RobotState::kRunning);
  EXPECT_EQ(taken.faults, 0x8001U);
  EXPECT_EQ(taken.last_command, 40'000);
  EXPECT_EQ(taken.imu_age, 9);
}

TEST_F(Intake, ImpossibleValuesAreRefusedAndCounted) {
  struct Case {
    int left_duty, right_duty, state;
    bool good;
  };
  constexpr int kFaulted = static_cast<int>(RobotState::kFaulted);
  const Case cases[] = {{1000, -1000, kFaulted, true}, {1001, 0, 0, false},
                        {0, 1001, 0, false},           {-1001, 0, 0, false},
                        {0, -1001, 0, false},          {0, 0, kFaulted + 1, false}};
  int sequence = 0;
  std::uint64_t refused = 0;
  for (const Case& each : cases) {
    wire::Sample sample{};
    sample.sequence = static_cast<std::uint16_t>(++sequence);
    sample.left_duty = static_cast<std::int16_t>(each.left_duty);
    sample.right_duty = static_cast<std::int16_t>(each.right_duty);
    sample.state = static_cast<std::uint8_t>(each.state);
    EXPECT_EQ(push(sample, sequence * 5000), each.good) << sequence;
    refused += each.good ? 0 : 1;
    EXPECT_EQ(counters_.implausible, refused) << sequence;
  }
  EXPECT_FALSE(push_at(sequence + 1, 1000)) << "the robot's time goes back";
  wire::Sample next{};
  next.sequence = 1000;
  EXPECT_FALSE(push(next, 50'000, -50 * kNsPerMs - 1)) << "it was not measured yet";
  EXPECT_EQ(counters_.implausible, refused + 2);
  EXPECT_TRUE(push(next, 50'000, -50 * kNsPerMs));
}

// Computed anew from the set of all numbers that came: whatever is lost, repeated or reordered,
// each number is in one counter.
TEST_F(Intake, EachNumberIsHandedOnLostRepeatedOrLate) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    test::Sequence random(seed);
    counters_ = {};
    intake_.begin(true);
    const int first = 65'000 + static_cast<int>(seed);
    int newest = first;
    std::set<int> seen{first};
    std::uint64_t lost = 0, duplicated = 0, reordered = 0, handed_on = 0, gap = 0;
    ASSERT_TRUE(push_at(first, 0));
    for (int i = 0; i < 2000; ++i) {
      const int number = newest + (random.chance(0.05)   ? random.below(80)
                                   : random.chance(0.25) ? -random.below(70)
                                                         : 1 + random.below(2));
      const bool ahead = number > newest;
      ASSERT_EQ(push_at(number, (number - first) * DeviceUs{5000}), ahead) << number;
      if (ahead) {
        lost += static_cast<std::uint64_t>(number - newest - 1);
        newest = number;
      } else if (number < first || (seen.contains(number) && newest - number < 64)) {
        // What was sent before the first one was never waited for.
        (newest - number < 64 ? duplicated : reordered) += 1;
      } else {
        ++reordered;
        if (newest - number < 64 && lost > 0) --lost;
      }
      seen.insert(number);
      if (random.chance(0.3)) {
        for (const Sample& taken : intake_.take()) {
          ++handed_on;
          gap += taken.lost_before;
        }
      }
      ASSERT_EQ(counters_.lost, lost) << i;
      ASSERT_EQ(counters_.duplicated, duplicated) << i;
      ASSERT_EQ(counters_.reordered, reordered) << i;
    }
    for (const Sample& taken : intake_.take()) {
      ++handed_on;
      gap += taken.lost_before;
    }
    EXPECT_EQ(counters_.samples, handed_on);
    EXPECT_EQ(handed_on + gap, static_cast<std::uint64_t>(newest - first + 1))
        << "consumers are told of each gap";
  }
}

using SampleLoss = Intake;

TEST_F(SampleLoss, WhatNobodyTakesIsBoundedAndCountsAsLost) {
  constexpr int kMore = 26;
  for (int i = 0; i < static_cast<int>(SampleIntake::kCapacity) + kMore; ++i)
    push_at(2 * i, i * DeviceUs{10'000});  // every second one is lost on its way
  const auto taken = intake_.take();
  ASSERT_EQ(taken.size(), SampleIntake::kCapacity);
  EXPECT_EQ(taken[0].sequence, 2 * kMore);
  EXPECT_EQ(taken[0].lost_before, 2U * kMore);
  EXPECT_EQ(taken[1].lost_before, 1U);
  EXPECT_EQ(counters_.lost, SampleIntake::kCapacity - 1 + 2U * kMore);
  EXPECT_TRUE(intake_.empty());
}

TEST_F(Intake, BeforeTheClockIsKnownSamplesAreCountedAndNotHandedOn) {
  clock_.valid = false;
  for (const int sequence : {1, 2, 5}) EXPECT_TRUE(push_at(sequence, sequence * 5000));
  EXPECT_TRUE(intake_.empty());
  EXPECT_EQ(counters_.early, 3U);
  clock_.valid = true;
  EXPECT_TRUE(push_at(6, 30'000));
  EXPECT_EQ(intake_.take()[0].lost_before, 0U) << "the gap was before its first sample";
}

TEST_F(Intake, AJumpOfEitherTrackIsCountedAndTheLimitIsEachTracks) {
  for (const bool left : {true, false}) {
    intake_.begin(true);
    intake_.set_limit(1000.0);  // 5 and 4 counts in a sample
    wire::Sample sample{};
    push(sample, 0);
    sample.sequence = 1;
    (left ? sample.left_counts : sample.right_counts) = 10;
    const std::uint64_t before = counters_.implausible;
    EXPECT_TRUE(push(sample, 5000)) << "its other values are good";
    EXPECT_EQ(counters_.implausible - before, 1U) << left;
    const auto taken = intake_.take();
    EXPECT_EQ(taken.back().left_counts, 0);
    EXPECT_EQ(taken.back().right_counts, 0);
  }
}

TEST_F(Intake, AStreamIsNonsenseAfterFortyRefusalsWithoutAGoodSample) {
  wire::Sample bad{};
  bad.state = 99;
  for (const bool interrupted : {true, false}) {
    intake_.begin(false);
    push_at(1, 0);
    for (int i = 1; i < SampleIntake::kNonsense; ++i) i % 2 == 0 ? push(bad, 0) : push_at(1, 0);
    EXPECT_FALSE(intake_.nonsense());
    if (interrupted) push_at(2, 5000);
    push(bad, 0);
    EXPECT_EQ(intake_.nonsense(), !interrupted);
  }
  intake_.begin(false);
  EXPECT_FALSE(intake_.nonsense()) << "a new session begins anew";
}

}  // namespace
}  // namespace tp100::link
