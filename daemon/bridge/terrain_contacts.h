#pragma once
// The ground under each of the three poses, and the robot in the course's world where ramps and
// blocks are virtual.

#include <optional>

#include "bridge/external_world.h"
#include "bridge/parameters.h"
#include "core/estimates.h"
#include "core/pose.h"
#include "course/course.h"
#include "estimation/motion.h"
#include "model/track_model.h"
#include "terrain/terrain_follower.h"
#include "terrain/world.h"

namespace tp100::bridge {

/// The part of a course's terrain that exists on the robot's floor: everything on `terrain`; only
/// surfaces on `flat`, whose ramps and blocks are virtual; nothing on `stand`.
course::Terrain floor_of(const course::Terrain& terrain, Setup setup);

/// The poses at the beginning of an interval, and the tracks' motion in it.
struct TerrainInput {
  PerSource<Estimate> estimates{};
  TrackSpeeds tracks{};
  double dt_s = 0.0;
  terrain::Attitude imu{};  ///< of the real body; used on `terrain` only
};

/// The external world's terrain under the virtual robot; nothing without an external world.
struct ExternalTerrain {
  const std::optional<terrain::ContactState>& contact;
  const std::optional<Transform2d>& transform;
};

/// On `terrain` each pose follows the obstacles with the IMU's attitude. On `flat` and `stand`
/// the real robot stays level: the poses are its poses on the floor, and one more robot, the
/// virtual one, follows the obstacles with the same tracks. It falls behind the real one by what
/// slope, slip on the slope and climbing cost; turns are common to both. An external world can set
/// the virtual robot's attitude and pose. No allocation after construction; safe in the real-time
/// thread.
class TerrainContacts {
 public:
  /// `course` may be null: an unbounded plane.
  TerrainContacts(const Parameters& parameters, const course::Course* course);
  TerrainContacts(const TerrainContacts&) = delete;
  TerrainContacts& operator=(const TerrainContacts&) = delete;

  /// From now on this pose steers.
  void steer_by(PoseSource steering) { steering_ = steering; }
  /// A run begins: the virtual robot stands where the real one does.
  void restart();
  /// Robot and virtual robot are on level ground: resume() with transform() changes nothing except
  /// the surface under the robot.
  bool level() const;
  /// Transform from the robot's floor into the course's world.
  const Transform2d& transform() const { return transform_; }
  void resume(const Transform2d& transform) {
    restart();
    transform_ = transform;
  }
  void advance(const TerrainInput& in);
  /// Gives the virtual robot the external world's attitude and, if there is one, its pose. Call it
  /// before advance().
  void set_external_terrain(const ExternalTerrain& external);

  /// The incline of the interval that advance() has just covered.
  const model::Incline& incline(PoseSource source) const {
    return followers_[source].state().incline;
  }
  /// The same incline, with height, attitude and slip, in the form that the estimators take.
  estimation::Ground ground(PoseSource source) const;

  /// Sets height, pitch and roll of each pose: those of its own terrain follower, or of the virtual
  /// robot.
  void set_attitude(PerSource<Estimate>& estimates) const;
  /// The steering pose in the course's world.
  Pose world(const Pose& steering) const;
  /// The ground under the steering pose; `traction` is the caller's.
  TerrainContact terrain_contact() const;
  /// Pitch that the map expects at the steering pose; only on `terrain` with obstacles. [rad]
  std::optional<double> mapped_pitch_rad() const { return mapped_pitch_rad_; }

 private:
  bool real() const { return setup_ == Setup::kTerrain; }
  const terrain::ContactState& world_contact() const;
  double distance_m(const TerrainInput& in, const model::Incline& incline) const;

  Setup setup_;
  PoseSource steering_;
  model::TrackParameters tracks_;
  terrain::World floor_, world_;
  PerSource<terrain::TerrainFollower> followers_;
  terrain::TerrainFollower virtual_;
  std::optional<double> mapped_pitch_rad_{};
  Transform2d transform_{};  ///< from the real robot to the virtual one
  bool transform_received_ = false;
  std::optional<terrain::ContactState> external_{};
};

}  // namespace tp100::bridge
