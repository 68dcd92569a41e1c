#pragma once
// The ground under each of the three poses, and the robot in the course's world where ramps and
// blocks are virtual.

#include <optional>

#include "bridge/outer_world.h"
#include "bridge/parameters.h"
#include "core/pose.h"
#include "core/underfoot.h"
#include "course/course.h"
#include "estimation/motion.h"
#include "estimation/odometry.h"
#include "model/track_model.h"
#include "terrain/ride.h"
#include "terrain/world.h"

namespace tp100::bridge {

/// What of a course's terrain really is on the robot's floor: everything on `terrain`, only other
/// ground on `flat`, whose ramps and blocks exist in the daemon's world alone, nothing on `bench`.
course::Terrain floor_of(const course::Terrain& terrain, Setup setup);

/// Where the poses are at the beginning of an interval, and what the belts do in it.
struct GroundInput {
  Pose model{}, odometry{}, fused{}, steering{};
  estimation::BeltSpeeds belts{};
  double dt_s = 0.0;
  terrain::Attitude imu{};  ///< of the real body; used on `terrain` only
};

/// What an external world says of the virtual robot; nothing where there is none.
struct GroundTold {
  const std::optional<terrain::RideState>& ride;
  const std::optional<Shift>& shift;
};

/// On `terrain` each pose rides the obstacles with the IMU's attitude. On `flat` and `bench` the
/// real robot stays level: the poses are its poses on the floor, and one more robot, the virtual
/// one, rides the obstacles with the same belts. It falls behind the real one by what slope, slip
/// on the slope and climbing cost; turns are common to both. An external world can say how the
/// virtual robot stands, and where. No allocation after construction; safe
/// in the real-time thread.
class Grounds {
 public:
  /// `course` may be null: a plane without end.
  Grounds(const Parameters& parameters, const course::Course* course);
  Grounds(const Grounds&) = delete;
  Grounds& operator=(const Grounds&) = delete;

  /// From now on this pose steers.
  void steer_by(Steering steering) { steering_ = steering; }
  /// A run begins: the virtual robot stands where the real one does.
  void restart();
  void advance(const GroundInput& in);
  /// An external world rules: the virtual robot stands as it says, and is where it says, if it
  /// does. Call it before advance().
  void tell(const GroundTold& told);

  /// For the interval just advanced over.
  const model::Incline& model() const { return model_.state().incline; }
  const model::Incline& odometry() const { return odometry_.state().incline; }
  estimation::Ground fused() const;

  /// Gives each pose height, pitch and roll: those of its own ride, or of the virtual robot.
  void stand(Pose& model, Pose& odometry, Pose& fused) const;
  /// The steering pose in the course's world.
  Pose world(const Pose& steering) const;
  /// The ground under the steering pose; `traction` is the caller's.
  Underfoot underfoot() const;
  /// Pitch that the map expects at the steering pose; only on `terrain` with obstacles. [rad]
  std::optional<double> mapped_pitch_rad() const { return mapped_pitch_rad_; }

 private:
  bool real() const { return setup_ == Setup::kTerrain; }
  const terrain::RideState& steering_stands() const;
  const terrain::RideState& world_stands() const;
  double way_m(const GroundInput& in, const model::Incline& incline) const;

  Setup setup_;
  Steering steering_;
  model::TrackParameters tracks_;
  terrain::World floor_, world_;
  terrain::Ride model_, odometry_, fused_, virtual_;
  std::optional<double> mapped_pitch_rad_{};
  Shift shift_{};  ///< of the virtual robot against the real one
  bool shift_told_ = false;
  std::optional<terrain::RideState> told_{};
};

}  // namespace tp100::bridge
