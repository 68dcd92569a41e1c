#include "control/monitor.h"

#include <gtest/gtest.h>

#include <functional>

namespace tp100::control {
namespace {

struct Case {
  const char* name;
  Fault fault;
  double after_s;  ///< must not abort earlier than this
  std::function<void(Observation&, Sample&)> spoil;
};

class MonitorTest : public testing::TestWithParam<Case> {
 protected:
  MonitorTest() {
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
  Monitor monitor_{Parameters{}, course::Fence{-1.0, 1.0, -1.0, 1.0}, 20.0};
};

TEST_P(MonitorTest, AHealthyRunGoesOnAndTheSpoiltOneEndsWithItsOwnCause) {
  EXPECT_EQ(run(10.0), 0u);
  GetParam().spoil(seen_, sample_);
  EXPECT_EQ(run(10.0), fault_bit(GetParam().fault));
  EXPECT_GE(lasted_s_, GetParam().after_s - 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    EveryAbort, MonitorTest,
    testing::Values(Case{"CrossTrack", Fault::cross_track, 0.0,
                         [](Observation& o, Sample&) { o.target.off_path_m = 0.21; }},
                    Case{"Heading", Fault::heading, 0.5,
                         [](Observation& o, Sample&) { o.target.heading_error_rad = 1.2; }},
                    Case{"Tilt", Fault::tilt, 0.3,
                         [](Observation&, Sample& s) {
                           s.accel_mps2 = {9.0, 0.0, 3.0};
                         }},
                    Case{"Fence", Fault::fence, 0.0,
                         [](Observation& o, Sample&) { o.pose.y_m = 1.01; }},
                    Case{"TimeLimit", Fault::time_limit, 0.0,
                         [](Observation& o, Sample&) { o.elapsed_s = 60.1; }},
                    Case{"StalledTrack", Fault::stalled_track, 1.0,
                         [](Observation& o, Sample&) { o.commanded_right_mps = 0.1; }},
                    Case{"LowBattery", Fault::low_cell_voltage, 2.0,
                         [](Observation&, Sample& s) { s.battery_v = 6.0; }},
                    Case{"EncodersAgainstDuty", Fault::encoders_against_duty, 0.5,
                         [](Observation& o, Sample& s) {
                           s.left_duty = 0.5;
                           o.left_mps = -0.05;
                         }},
                    Case{"GyroAgainstEncoders", Fault::gyro_against_encoders, 1.0,
                         [](Observation& o, Sample&) {
                           o.gyro_yaw_rate_radps = -0.4;
                           o.encoder_yaw_rate_radps = 0.4;
                         }}),
    [](const testing::TestParamInfo<Case>& param) { return param.param.name; });

}  // namespace
}  // namespace tp100::control
