// Golden traces of the loops of speed and yaw, and of the tracks with all their monitors.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../support/wire_host.h"
#include "firmware/number.h"
#include "firmware/parameters.h"
#include "firmware/tracks.h"
#include "scripted_hal.h"
#include "support/golden_trace.h"
#include "trace_inputs.h"

namespace tp100::firmware {
namespace {

using test::GoldenTrace;

TEST(GoldenSpeedLoop, FollowsAsRecorded) {
  GoldenTrace trace{"firmware/speed_loop.csv", {"target", "speed", "lag", "duty", "pushed_duty"}};
  // Another track is only pushed, from the start.
  SpeedLoop loop, pushed;
  wire::Parameters p = uneven_parameters();
  double counts = 2147483600.0;  // wraps soon
  double mps = 0.0;
  for (int i = 0; i < 1450; ++i) {
    double target = 0.0;
    if (i < 300) {
      target = 0.17 * zigzag(i, 200);
    } else if (i < 450) {
      target = 0.0004 + 0.0002 * zigzag(i, 50);
    } else if (i < 520) {
      target = i % 35 < 28 ? 0.0 : -0.0007;
    } else if (i < 700) {
      target = i < 620 ? 0.2 : 0.02;
    } else if (i < 900) {
      target = i < 800 ? -0.2 : -0.02;
    } else if (i < 1100) {
      target = 0.008 * zigzag(i, 90);
    } else if (i < 1300) {
      target = -0.1 * zigzag(i, 150);
    }
    const bool held = (i > 540 && i < 650) || (i > 720 && i < 840) || (i > 1020 && i < 1040);
    mps += held ? -mps : (target * 0.93 - mps) * 0.09;
    const int dt_us = 3500 + i * 37 % 2600;
    counts += mps * dt_us * 1e-6 * 11140.0;
    if (i > 1370 && i < 1378) counts += 3.0;
    if (i == 500) p.speed_kp = 0.7f;
    if (i == 620) p.speed_ki = 90.0f;
    if (i == 700) p.feed_forward = 6.5f;
    if (i == 1000) p.counts_per_metre = 9000.0f;
    if (i == 1100) {
      loop.restart();
      counts += 5000.0;
    }
    if (i == 1150 || i == 1370) loop.reset();
    const auto whole = static_cast<std::int64_t>(std::floor(counts));
    loop.measure(static_cast<std::int32_t>(static_cast<std::uint32_t>(whole)),
                 static_cast<std::uint16_t>(dt_us), p);
    const float duty =
        loop.update(static_cast<float>(target), static_cast<float>(dt_us) * 1e-6f, p);
    pushed.measure(i % 200 < 7 ? i * 2 : 0, 5000, p);
    const float pushed_duty = pushed.update(0.0f, 0.005f, p);
    if (i % 2 == 0 && i > 60) continue;
    trace.row({target, static_cast<double>(loop.speed_mps()), static_cast<double>(loop.lag_m()),
               static_cast<double>(duty), static_cast<double>(pushed_duty)});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenYawLoop, RemembersTurnsAsRecorded) {
  GoldenTrace trace{"firmware/turn_history.csv",
                    {"sequence", "gyro", "found", "oldest", "back_us", "by_gyro", "by_tracks"}};
  const wire::Parameters p = uneven_parameters();
  TurnHistory history;
  std::uint32_t us = 0xFFFF0000U;
  std::uint16_t sequence = 65'400;
  for (int i = 0; i < 330; ++i) {
    us += static_cast<std::uint32_t>(4900 + i * 61 % 203);
    if (i == 140) us += 200'000;
    if (i == 200) history.clear();
    ++sequence;
    history.add(sequence, us, static_cast<std::int16_t>(30'000.0 * zigzag(i, 170)),
                static_cast<std::int32_t>(i * 31 - 4000), static_cast<std::int32_t>(4000 - i * 17));
    int found = 0, oldest = -1;
    for (int back = -2; back < 80; ++back) {
      if (history.find(static_cast<std::uint16_t>(sequence - back)) == nullptr) continue;
      ++found;
      oldest = back;
    }
    const auto answers = static_cast<std::uint16_t>(sequence - i * 7 % (oldest + 1));
    const TurnMark* then = history.find(answers);
    ASSERT_NE(then, nullptr);
    trace.row({1.0 * sequence, 1.0 * static_cast<std::int32_t>(history.newest().gyro), 1.0 * found,
               1.0 * oldest, 1.0 * distance(us, then->device_us),
               static_cast<double>(turned(*then, history.newest(), true, 0.07f, p)),
               static_cast<double>(turned(*then, history.newest(), false, 0.07f, p))});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenYawLoop, TurnsWishesIntoTrackSpeedsAsRecorded) {
  GoldenTrace trace{"firmware/track_speeds.csv",
                    {"speed", "error", "rate", "left", "right", "near_left", "near_right"}};
  const wire::Parameters p = uneven_parameters();
  TrackSpeeds near = TrackSpeeds();
  for (int i = 0; i < 480; ++i) {
    const auto speed = static_cast<float>(0.3 * zigzag(i, 90));
    const auto error = static_cast<float>(9.5 * zigzag(i, 410) * zigzag(i, 57));
    const float rate = turn_rate(error, static_cast<float>(0.4 * zigzag(i, 71)), p);
    const float wide = i % 3 == 0 ? 2.5f : 1.0f;
    const TrackSpeeds speeds = track_speeds(speed, rate * wide, p);
    near = approach(near, speeds, 0.012f);
    trace.row({static_cast<double>(speed), static_cast<double>(error), static_cast<double>(rate),
               static_cast<double>(speeds.left), static_cast<double>(speeds.right),
               static_cast<double>(near.left), static_cast<double>(near.right)});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenNumbers, AreAsRecorded) {
  GoldenTrace trace{"firmware/numbers.csv",
                    {"value", "clamped", "wrapped", "within", "smaller", "larger", "distance"}};
  for (int i = -120; i <= 120; ++i) {
    const float value = static_cast<float>(i) * 0.25f;
    const float limit = static_cast<float>((i + 120) % 7);
    trace.row({static_cast<double>(value), static_cast<double>(clamp(value, limit)),
               static_cast<double>(wrap_angle(value * 1.3f)),
               within(value, -0.25f * limit, limit) ? 1.0 : 0.0,
               static_cast<double>(smaller(value, limit)),
               static_cast<double>(larger(value, limit)),
               1.0 * distance(static_cast<std::uint32_t>(i) * 40'000'000U,
                              static_cast<std::uint32_t>(i + 9) * 30'000'000U)});
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

// Two tracks on the floor, driven by Tracks alone.
class TracksRun {
 public:
  TracksRun(int number, GoldenTrace& trace) : number_(number), trace_(trace) {
    fail_safe.fresh(hal.now_us, 1'000'000'000);
    tracks.begin();
    fail_safe.enable();
  }

  struct Floor {
    double left_share = 1.0;  ///< speed of a track relative to what its duty implies
    double right_share = 1.0;
    double left_counted = 1.0;
    double right_counted = 1.0;
    double offset_radps = 0.0;
    int accel_x = 20;
  };

  void step(const TrackSpeeds& wanted, const Floor& floor, int i) {
    const int dt_us = 4700 + i * 29 % 601;
    hal.now_us += static_cast<std::uint32_t>(dt_us);
    follow(left_mps, left_m, tracks.left().duty, floor.left_share, floor.left_counted, dt_us);
    follow(right_mps, right_m, tracks.right().duty, floor.right_share, floor.right_counted, dt_us);
    hal.left_counts = static_cast<std::int32_t>(std::floor(left_m * 11140.0));
    hal.right_counts = static_cast<std::int32_t>(std::floor(right_m * 11140.0));
    const std::uint32_t now_us = tracks.read();
    tracks.measure(static_cast<std::uint16_t>(dt_us));
    count(tracks.check(static_cast<std::uint16_t>((dt_us + 500) / 1000)));
    turned_rad += ((right_mps * 0.91 - left_mps * 0.83) / 0.3 + floor.offset_radps) * dt_us * 1e-6;
    const auto lsb =
        static_cast<std::int64_t>(turned_rad / static_cast<double>(test::kGyroRadpsPerLsb) / 8e-6);
    const TurnMark mark{now_us, static_cast<std::uint32_t>(lsb), tracks.left().counts,
                        tracks.right().counts};
    count(tracks.check_turn(mark, static_cast<std::int16_t>(floor.accel_x), 0.0f));
    tracks.drive(wanted, static_cast<std::uint16_t>(dt_us));
  }
  void write() {
    trace_.row({1.0 * number_, 1.0 * tracks.left().counts, 1.0 * tracks.right().counts,
                1.0 * tracks.left().duty, 1.0 * tracks.right().duty, 1.0 * hal.duties.left,
                1.0 * hal.duties.right, 1.0 * left_verdicts, 1.0 * right_verdicts});
    left_verdicts = right_verdicts = 0;
  }

  int left_verdicts = 0;
  int right_verdicts = 0;
  ScriptedHal hal;
  FailSafe fail_safe{hal};
  wire::Parameters parameters = uneven_parameters();
  Tracks tracks{hal, fail_safe, parameters};

 private:
  void count(const Tracks::Verdicts& found) {
    constexpr int kWeights[] = {0, 1, 100};
    left_verdicts += kWeights[found.left];
    right_verdicts += kWeights[found.right];
  }
  static void follow(double& mps, double& m, int duty, double share, double counted, int dt_us) {
    const double size = std::max(0.0, std::abs(duty) / 1000.0 - 0.13) / 4.3;
    mps += (std::copysign(size * share, duty) - mps) * 0.07;
    m += mps * counted * dt_us * 1e-6;
  }

  int number_;
  GoldenTrace& trace_;
  double left_m = 0.3;
  double right_m = -0.4;
  double left_mps = 0.0;
  double right_mps = 0.0;
  double turned_rad = 0.0;
};

TEST(GoldenTracks, DriveAndFindFaultsAsRecorded) {
  GoldenTrace trace{"firmware/tracks.csv",
                    {"run", "left_counts", "right_counts", "left_duty", "right_duty", "left_motor",
                     "right_motor", "left_verdicts", "right_verdicts"}};
  // A drive with arcs on an uneven floor, then one hindrance after the other.
  for (int number = 0; number < 12; ++number) {
    TracksRun run(number, trace);
    constexpr int kWirings[] = {0, wire::kSwapTracks | wire::kInvertLeftMotor,
                                wire::kInvertLeftEncoder | wire::kInvertRightMotor,
                                wire::kInvertRightEncoder};
    // With a wrong wiring the robot runs away: only a few.
    if (number >= 8) run.parameters.flags = static_cast<std::uint8_t>(kWirings[number - 8]);
    const int steps = number == 0 ? 1500 : number >= 8 ? 150 : 800;
    for (int i = 0; i < steps; ++i) {
      const double mps = number % 2 == 0 ? 0.11 + 0.03 * zigzag(i, 330) : -0.12;
      const double turn = (number == 0 ? 0.04 : number == 3 ? 0.004 : 0.015) * zigzag(i, 270);
      TracksRun::Floor floor;
      floor.left_share = 1.0 + 0.1 * zigzag(i, 190);
      floor.right_share = 1.05 - 0.1 * zigzag(i, 310);
      const bool hindered = i > 250;
      if (hindered && number == 1) floor.left_share = 0.0;
      if (hindered && number == 2) floor.right_share = 0.1;
      if (hindered && number == 3) floor.left_share = floor.right_share = 0.3;
      if (hindered && number == 4) floor.left_counted = 0.4;
      if (hindered && number == 5) floor.right_counted = 0.4;
      if (hindered && number == 6) floor.offset_radps = 0.15;
      if (hindered && number == 7) floor.accel_x = 900, floor.left_share = 0.4;
      run.step({static_cast<float>(mps - turn), static_cast<float>(mps + turn)}, floor, i);
      if (i % 16 == 15) run.write();
      if (number == 0 && i == 900) run.tracks.forget_turn();
      if (number == 0 && i == 1100) run.tracks.restart();
      if (number == 0 && i == 1200) run.tracks.stop();
      if (number == 0 && i == 1250) run.tracks.begin(), run.fail_safe.enable();
    }
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenTracks, TakeAsLongAsRecordedToFindAFault) {
  GoldenTrace trace{
      "firmware/tracks_faults.csv",
      {"left_mps", "right_mps", "left_share", "right_share", "accel_x", "steps", "left", "right"}};
  constexpr double kShares[][2] = {{0.0, 0.0}, {0.0, 0.5}, {0.3, 0.3}, {0.5, 0.25},
                                   {0.2, 0.6}, {0.6, 0.6}, {1.0, 1.0}};
  constexpr double kSpeeds[][2] = {{0.1, 0.1},    {0.05, 0.11}, {-0.12, -0.07}, {-0.14, -0.13},
                                   {0.08, -0.06}, {0.16, 0.02}, {0.03, 0.03}};
  int number = 0;
  for (const auto& speeds : kSpeeds) {
    for (const auto& shares : kShares) {
      for (const int accel_x : {0, 700}) {
        TracksRun run(number++, trace);
        TracksRun::Floor floor;
        // A run on a slope, whose load the next one does not inherit.
        for (int i = 0; i < 60 && number % 3 == 0; ++i) {
          floor.accel_x = i < 10 ? 0 : 1200;
          run.step({0.05f, 0.09f}, floor, i);
          if (i < 59) continue;
          if (number % 2 == 0) {
            run.tracks.begin();
            run.fail_safe.enable();
          } else {
            run.tracks.forget_turn();
          }
        }
        floor.accel_x = 20;
        int i = 0;
        for (; i < 900 && run.left_verdicts + run.right_verdicts == 0; ++i) {
          if (i == 200) {
            floor.left_share = shares[0];
            floor.right_share = shares[1];
            floor.accel_x += accel_x;
          }
          run.step({static_cast<float>(speeds[0]), static_cast<float>(speeds[1])}, floor, i);
        }
        trace.row({speeds[0], speeds[1], shares[0], shares[1], 1.0 * accel_x, 1.0 * i,
                   1.0 * run.left_verdicts, 1.0 * run.right_verdicts});
      }
    }
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
