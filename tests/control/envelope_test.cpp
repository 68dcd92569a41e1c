#include "control/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "control/hand_drive.h"

namespace tp100::control {
namespace {

constexpr FaultMask kCamera = fault_bit(Fault::camera_against_odometry);
constexpr FaultMask kWorld = fault_bit(Fault::world_against_odometry);

class EnvelopeTest : public testing::Test {
 protected:
  EnvelopeTest() { seen_.dt_s = 0.005; }
  /// A pose beside the steering pose, which agrees with it.
  Witness witness(double x_m, double y_m, std::optional<Fault> contradiction) const {
    const Pose pose{.x_m = x_m, .y_m = y_m};
    return {.pose = pose, .other = pose, .contradiction = contradiction};
  }
  FaultMask judged(const Witness& one) {
    seen_.others.clear();
    seen_.others.push(one);
    return envelope_.update(seen_);
  }

  Whereabouts seen_{};
  Envelope envelope_{
      Parameters{}, course::Fence{-1.0, 1.0, -1.0, 1.0, {}, {{{0.5, 0.5}, {0.9, 0.5}, {0.5, 0.9}}}},
      20.0};
};

TEST_F(EnvelopeTest, EveryPoseHasTheSameFenceAreasAndPath) {
  EXPECT_EQ(judged(witness(0.99, 0.0, {})), 0u);
  EXPECT_EQ(judged(witness(1.02, 0.0, {})), fault_bit(Fault::fence));
  EXPECT_EQ(judged(witness(0.0, -1.02, {})), fault_bit(Fault::fence));
  EXPECT_EQ(judged(witness(0.6, 0.6, {})), fault_bit(Fault::fence));
  Witness aside = witness(0.0, 0.0, {});
  aside.off_path_m = 0.22;
  EXPECT_EQ(judged(aside), fault_bit(Fault::cross_track));
}

TEST_F(EnvelopeTest, APoseThatAloneIsOutsideContradictsTheOneThatSteers) {
  for (const FaultMask fault : {kCamera, kWorld}) {
    const Witness alone = witness(1.03, 0.0, *first_fault(fault));
    EXPECT_EQ(judged(alone), fault);
    seen_.steering.pose.x_m = 1.01;
    EXPECT_EQ(judged(alone), fault_bit(Fault::fence)) << "they agree";
    Witness inside = alone;
    inside.pose.x_m = 0.995;
    inside.other.x_m = 1.01;
    EXPECT_EQ(judged(inside), fault_bit(Fault::fence)) << "they nearly agree";
    seen_.steering.pose.x_m = inside.other.x_m = 1.05;
    EXPECT_EQ(judged(inside), fault);
    seen_.steering.pose.x_m = 0.0;
  }
}

TEST_F(EnvelopeTest, AContradictionIsTheOnlyFaultWhateverElseSeemsToBeWrong) {
  seen_.steering.pose.x_m = 3.0;
  seen_.steering.off_path_m = 2.0;
  seen_.elapsed_s = 1000.0;
  Witness one = witness(0.0, 0.0, Fault::camera_against_odometry);
  one.other.x_m = 3.0;
  EXPECT_EQ(judged(one), kCamera);
  one.contradiction.reset();
  EXPECT_EQ(judged(one),
            fault_bit(Fault::fence) | fault_bit(Fault::cross_track) | fault_bit(Fault::time_limit))
      << "two estimates may differ if no camera and no world owns one";
}

// What the deviations and the obstacles of a world explain is no contradiction.
TEST_F(EnvelopeTest, PlaceAndDirectionMayDifferByAMarginThatGrowsWithWhatIsNotKnown) {
  const auto apart_m = [this](double sd_m, double lag_m) {
    for (double m = 0.0; m < 2.0; m += 0.001) {
      Witness one = witness(0.0, 0.0, Fault::camera_against_odometry);
      one.other.x_m = -0.6 * m;
      one.other.y_m = 0.8 * m;
      one.sd_m = sd_m;
      one.lag_m = lag_m;
      if (judged(one) != 0) return m;
    }
    return 2.0;
  };
  EXPECT_NEAR(apart_m(0.0, 0.0), Envelope::kContradictionM, 0.002);
  EXPECT_NEAR(apart_m(0.02, 0.0), Envelope::kContradictionM + 0.04, 0.002);
  EXPECT_NEAR(apart_m(0.02, 0.1), Envelope::kContradictionM + 0.14, 0.002);
  for (const double sign : {1.0, -1.0}) {
    Witness one = witness(0.0, 0.0, Fault::camera_against_odometry);
    one.other.yaw_rad = sign * 11.9 * kRadPerDeg + 4.0 * kPi;
    EXPECT_EQ(judged(one), 0u) << "whole turns are none";
    one.other.yaw_rad += sign * 0.2 * kRadPerDeg;
    EXPECT_EQ(judged(one), kCamera);
    one.sd_rad = 0.1 * kRadPerDeg;
    EXPECT_EQ(judged(one), 0u);
  }
}

TEST_F(EnvelopeTest, ByHandOnlyAContradictionEndsADrive) {
  seen_.by_hand = true;
  seen_.steering.off_path_m = 9.0;
  seen_.elapsed_s = 1e4;
  seen_.heading_error_rad = 2.0;
  for (int i = 0; i < 200; ++i)
    EXPECT_EQ(judged(witness(3.0, 0.0, Fault::camera_against_odometry)), 0u);
  Witness one = witness(0.0, 0.0, Fault::world_against_odometry);
  one.other.x_m = 0.2;
  EXPECT_EQ(judged(one), kWorld);
}

// A second marker may be so near that no single jump is a contradiction.
TEST_F(EnvelopeTest, ACameraThatResetsThePoseAgainAndAgainContradictsOdometry) {
  seen_.recoveries = 7;  // of the run before
  const auto resets_for_s = [this](double period_s) {
    envelope_.restart();
    double t_s = 0.0, next_s = period_s;
    for (; t_s < 60.0; t_s += seen_.dt_s) {
      if (t_s >= next_s) {
        ++seen_.recoveries;
        next_s += period_s;
      }
      if (envelope_.update(seen_) == kCamera) break;
    }
    return t_s;
  };
  EXPECT_GT(resets_for_s(3.0), 59.9) << "pushes are none";
  EXPECT_LT(resets_for_s(0.5), 10.0);
  EXPECT_LT(resets_for_s(0.1), 3.0);
}

TEST_F(EnvelopeTest, ADriverIsHeldByThePoseNearestToTheFence) {
  for (const double sign : {1.0, -1.0}) {
    HandDriveState state{.limits = {.max_track_mps = 0.2}};
    /// After two seconds towards the fence with the robot at `x_m`.
    const auto driven = [&](double x_m) {
      HandDrive drive(course::Fence{-1.0, 1.0, -1.0, 1.0});
      drive.restart(0);
      state.pose.x_m = sign * x_m;
      HandCommand command;
      for (HostNs now = 0; now < 2 * kNsPerS; now += 5 * kNsPerMs) {
        drive.take({.at_ns = now, .speed_mps = sign * 0.1}, now);
        command = drive.update(state, Parameters{}, now, 0.005);
      }
      EXPECT_EQ(command.at_fence, std::abs(command.speed_mps) < 0.099);
      return std::abs(command.speed_mps);
    };
    EXPECT_NEAR(driven(0.0), 0.1, 1e-9);
    const double slowed_mps = driven(0.97);
    EXPECT_LT(slowed_mps, 0.1);
    EXPECT_EQ(driven(0.999), 0.0);
    state.position_sd_m = 0.005;
    EXPECT_LT(driven(0.97), slowed_mps) << "it may be nearer";
    state.position_sd_m = 0.0;
    state.braking_mps2 = 0.3;
    EXPECT_LT(driven(0.97), slowed_mps) << "it brakes worse";
    state.others.push(witness(sign * 1.03, 0.0, Fault::camera_against_odometry));
    EXPECT_EQ(driven(0.0), 0.0);
    state.others[0].sd_m = 0.2;
    EXPECT_NEAR(driven(0.0), 0.1, 1e-9) << "it may well be inside";
  }
}

}  // namespace
}  // namespace tp100::control
