// Values that nobody has set ask for nothing and show nothing.

#include <gtest/gtest.h>

#include "control/arming.h"
#include "control/corner.h"
#include "control/hand_drive.h"
#include "control/law.h"
#include "control/monitor.h"
#include "control/tracker.h"

namespace tp100::control {
namespace {

TEST(Defaults, OfOutputsAskForAStandstill) {
  const Target target;
  for (const double value :
       {target.desired_yaw_rad, target.yaw_rate_radps, target.speed_mps, target.cross_track_m,
        target.off_path_m, target.heading_error_rad, target.progress_m})
    EXPECT_EQ(value, 0.0);
  EXPECT_FALSE(target.recovering || target.done);
  const HandCommand command;
  for (const double value : {command.desired_yaw_rad, command.yaw_rate_radps, command.speed_mps})
    EXPECT_EQ(value, 0.0);
  EXPECT_FALSE(command.at_fence);
  const LawOutput steering;
  EXPECT_EQ(steering.yaw_rad, 0.0);
  EXPECT_EQ(steering.yaw_rate_radps, 0.0);
  const Lqr::Gains gains;
  for (const double gain : {gains.cross_track, gains.heading, gains.rate}) EXPECT_EQ(gain, 0.0);
}

TEST(Defaults, OfInputsShowARobotAtRestOnItsPath) {
  const PathErrors errors;
  for (const double value :
       {errors.cross_track_m, errors.heading_rad, errors.yaw_rate_radps, errors.speed_mps,
        errors.curvature_1pm, errors.crab_rad, errors.ahead.along_m, errors.ahead.left_m,
        errors.ahead.yaw_rad, errors.ahead.curvature_1pm})
    EXPECT_EQ(value, 0.0);
  const HandDriveState state;
  EXPECT_EQ(state.measured_yaw_rate_radps, 0.0);
  EXPECT_EQ(state.position_sd_m, 0.0);
  const FenceMotion motion;
  EXPECT_EQ(motion.yaw_rate_radps, 0.0);
  EXPECT_EQ(motion.uncertainty_m, 0.0);
  const DriveModel drive;
  EXPECT_EQ(drive.slip_angle_rad, 0.0);
  const DisturbanceSigns signs;
  EXPECT_EQ(signs.gyro_radps, signs.tracks_radps);
  EXPECT_EQ(signs.contradictions, 0u);
}

TEST(Defaults, OfInputsShowNoReasonToEndARun) {
  const ArmingInputs in;
  EXPECT_FALSE(in.new_session || in.rebooted || in.done);
  EXPECT_EQ(in.aborts, 0u);
  const Load load;
  EXPECT_EQ(load.turning, 0.0);
  EXPECT_EQ(load.pitch_rad, 0.0);
  EXPECT_FALSE(load.on_obstacle);
  const Observation seen;
  for (const double value : {seen.left_mps, seen.right_mps, seen.encoder_yaw_rate_radps,
                             seen.gyro_yaw_rate_radps, seen.pitch_rad, seen.commanded_left_mps,
                             seen.commanded_right_mps, seen.elapsed_s, seen.dt_s})
    EXPECT_EQ(value, 0.0);
  EXPECT_FALSE(seen.gyro_in_use || seen.on_obstacle || seen.immobilised || seen.by_hand ||
               seen.commanded);
}

TEST(Defaults, OfWhatHasNotBegunAreAtRest) {
  const Arming arming;
  EXPECT_TRUE(arming.at_rest());
  EXPECT_FALSE(arming.just_began() || arming.disarming());
  EXPECT_EQ(arming.refused(), StartRefusal::kNone);
  EXPECT_EQ(arming.faults(), 0u);
  EXPECT_FALSE(Recovery{}.active());
  PivotProfile pivot;
  EXPECT_EQ(pivot.yaw_rad(), 0.0);
  EXPECT_EQ(pivot.rate_radps(), 0.0);
  EXPECT_FALSE(pivot.arrived());
  pivot.update({}, 0.01);
  EXPECT_EQ(pivot.yaw_rad(), 0.0);
  EXPECT_TRUE(pivot.arrived());
}

}  // namespace
}  // namespace tp100::control
