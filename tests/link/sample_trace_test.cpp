// Golden traces of encoder counts and of the samples that are made of the robot's frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "link/sample_intake.h"
#include "support/golden_trace.h"

namespace tp100::link {
namespace {

TEST(SampleTrace, CountsOfATrackWithJumpsOfEverySizeAndGap) {
  test::GoldenTrace trace("link/encoder_counts.csv", {"taken", "counts", "behind"});
  EncoderCount track(6000.0);
  std::int32_t board = 2'147'480'000;
  std::int64_t sum = board;
  const auto step = [&](std::int32_t counts, double dt_s) {
    board = static_cast<std::int32_t>(static_cast<std::uint32_t>(board) +
                                      static_cast<std::uint32_t>(counts));
    sum += counts;
    const bool taken = track.update(board, dt_s);
    trace.row({static_cast<double>(taken), static_cast<double>(track.counts() - 2'147'480'000),
               static_cast<double>(sum - track.counts())});
  };
  track.update(board, 0.0);
  // Around the limit, forwards and backwards, a second apart.
  for (int counts = 30; counts <= 37; ++counts) {
    step(counts, 0.005);
    step(11, 0.6);
    step(-counts, 0.005);
    step(-9, 0.55);
  }
  // Two jumps, ever further apart.
  for (int apart = 1; apart <= 24; ++apart) {
    for (int i = 0; i < 4; ++i) step(7 + i, 0.25);
    step(100, 0.005);
    for (int i = 1; i < apart; ++i) step(9, 0.005);
    step(-90, 0.005);
  }
  for (int apart = 8; apart <= 12; ++apart) {
    for (int i = 0; i < 4; ++i) step(6, 0.25);
    step(-800, 0.1);
    for (int i = 1; i < apart; ++i) step(5, 0.1);
    step(700, 0.1);
  }
  // Jumps after gaps around the longest one over which the track goes on.
  for (int i = 0; i < 12; ++i) {
    step(20, 0.8);
    step(13, 0.01);
    step(14, 0.5);
    step(8000 + i, 0.0951 + 0.001 * i);
    step(12, 1.3);
  }
  // A jump that lasts, times that do not pass or go back, and a track without a limit.
  for (int i = 0; i < 25; ++i) step(60 + i, 0.005);
  step(5000, 0.0);
  step(4, 0.005);
  step(90, -0.005);
  step(200, 0.005);
  track.set_limit(9000.0);
  for (int counts = 44; counts <= 53; ++counts) {
    step(counts, 0.005);
    step(3, 1.1);
  }
  track.set_limit(0.0);
  step(60'000, 0.005);
  track.forget();
  step(70'000, 0.005);
  EXPECT_EQ(trace.difference(), "");
}

class IntakeTrace : public ::testing::Test {
 protected:
  IntakeTrace() {
    clock_.valid = true;
    clock_.reference_host_ns = 40 * kNsPerS;
    clock_.reference_us = 9'000'000;
    clock_.drift = 150e-6;
  }

  static wire::Sample sample(int i) {
    const auto wave = [i](double size, double period, double phase) {
      return size * std::sin(i / period + phase);
    };
    wire::Sample out{};
    out.left_counts = i * 40 + static_cast<int>(wave(30, 7, 1));
    out.right_counts = 500 - i * 35;
    for (int axis = 0; axis < 3; ++axis) {
      out.gyro[axis] = static_cast<std::int16_t>(wave(9000, 5 + axis, axis));
      out.accel[axis] = static_cast<std::int16_t>(wave(12'000, 9 - axis, 2 * axis));
    }
    out.temperature = static_cast<std::int16_t>(wave(5000, 11, 0.3));
    out.battery_mv = static_cast<std::uint16_t>(7000 + i);
    out.left_duty = static_cast<std::int16_t>(wave(1000, 13, 0.5));
    out.right_duty = static_cast<std::int16_t>(wave(-900, 8, 0.1));
    out.state = static_cast<std::uint8_t>(i % 6);
    out.faults = static_cast<std::uint16_t>(i * 37);
    out.last_command = static_cast<std::uint16_t>(i * 77);
    out.imu_age = static_cast<std::uint8_t>(i * 5);
    return out;
  }

  bool push(const wire::Sample& sample, DeviceUs device_us, HostNs after_ns = 3 * kNsPerMs) {
    return intake_.push(sample, device_us, clock_, clock_.to_host(device_us) + after_ns);
  }

  LinkCounters counters_{};
  SampleIntake intake_{counters_, 10'000.0};
  ClockState clock_;
};

TEST_F(IntakeTrace, EveryValueOfASample) {
  test::GoldenTrace trace(
      "link/samples.csv",
      {"sequence", "lost",  "device_us", "measured_us", "left",  "right", "gx",    "gy",
       "gz",       "ax",    "ay",        "az",          "degc",  "v",     "dl",    "dr",
       "state",    "fault", "command",   "age",         "lost+", "early", "taken", "implausible"});
  intake_.begin(true);
  for (int i = 0; i < 160; ++i) {
    if (i == 90) intake_.begin(false);
    if (i == 120) intake_.begin(true);
    clock_.valid = i % 40 > 3;
    wire::Sample sample = this->sample(i);
    sample.sequence = static_cast<std::uint16_t>(65'480 + i + i / 7);
    if (i % 19 == 18) sample.left_counts += 700;
    if (i % 23 == 22) sample.right_counts -= 900;
    push(sample, 9'000'000 + 5000 * i);
    if (i % 3 == 1) continue;
    for (const Sample& s : intake_.take())
      trace.row({s.sequence * 1.0,
                 s.lost_before * 1.0,
                 static_cast<double>(s.device_us - 9'000'000),
                 static_cast<double>(s.measured_ns - 40 * kNsPerS) * 1e-3,
                 static_cast<double>(s.left_counts),
                 static_cast<double>(s.right_counts),
                 s.gyro_radps[0],
                 s.gyro_radps[1],
                 s.gyro_radps[2],
                 s.accel_mps2[0],
                 s.accel_mps2[1],
                 s.accel_mps2[2],
                 s.temperature_degc,
                 s.battery_v,
                 s.left_duty,
                 s.right_duty,
                 static_cast<double>(s.state),
                 static_cast<double>(s.faults),
                 s.last_command * 1.0,
                 s.imu_age * 1.0,
                 static_cast<double>(counters_.lost),
                 static_cast<double>(counters_.early),
                 static_cast<double>(counters_.samples),
                 static_cast<double>(counters_.implausible)});
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST_F(IntakeTrace, ANewSessionIsNotNonsenseFromTheBeginning) {
  wire::Sample bad{};
  bad.state = 99;
  for (int i = 0; i < SampleIntake::kNonsense - 1; ++i) push(bad, 9'000'000);
  EXPECT_FALSE(intake_.nonsense());
  intake_.begin(false);
  push(bad, 9'000'000);
  EXPECT_FALSE(intake_.nonsense());
}

TEST_F(IntakeTrace, AnotherLimitIsThatOfEachTrack) {
  for (const bool left : {true, false}) {
    intake_.begin(true);
    intake_.set_limit(1000.0);
    wire::Sample sample{};
    push(sample, 9'000'000);
    sample.sequence = 1;
    (left ? sample.left_counts : sample.right_counts) = 10;
    const std::uint64_t before = counters_.implausible;
    push(sample, 9'005'000);
    EXPECT_EQ(counters_.implausible - before, 1U) << left;
  }
}

TEST_F(IntakeTrace, OrderOfSamplesThatAreLateRepeatedAndImpossible) {
  test::GoldenTrace trace("link/sample_order.csv",
                          {"pushed", "waiting", "nonsense", "lost", "duplicated", "reordered",
                           "implausible", "early", "samples", "gap"});
  intake_.begin(true);
  int next = 65'300;
  const auto push_row = [&](int sequence, DeviceUs device_us, HostNs after_ns = 3 * kNsPerMs,
                            int duty = 0, int state = 2) {
    wire::Sample sample{};
    sample.sequence = static_cast<std::uint16_t>(sequence);
    sample.left_duty = static_cast<std::int16_t>(duty);
    sample.right_duty = static_cast<std::int16_t>(-duty / 2);
    sample.state = static_cast<std::uint8_t>(state);
    const bool pushed = push(sample, device_us, after_ns);
    double gap = 0.0;
    const bool waiting = !intake_.empty();
    if (sequence % 5 == 0)
      for (const Sample& taken : intake_.take()) gap += taken.lost_before;
    trace.row({static_cast<double>(pushed), static_cast<double>(waiting),
               static_cast<double>(intake_.nonsense()), static_cast<double>(counters_.lost),
               static_cast<double>(counters_.duplicated), static_cast<double>(counters_.reordered),
               static_cast<double>(counters_.implausible), static_cast<double>(counters_.early),
               static_cast<double>(counters_.samples), gap});
  };
  DeviceUs device_us = 9'000'000;
  const auto good = [&](int ahead) { push_row(next += ahead, device_us += 5000 * ahead); };
  const auto old = [&](int back) { push_row(next - back, device_us - 5000 * back); };
  good(1);
  for (const int back : {0, 1, 2, 63, 64, 65}) old(back);
  for (int ahead = 1; ahead <= 9; ++ahead) {
    good(ahead);
    for (int back = 0; back <= ahead + 1; ++back) old(back);
    old(ahead / 2);
  }
  for (const int ahead : {62, 63, 64, 65, 70}) {
    good(ahead);
    for (const int back : {1, 61, 62, 63, 64, 65, 66}) old(back);
    good(1);
    for (const int back : {1, 2, 62, 63, 64}) old(back);
  }
  // Device times that stand still or go back, times from the future, impossible values.
  for (const DeviceUs by : {-5000, -1, 0, 1, 2}) push_row(++next, device_us + by);
  device_us += 5000;
  for (const HostNs ahead_ms : {-60, -51, -50, -49, -10, 20, 60})
    push_row(++next, device_us += 5000, ahead_ms * kNsPerMs + 5 * kNsPerUs);
  for (const int duty : {999, 1000, 1001, -1000, -1001, 2001, 2002})
    push_row(++next, device_us += 5000, kNsPerMs, duty);
  for (const int state : {0, 4, 5, 6, 255}) push_row(++next, device_us += 5000, kNsPerMs, 1, state);
  // What makes no sense again and again, almost often enough, and interrupted.
  for (int i = 0; i < 39; ++i) push_row(next, device_us);
  good(1);
  for (int i = 0; i < 42; ++i) push_row(next + 1, device_us + 5000, kNsPerMs, 1234);
  intake_.begin(false);
  good(40'000);
  old(3);
  // More than has room.
  next += 1 - next % 5;
  device_us += 100'000;
  for (int i = 0; i < 90; ++i) {
    wire::Sample sample{};
    sample.sequence = static_cast<std::uint16_t>(next += 1 + (i % 3 == 0));
    push(sample, device_us += 5000);
  }
  double gaps = 0.0;
  for (const Sample& taken : intake_.take()) {
    gaps = gaps * 0.9 + taken.lost_before;
    trace.row({1, 0, static_cast<double>(taken.sequence), static_cast<double>(counters_.lost), 0, 0,
               0, 0, static_cast<double>(counters_.samples), gaps});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::link
