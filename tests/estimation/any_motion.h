#pragma once
// States and intervals of every kind, drawn at random, of a robot none of whose parameters is 0.

#include "../model/uneven_tracks.h"
#include "estimation/motion.h"
#include "support/sequence.h"

namespace tp100::estimation {

using model::uneven_tracks;

class AnyMotion : public test::Sequence {
 public:
  using Sequence::Sequence;

  double sign() { return chance(0.5) ? 1.0 : -1.0; }

  StateVector mean() {
    StateVector mean;
    mean << between(-2.0, 2.0), between(-2.0, 2.0), between(-20.0, 20.0), between(-0.1, 0.1),
        between(-0.1, 0.2), between(-0.05, 0.05), between(-0.1, 0.1), between(-0.01, 0.01);
    return mean;
  }

  StateMatrix covariance() {
    StateMatrix root;
    for (Eigen::Index i = 0; i < root.size(); ++i) root(i) = between(-0.05, 0.05);
    return root * root.transpose();
  }

  /// One to eight samples: forward, backward, arcs, turns on the spot, creeping, standstill; on
  /// level ground, on a slope and while the body tips.
  Motion motion(bool gyro) {
    Motion motion;
    motion.dt_s = 0.005 * (1 + below(8));
    const double fastest = chance(0.2) ? 0.003 : 0.25;
    motion.tracks = {between(-fastest, fastest), between(-fastest, fastest)};
    if (chance(0.1)) motion.tracks = {};
    motion.shape = model::turn_shape(motion.tracks.left_mps, motion.tracks.right_mps);
    motion.gyro = gyro;
    motion.warming_degc = between(-0.1, 0.1);
    motion.gyro_z_radps = sign() * between(0.2, 1.5);
    motion.shift_scale = between(0.1, 10.0);
    Ground& ground = motion.ground;
    ground.horizontal_fraction = chance(0.25) ? between(-2.0, 2.0) : between(0.85, 1.0);
    ground.hold_slip = chance(0.25);
    ground.tilt_radps = chance(0.3) ? between(0.0, 2.0) : 0.0;
    ground.slip = {between(0.05, 0.3), between(0.05, 0.3)};
    return motion;
  }
};

}  // namespace tp100::estimation
