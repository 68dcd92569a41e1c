#pragma once
// The monitor of a run or drive whose sensor values the tests set.

#include <gtest/gtest.h>

#include <functional>

#include "control/monitor.h"

namespace tp100::control {

/// At rest, with healthy sensors.
class MonitoredRun : public testing::Test {
 protected:
  MonitoredRun() {
    sample_.imu_age = 0;
    sample_.accel_mps2 = {0.0, 0.0, 9.81};
    sample_.battery_v = 7.4;
    seen_.sample = &sample_;
    seen_.gyro_in_use = true;
    seen_.dt_s = 0.005;
  }
  FaultMask run(double duration_s) {
    FaultMask faults = 0;
    for (double t = 0; t < duration_s && faults == 0; t += seen_.dt_s) {
      faults = monitor_.update(seen_);
      lasted_s_ = t;
    }
    return faults;
  }

  Sample sample_{};
  Observation seen_{};
  double lasted_s_ = 0.0;
  Monitor monitor_{Parameters{},
                   course::Fence{-1.0, 1.0, -1.0, 1.0, {}, {{{0.5, 0.5}, {0.9, 0.5}, {0.5, 0.9}}}},
                   20.0, MonitoredRobot{.motor = {.dead_band = 0.09, .feed_forward = 3.4}}};
};

/// A robot that drives straight on at 0.06 m/s, with consistent sensor values.
class EncoderMonitorTest : public MonitoredRun {
 protected:
  EncoderMonitorTest() { drive(0.0714); }
  void drive(double track_mps) {
    seen_.left_mps = seen_.right_mps = seen_.commanded_left_mps = seen_.commanded_right_mps =
        track_mps;
    sample_.left_duty = sample_.right_duty = 0.08 + 3.1 * track_mps;
  }
  /// Runs healthy for a while, then applies `corrupt`; returns the time until a fault is detected,
  /// 0 if none is within `within_s`.
  double noticed_after(double within_s, FaultMask expected,
                       const std::function<void(Observation&, Sample&)>& corrupt) {
    EXPECT_EQ(run(3.0), 0u);
    corrupt(seen_, sample_);
    const FaultMask faults = run(within_s);
    if (faults == 0) return 0.0;
    EXPECT_EQ(faults, expected);
    return lasted_s_;
  }
};

inline constexpr FaultMask kDuty = fault_bit(Fault::encoders_against_duty);
inline constexpr FaultMask kTurn = fault_bit(Fault::gyro_against_encoders);

}  // namespace tp100::control
