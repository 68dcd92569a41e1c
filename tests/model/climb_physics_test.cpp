// Compares the step climb with an independent simulation of contact physics in the plane: a rigid
// stadium on springs and dampers, driven by Coulomb friction of its running tracks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "model/step_climb.h"

namespace tp100::model {
namespace {

constexpr double kFriction = 1.2;  // enough that the tracks do not slip
constexpr double kFullGripMps = 1e-3;
constexpr double kStiffness = 2e4, kDamping = 60.0;
constexpr double kMass = 0.922, kGravity = 9.80665;
constexpr double kStep = 2e-5;

class PlanarBody {
 public:
  PlanarBody(const ClimbGeometry& geometry, const BlockShape& block, double track_mps,
             const ClimbState& start)
      : g_(geometry), block_(block), track_(track_mps), x_(start.com_m.x), z_(start.com_m.z) {
    vx_ = track_mps;
  }

  double angle() const { return angle_; }
  double x() const { return x_; }
  double z() const { return z_; }

  void step() {
    fx_ = 0.0;
    fz_ = -kMass * kGravity;
    torque_ = 0.0;
    const double c = std::cos(angle_), s = std::sin(angle_), r = g_.wheel_radius_m;
    const double up = g_.com_height_m - r;
    const PlaneVector rear{x_ - g_.com_forward_m * c + up * s, z_ - g_.com_forward_m * s - up * c};
    const PlaneVector front{rear.x + g_.axle_spacing_m * c, rear.z + g_.axle_spacing_m * s};
    for (const PlaneVector& axle : {rear, front}) {
      push({axle.x, axle.z - r}, {0, 1}, r - axle.z);
      const bool inside = axle.x > 0.0 && axle.x < block_.depth_m;
      if (inside && axle.z > block_.height_m) {
        push({axle.x, axle.z - r}, {0, 1}, block_.height_m + r - axle.z);
      } else if (axle.z < block_.height_m && axle.x < block_.depth_m / 2.0) {
        push({axle.x + r, axle.z}, {-1, 0}, axle.x + r);
      } else if (axle.z < block_.height_m) {
        push({axle.x - r, axle.z}, {1, 0}, block_.depth_m + r - axle.x);
      }
    }
    edge(rear, {c, s}, 0.0, -1.0);
    edge(rear, {c, s}, block_.depth_m, 1.0);
    vx_ += fx_ / kMass * kStep;
    vz_ += fz_ / kMass * kStep;
    rate_ += torque_ / (kMass * gyration_squared_m2(g_)) * kStep;
    x_ += vx_ * kStep;
    z_ += vz_ * kStep;
    angle_ += rate_ * kStep;
  }

 private:
  void push(PlaneVector at, PlaneVector normal, double depth) {
    if (depth <= 0.0) return;
    const double rx = at.x - x_, rz = at.z - z_;
    const double vx = vx_ - rate_ * rz, vz = vz_ + rate_ * rx;
    const double load =
        std::max(0.0, kStiffness * depth - kDamping * (vx * normal.x + vz * normal.z));
    const PlaneVector drive{normal.z, -normal.x};
    const double slip = track_ - (vx * drive.x + vz * drive.z);
    const double pull = std::clamp(slip / kFullGripMps, -1.0, 1.0) * kFriction * load;
    const double fx = load * normal.x + pull * drive.x, fz = load * normal.z + pull * drive.z;
    fx_ += fx;
    fz_ += fz;
    torque_ += rx * fz - rz * fx;
  }

  void edge(PlaneVector rear, PlaneVector along, double edge_x, double outward) {
    const double flat = (edge_x - rear.x) * along.x + (block_.height_m - rear.z) * along.z;
    const double nearest = std::clamp(flat, 0.0, g_.axle_spacing_m);
    const double dx = rear.x + nearest * along.x - edge_x;
    const double dz = rear.z + nearest * along.z - block_.height_m;
    const double distance = std::hypot(dx, dz);
    const bool faces = flat == nearest || (dx * outward >= 0.0 && dz >= 0.0);
    if (distance < 1e-9 || !faces) return;
    push({edge_x, block_.height_m}, {dx / distance, dz / distance}, g_.wheel_radius_m - distance);
  }

  ClimbGeometry g_;
  BlockShape block_;
  double track_;
  double x_, z_, angle_ = 0.0, vx_ = 0.0, vz_ = 0.0, rate_ = 0.0;
  double fx_ = 0.0, fz_ = 0.0, torque_ = 0.0;
};

struct Drive {
  BlockShape block;
  double speed;
  TipStart tip_start;
};

class ClimbPhysics : public testing::TestWithParam<Drive> {};

TEST_P(ClimbPhysics, PitchAgreesWithinTwoDegreesAndPlaceWithinThreeMillimetres) {
  const Drive& drive = GetParam();
  StepClimb model({}, drive.block, RiserForm::kTrackHolds, drive.tip_start);
  model.reset(0.01);
  PlanarBody body({}, drive.block, drive.speed, model.state());
  const int every = 50;
  const int samples =
      static_cast<int>((drive.block.depth_m + 0.28) / drive.speed / (kStep * every));
  double pitch = 0.0, forward = 0.0, up = 0.0;
  for (int i = 0; i < samples; ++i) {
    for (int k = 0; k < every; ++k) body.step();
    const ClimbState& state = model.advance(drive.speed * kStep * every, kStep * every);
    pitch += std::pow(state.pitch_rad + body.angle(), 2);
    forward += std::pow(state.com_m.x - body.x(), 2);
    up += std::pow(state.com_m.z - body.z(), 2);
  }
  EXPECT_EQ(model.state().phase, ClimbPhase::kDown);
  EXPECT_NEAR(body.angle(), 0.0, 0.01);
  EXPECT_LT(std::sqrt(pitch / samples) * kDegPerRad, 2.0);
  EXPECT_LT(std::sqrt(forward / samples), 0.003);
  EXPECT_LT(std::sqrt(up / samples), 0.002);
}

INSTANTIATE_TEST_SUITE_P(Drives, ClimbPhysics,
                         testing::Values(Drive{{0.037, 0.100}, 0.10, TipStart::kBalance},
                                         Drive{{0.037, 0.100}, 0.10, TipStart::kLiftOff},
                                         Drive{{0.037, 0.200}, 0.10, TipStart::kLiftOff},
                                         Drive{{0.037, 0.100}, 0.05, TipStart::kBalance},
                                         Drive{{0.030, 0.100}, 0.10, TipStart::kBalance},
                                         Drive{{0.020, 0.100}, 0.10, TipStart::kBalance}));

}  // namespace
}  // namespace tp100::model
