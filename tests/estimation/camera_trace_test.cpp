// Golden traces of single camera samples: where the marker is expected, and what samples do that
// are farther and farther away.

#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "estimation/motion.h"
#include "estimation/pose_filter.h"
#include "trace_rows.h"

namespace tp100::estimation {
namespace {

constexpr CameraPlace kPlace{0.4, -0.3};

Ground tilted(Draws& draws) {
  return {.z_m = draws.uniform(0.0, 0.2),
          .roll_rad = draws.uniform(-0.5, 0.5),
          .pitch_rad = draws.uniform(-0.7, 0.7),
          .tilt_radps = draws.uniform(0.0, 3.0)};
}

TEST(CameraTrace, AnExpectedMarkerKeepsItsPlace) {
  Draws draws(17);
  TraceRows rows;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d pose(draws.uniform(-1.0, 1.0), draws.uniform(-1.0, 1.0),
                               draws.uniform(-7.0, 7.0));
    const Ground ground = tilted(draws);
    CameraParameters camera;
    if (i % 2 == 0) {
      camera.height_m = draws.uniform(1.5, 3.0);
      camera.marker_height_m = draws.uniform(0.03, 0.3);
    }
    const Eigen::Vector3d marker = expected_marker(pose, ground, camera, kPlace);
    rows.add("x", marker[0]);
    rows.add("y", marker[1]);
    rows.add("yaw", marker[2]);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("camera_marker.csv"), "");
}

/// A robot whose pose is known within a centimetre and a degree, and its camera.
class Watched {
 public:
  Watched() {
    state_.mean << 0.7, -0.5, 2.9, 0.02, 0.03, -0.01, 0.04, 0.001;
    const StateVector sd{{0.004, 0.006, 0.015, 0.001, 0.01, 0.004, 0.02, 0.001}};
    state_.covariance = sd.cwiseProduct(sd).asDiagonal();
    state_.covariance(kX, kYaw) = state_.covariance(kYaw, kX) = 2e-5;
    state_.covariance(kY, kCommonSlip) = state_.covariance(kCommonSlip, kY) = -3e-5;
  }

  /// A sample that lies aside by this.
  CameraVerdict see(double x_m, double y_m, double yaw_rad) {
    const Eigen::Vector3d marker =
        expected_marker(state_.mean.head<3>(), ground, CameraParameters{}, kPlace);
    after_ = state_;
    return update_.apply(
        after_, {.x_m = marker[0] + x_m, .y_m = marker[1] + y_m, .yaw_rad = marker[2] + yaw_rad},
        ground, twist, model_);
  }
  double nis() const { return update_.nis(); }
  const FilterState& after() const { return after_; }
  void scale(double factor) { state_.covariance *= factor; }

  Ground ground{};
  Twist twist{.vx_mps = 0.1, .vy_mps = 0.0, .yaw_rate_radps = 0.2};

 private:
  FilterState state_;
  FilterState after_;
  CameraUpdate update_{CameraParameters{}, kPlace};
  MotionModel model_{model::TrackParameters{}, FilterParameters{}};
};

void add_outcome(TraceRows& rows, CameraVerdict verdict, const Watched& watched) {
  rows.add("verdict", static_cast<double>(verdict));
  rows.add("nis", watched.nis());
  add_mean(rows, "mean", watched.after().mean);
  add_spread(rows, "sd", watched.after().covariance);
  rows.end_row();
}

TEST(CameraTrace, TheNoiseOfASampleKeepsItsValues) {
  Draws draws(19);
  TraceRows rows;
  for (int i = 0; i < 60; ++i) {
    Watched watched;
    watched.ground = tilted(draws);
    watched.ground.hold_slip = i % 3 == 0;
    if (i % 3 == 1) watched.ground.tilt_radps = 0.0;
    watched.twist = {draws.uniform(-3.0, 3.0), 0.0, draws.uniform(-9.0, 9.0)};
    const CameraVerdict verdict = watched.see(
        draws.uniform(-0.01, 0.01), draws.uniform(-0.01, 0.01), draws.uniform(-0.03, 0.03));
    add_outcome(rows, verdict, watched);
  }
  EXPECT_EQ(rows.difference("camera_noise.csv"), "");
}

/// One story of two samples: the verdicts of both, and where the state is then.
void add_story(TraceRows& rows, Watched& watched, const Eigen::Vector3d& first,
               const Eigen::Vector3d& second) {
  rows.add("first", static_cast<double>(watched.see(first[0], first[1], first[2])));
  rows.add("nis", watched.nis());
  rows.add("second", static_cast<double>(watched.see(second[0], second[1], second[2])));
  rows.add("second_nis", watched.nis());
  rows.add("x", watched.after().mean[kX]);
  rows.add("y", watched.after().mean[kY]);
  rows.add("yaw", watched.after().mean[kYaw]);
  rows.end_row();
}

TEST(CameraTrace, SamplesFartherAndFartherAwayKeepTheirVerdicts) {
  TraceRows rows;
  // Along, across, turned and in between; of a state that is known well, where the gate is within
  // the least movement, and of one that is not.
  for (const double factor : {1.0, 0.09}) {
    for (const Eigen::Vector3d& aside :
         {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.0, -1.0, 0.0),
          Eigen::Vector3d(0.0, 0.0, 3.0), Eigen::Vector3d(-0.6, 0.7, -1.2)}) {
      for (int i = 1; i <= 45; ++i) {
        Watched watched;
        watched.scale(factor);
        add_story(rows, watched, 0.00071 * i * aside, 0.00071 * i * aside);
      }
    }
  }
  EXPECT_EQ(rows.difference("camera_gate.csv"), "");
}

TEST(CameraTrace, TwoSamplesKeepBeingOneStoryAsFarApart) {
  TraceRows rows;
  for (const Eigen::Vector3d& apart :
       {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.0, -1.0, 0.0),
        Eigen::Vector3d(0.0, 0.0, 6.0), Eigen::Vector3d(0.0, 0.0, -6.0)}) {
    for (int i = 0; i < 40; ++i) {
      Watched watched;
      const Eigen::Vector3d first(0.2, -0.15, 0.1);
      add_story(rows, watched, first, first + 0.0017 * i * apart);
    }
  }
  EXPECT_EQ(rows.difference("camera_story.csv"), "");
}

// Letters: a good sample, one that is only a little too far away, and ones that say the robot was
// moved to one place or to another.
TEST(CameraTrace, SequencesOfSamplesKeepTheirVerdicts) {
  TraceRows rows;
  for (const char* sequence :
       {"MMMMM", "MNMNNN", "MgMM", "MgMgM", "Mff", "MfMM", "fMfM", "ffffffffffffffffffffffff",
        "ffffffgfffffffffffff", "fffffffffM", "fffffffffMfM", "MNMNMNMNMNff",
        "ffffffffMMffffffffff", "gfgfgfgf", "MMfffffffffff"}) {
    Watched watched;
    watched.scale(0.09);
    for (const char* sample = sequence; *sample != '\0'; ++sample) {
      const CameraVerdict verdict = *sample == 'g'   ? watched.see(0.001, 0.0, 0.0)
                                    : *sample == 'f' ? watched.see(-0.01, 0.0, 0.0)
                                    : *sample == 'M' ? watched.see(0.1, 0.2, 0.5)
                                                     : watched.see(-0.3, 0.1, -1.0);
      add_outcome(rows, verdict, watched);
    }
  }
  EXPECT_EQ(rows.difference("camera_sequence.csv"), "");
}

}  // namespace
}  // namespace tp100::estimation
