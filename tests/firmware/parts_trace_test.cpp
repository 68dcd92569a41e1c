// Golden traces of the parts around the loops: fail-safe, command gate, sensors, link, fake robot.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "../support/wire_host.h"
#include "firmware/battery.h"
#include "firmware/command_gate.h"
#include "firmware/fail_safe.h"
#include "firmware/fake_robot.h"
#include "firmware/host_link.h"
#include "firmware/imu.h"
#include "firmware/parameters.h"
#include "firmware/quadrature.h"
#include "scripted_hal.h"
#include "support/golden_trace.h"
#include "trace_inputs.h"

namespace tp100::firmware {
namespace {

using test::GoldenTrace;

TEST(GoldenFailSafe, SwitchesOffAsRecorded) {
  GoldenTrace trace{
      "firmware/fail_safe.csv",
      {"ms", "enabled", "left", "right", "ticks", "trip", "trip_ago_us", "silence_ms"}};
  ScriptedHal hal;
  hal.now_us = 0xFFF00000U;
  FailSafe fail_safe(hal);
  for (int ms = 0; ms < 6000; ++ms) {
    hal.now_us += 1000 + static_cast<std::uint32_t>(ms % 3);
    const int at = ms % 2000;
    const int third = ms / 2000;
    if (at == 10) fail_safe.watch(hal.now_us);
    const bool silent = (at > 300 && at < 570) || (at > 900 && at < 1000) || at > 1850;
    if (at >= 20 + 640 * third && !silent && ms % 5 == 0)
      fail_safe.fresh(hal.now_us - 100, 60'000U + 35'000U * static_cast<unsigned>(third));
    bool did = false;
    if (at % 250 == 240) did = fail_safe.enable();
    if (at == 1300) fail_safe.disable();
    if (at == 1400) fail_safe.unwatch();
    if (at == 1700) fail_safe.watch(hal.now_us);
    const bool hangs = at > 1500 && at < 1580 + 30 * third;
    if (!hangs) fail_safe.beat();
    if (!hangs) fail_safe.drive(static_cast<std::int16_t>(at), static_cast<std::int16_t>(-ms));
    fail_safe.tick();
    Trip trip{};
    if (!hangs && ms % 4 == 3) trip = fail_safe.take_trip();
    if (ms % 20 != 0 && trip.faults == 0 && !did) continue;
    trace.row({1.0 * ms, fail_safe.enabled() ? 1.0 : 0.0, 1.0 * hal.duties.left,
               1.0 * hal.duties.right, 1.0 * fail_safe.ticks(), 1.0 * trip.faults,
               trip.faults != 0 ? 1.0 * (hal.now_us - trip.at_us) : 0.0,
               trip.faults != 0 ? 1.0 * trip.silence_ms : 0.0});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenFailSafe, TripsAsRecordedIfTheMainLoopNeverRuns) {
  GoldenTrace trace{"firmware/fail_safe_alone.csv",
                    {"ms", "trip", "silence_ms", "enabled", "ticks", "left"}};
  ScriptedHal hal;
  FailSafe fail_safe(hal);
  hal.duties = {700, 800};
  for (int ms = 0; ms < 1400; ++ms) {
    const Trip trip = fail_safe.take_trip();
    if (trip.faults != 0 || ms < 4)
      trace.row({1.0 * ms, 1.0 * trip.faults, 1.0 * trip.silence_ms, fail_safe.enable() ? 1.0 : 0.0,
                 1.0 * fail_safe.ticks(), 1.0 * hal.duties.left});
    if (ms == 120) fail_safe.watch(hal.now_us);
    fail_safe.drive(3, 4);
    hal.now_us += 1000;
    fail_safe.tick();
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenCommandGate, JudgesAsRecorded) {
  GoldenTrace trace{"firmware/command_gate.csv",
                    {"case", "verdict", "fresh", "life_us", "last", "speed", "answered_ago_us",
                     "answered_gyro", "fresh_ms"}};
  wire::Parameters p = test::good_parameters();
  p.command_life_ms = 110;
  p.yaw_window_ms = 90;
  CommandGate gate;
  TurnHistory history;
  std::uint32_t us = 0xFFFD0000U;
  int number = 0;
  std::uint16_t sequence = 65'520;
  std::uint16_t sample = 65'530;
  const auto judge = [&](auto change) {
    us += 5000;
    ++sample;
    history.add(sample, us, static_cast<std::int16_t>(number * 17), number * 3, -number * 5);
    wire::Command c{};
    c.boot_nonce = 77;
    c.sequence = ++sequence;
    c.answers = static_cast<std::uint16_t>(sample - 2);
    c.speed_mps = static_cast<float>(number % 90) * 0.01f;
    c.expiry_us = us + 130'000;
    change(c);
    const std::uint32_t now_us = us + 300;
    const bool before = gate.fresh(now_us);
    const Verdict verdict = gate.judge(c, now_us, history, p);
    const bool after = gate.fresh(now_us);
    int fresh_ms = 0;
    CommandGate copy = gate;
    while (copy.fresh(now_us + 500 + 1000 * static_cast<unsigned>(fresh_ms))) ++fresh_ms;
    trace.row({1.0 * ++number, 1.0 * static_cast<int>(verdict),
               (before ? 1.0 : 0) + (after ? 2 : 0), 1.0 * gate.life_us(),
               1.0 * gate.last_sequence(), static_cast<double>(gate.current().speed_mps),
               1.0 * static_cast<std::int32_t>(now_us - gate.answered().device_us),
               1.0 * static_cast<std::int32_t>(gate.answered().gyro), 1.0 * fresh_ms});
  };
  using Command = wire::Command;
  judge([](Command&) {});
  gate.open(77);
  for (int i = 0; i < 30; ++i) judge([](Command&) {});
  judge([](Command& c) { ++c.boot_nonce; });
  for (const int back : {1, 2, 40, 32'767, -5, -32'000}) {
    judge([&](Command& c) { c.sequence = static_cast<std::uint16_t>(sequence - back); });
    gate.open(77);
    judge([](Command&) {});
  }
  constexpr float Command::*kFields[] = {&Command::x_m,
                                         &Command::y_m,
                                         &Command::yaw_rad,
                                         &Command::desired_yaw_rad,
                                         &Command::yaw_rate_radps,
                                         &Command::speed_mps,
                                         &Command::gyro_bias_radps};
  for (const auto field : kFields) {
    for (const float value :
         {0.5f, 1.0f, 1.01f, 2.0f, 2.02f, 10.0f, 10.1f, 1e3f, 1.01e3f, 1e4f, 1.01e4f}) {
      judge([&](Command& c) { c.*field = value; });
      judge([&](Command& c) { c.*field = -value; });
    }
    judge([&](Command& c) { c.*field = kNan; });
  }
  for (const int ahead_us : {-70'000, -1, 0, 1, 2, 5'300, 90'000, 109'999, 110'000, 110'001,
                             199'999, 200'000, 200'001, 200'002, 900'000}) {
    judge([&](Command& c) { c.expiry_us = us + 300 + static_cast<std::uint32_t>(ahead_us); });
  }
  for (int back = -2; back < 70; ++back) {
    judge([&](Command& c) { c.answers = static_cast<std::uint16_t>(sample - back); });
  }
  us += 300'000;
  judge([](Command&) {});
  gate.open(78);
  judge([](Command&) {});
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenImu, SurvivesFailuresAsRecorded) {
  GoldenTrace trace{"firmware/imu.csv",
                    {"sample", "accel_x", "accel_y", "accel_z", "temperature", "gyro_x", "gyro_y",
                     "gyro_z", "age", "missing", "stale", "fresh", "errors", "calls", "recoveries",
                     "other_age", "other_errors", "other_calls", "clock"}};
  // Never answers, answers later; fails for a growing number of reads; freezes.
  ScriptedHal hal;
  hal.imu_answers = false;
  Imu imu(hal);
  ScriptedHal other_hal;
  Imu not_started(other_hal);
  const auto row = [&](int i) {
    const ImuValues& v = imu.values();
    trace.row({1.0 * i, 1.0 * v.accel[0], 1.0 * v.accel[1], 1.0 * v.accel[2], 1.0 * v.temperature,
               1.0 * v.gyro[0], 1.0 * v.gyro[1], 1.0 * v.gyro[2], 1.0 * imu.age(),
               imu.missing() ? 1.0 : 0.0, imu.stale() ? 1.0 : 0.0, imu.fresh() ? 1.0 : 0.0,
               1.0 * imu.errors(), 1.0 * hal.i2c_calls, 1.0 * hal.recoveries,
               1.0 * not_started.age(), 1.0 * not_started.errors(), 1.0 * other_hal.i2c_calls,
               1.0 * hal.reg(0x6B)});
  };
  row(-2);
  imu.start();
  row(-1);
  int length = 1;
  for (int i = 0; i < 1400; ++i) {
    hal.accel_x = static_cast<std::int16_t>(i * 11);
    hal.gyro_z = static_cast<std::int16_t>(-i * 7);
    hal.accel_y = static_cast<std::int16_t>(300 - i);
    hal.gyro_x = static_cast<std::int16_t>(i * 3 - 500);
    hal.gyro_y = static_cast<std::int16_t>(200 - 2 * i);
    hal.temperature = static_cast<std::int16_t>(i - 3300);
    if (i > 150 && i < 700 && i % 40 == 0) ++length;
    hal.imu_answers = i > 63 && (i < 150 || i >= 700 || i % 40 >= length) && (i < 1060 || i > 1380);
    hal.imu_frozen = i > 800 && i < 900;
    imu.update();
    other_hal.imu_answers = i / 3 * 37 % 11 < 4;
    not_started.update();
    if (i < 140 || i % 4 == 3 || (i > 800 && i < 830)) row(i);
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenParameters, AreRefusedAsRecorded) {
  GoldenTrace trace{"firmware/parameters.csv", {"field", "value", "bad_field"}};
  using wire::Parameters;
  int number = 0;
  const auto judge = [&](auto field, double value) {
    Parameters p = uneven_parameters();
    p.*field = static_cast<std::remove_reference_t<decltype(p.*field)>>(value);
    trace.row({1.0 * number, value, 1.0 * bad_field(p)});
  };
  constexpr float Parameters::*kFloats[] = {
      &Parameters::counts_per_metre,  &Parameters::wheelbase_m,
      &Parameters::wheelbase_tight_m, &Parameters::wheelbase_spin_m,
      &Parameters::turn_slip_share,   &Parameters::slip_left,
      &Parameters::slip_right,        &Parameters::max_track_mps,
      &Parameters::max_track_mps2,    &Parameters::feed_forward,
      &Parameters::dead_band,         &Parameters::speed_kp,
      &Parameters::speed_ki,          &Parameters::yaw_kp,
      &Parameters::max_yaw_radps,     &Parameters::gyro_z_radps_per_lsb};
  for (const auto field : kFloats) {
    ++number;
    for (const double bound :
         {0.0, 1e-5, 1e-2, 0.05, 0.5, 0.9, 1.0, 2.0, 10.0, 20.0, 50.0, 100.0, 1000.0, 1e6}) {
      for (const double sign : {1.0, -1.0}) {
        if (sign < 0.0 && bound > 1.0) continue;
        for (const double beside : {-0.01, 0.01}) judge(field, sign * bound * (1.0 + beside));
        if (bound == 0.0) judge(field, sign * 1e-7);
      }
    }
  }
  constexpr std::uint16_t Parameters::*kIntegers[] = {
      &Parameters::battery_cutoff_mv, &Parameters::stall_duty, &Parameters::stall_ms,
      &Parameters::command_life_ms, &Parameters::yaw_window_ms};
  for (const auto field : kIntegers) {
    ++number;
    for (const int bound : {1, 20, 50, 200, 1000, 10'000})
      for (const int value : {bound - 1, bound, bound + 1}) judge(field, value);
  }
  ++number;
  for (int flags = 0; flags < 256; flags += 5) judge(&Parameters::flags, flags);
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenBattery, FiltersAndCutsOffAsRecorded) {
  GoldenTrace trace{
      "firmware/battery.csv",
      {"sample", "mv", "below", "low", "supply_mv", "by_supply_mv", "always_low", "always_below"}};
  Battery battery;
  Battery always_low;
  Supply supply;
  for (int i = 0; i < 2400; ++i) {
    battery.update(
        static_cast<std::uint16_t>(6700.0 + 900.0 * zigzag(i, 1900) + 90.0 * zigzag(i, 21)),
        i < 1700   ? 6400
        : i < 2100 ? 0
                   : 6111);
    always_low.update(5000, 6400);
    if (i % 9 == 8)
      supply.update(static_cast<std::uint16_t>(i % 450 == 8 ? 0 : 236 + 23.0 * zigzag(i, 800)));
    if (i % 5 != 0 && (i < 190 || i > 210)) continue;
    trace.row({1.0 * i, 1.0 * battery.millivolts(), battery.below() ? 1.0 : 0.0,
               battery.low() ? 1.0 : 0.0, 1.0 * supply.millivolts(),
               1.0 * supply.battery_mv(static_cast<std::uint16_t>(400 + i % 250)),
               always_low.low() ? 1.0 : 0.0, always_low.below() ? 1.0 : 0.0});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenFakeRobot, MovesAndMeasuresAsRecorded) {
  GoldenTrace trace{"firmware/fake_robot.csv",
                    {"ms", "left", "right", "mv", "accel_x", "accel_y", "accel_z", "temperature",
                     "gyro_x", "gyro_y", "gyro_z"}};
  FakeRobot robot;
  const auto row = [&](int ms, int unread) {
    std::array<std::uint8_t, Imu::kMeasuredBytes> bytes{};
    for (int i = 0; i <= unread; ++i)
      robot.imu_read(Imu::kAddress, Imu::kAccelXHigh, bytes.data(), Imu::kMeasuredBytes);
    std::vector<double> values{1.0 * ms, 1.0 * robot.left_counts(), 1.0 * robot.right_counts(),
                               1.0 * robot.battery_mv()};
    for (std::size_t i = 0; i < bytes.size(); i += 2)
      values.push_back(static_cast<std::int16_t>(bytes[i] << 8 | bytes[i + 1]));
    trace.row(values);
  };
  row(0, 0);
  for (int ms = 1; ms <= 9000; ++ms) {
    double left = 400.0 * zigzag(ms, 2100);
    double right = 700.0 * zigzag(ms, 1300);
    if (ms % 3000 > 2500) left = right = 0.0;
    if (ms > 6000) left = 85.0 + 8.0 * zigzag(ms, 1100), right = -left;
    robot.step(static_cast<std::int16_t>(left), static_cast<std::int16_t>(right));
    if (ms % 25 == 0 || (ms > 2500 && ms < 2530)) row(ms, ms % 3 == 0 ? 1 : 0);
  }
  for (int ms = 0; ms < 1500; ++ms) robot.step(300, 350);
  row(10'500, 0);
  for (int ms = 0; ms < 30; ++ms) robot.step(-300, 350);
  row(10'530, 0);
  robot = FakeRobot();
  for (int ms = 0; ms < 7; ++ms) robot.step(800, 640);
  row(7, 0);
  std::array<std::uint8_t, Imu::kMeasuredBytes> bytes;
  for (const int reg : {0x3A, 0x3B, 0x3C, 0x75, 0x76}) {
    for (const int size : {1, 2, 13, 14}) {
      bytes.fill(0x55);
      const bool good = robot.imu_read(Imu::kAddress, static_cast<std::uint8_t>(reg), bytes.data(),
                                       static_cast<std::uint8_t>(size));
      trace.row({1.0 * reg, 1.0 * size, good ? 1.0 : 0.0, 1.0 * bytes[0], 1.0 * bytes[1],
                 1.0 * bytes[11], 1.0 * bytes[12], 1.0 * bytes[13], 0.0, 0.0, 0.0});
    }
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenQuadrature, CountsAsRecorded) {
  GoldenTrace trace{"firmware/quadrature.csv",
                    {"edge", "forward", "backward", "missed", "missed_too"}};
  Quadrature forward{}, backward{};
  constexpr std::uint8_t kPhases[] = {0, 1, 3, 2};
  for (int i = 0; i < 4000; ++i) {
    int at = i % 1500 < 1100 ? i : -i;
    if (i % 37 == 0) ++at;
    const std::uint8_t phase = kPhases[(at % 4 + 4) % 4];
    take_edge<1>(forward, phase);
    take_edge<-1>(backward, phase);
    if (i == 2000) backward.missed = 65'530;
    if (i % 20 != 7) continue;
    trace.row({1.0 * i, 1.0 * extended_counts(forward), 1.0 * extended_counts(backward),
               1.0 * forward.missed, 1.0 * backward.missed});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
