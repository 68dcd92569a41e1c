#pragma once
// What every step publishes beside poses: estimates of the motion and their figures, slope, terrain
// contact, traction.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/enum_names.h"
#include "core/pose.h"

namespace tp100 {

/// The estimates of the robot's motion, each of which may steer.
enum class PoseSource : std::uint8_t {
  kModel,     ///< the model (model/track_model.h) on encoder counts alone
  kOdometry,  ///< encoders + gyro
  kFused,     ///< encoders + gyro + overhead camera; without a camera, the same filter without it
};

/// Names as in files, messages and tables, in the enum's order.
inline constexpr std::array kPoseSourceNames = {
    EnumName<PoseSource>{PoseSource::kModel, "model"},
    EnumName<PoseSource>{PoseSource::kOdometry, "odometry"},
    EnumName<PoseSource>{PoseSource::kFused, "fused"},
};
constexpr auto pose_sources() {
  std::array<PoseSource, kPoseSourceNames.size()> sources{};
  for (std::size_t i = 0; i < sources.size(); ++i) sources[i] = kPoseSourceNames[i].value;
  return sources;
}
inline constexpr std::array kPoseSources = pose_sources();
constexpr std::string_view to_string(PoseSource source) {
  return name_in(kPoseSourceNames, source);
}

/// Mean of the normalised innovation squared (NIS) of a camera's poses if all noise is as assumed.
inline constexpr double kNisDegrees = 3.0;

/// The inputs of a source, for tables.
constexpr std::string_view inputs_of(PoseSource source) {
  switch (source) {
    case PoseSource::kModel:
      return "encoders";
    case PoseSource::kOdometry:
      return "+ gyro";
    case PoseSource::kFused:
      return "+ camera";
  }
  return "";
}

/// True for a source that, without an overhead camera, is the same as another one.
constexpr bool needs_camera(PoseSource source) { return source == PoseSource::kFused; }

/// True for sources whose inputs do not show a disturbance.
constexpr bool blind_to_disturbances(PoseSource source) { return source == PoseSource::kModel; }

/// One value for each source.
template <class T>
struct PerSource {
  std::array<T, kPoseSources.size()> values{};

  constexpr T& operator[](PoseSource source) { return values[static_cast<std::size_t>(source)]; }
  constexpr const T& operator[](PoseSource source) const {
    return values[static_cast<std::size_t>(source)];
  }
};

/// The same value for every source.
template <class T>
constexpr PerSource<T> same_for_all(const T& value) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return PerSource<T>{{(static_cast<void>(i), value)...}};
  }
  (std::make_index_sequence<kPoseSources.size()>{});
}

/// Covariance of x [m], y [m] and yaw [rad], or of their rates: the upper triangle of a symmetric,
/// positive semidefinite matrix.
struct PlanarCovariance {
  double xx = 0.0;
  double xy = 0.0;
  double x_yaw = 0.0;
  double yy = 0.0;
  double y_yaw = 0.0;
  double yaw_yaw = 0.0;
};

/// Stands for the variance of what is not estimated, as usual in ROS.
inline constexpr double kUnknownVariance = 1e6;

/// One estimate of the robot's motion.
struct Estimate {
  Pose pose{};
  Twist twist{};
  PlanarCovariance covariance{};  ///< of the pose, in the world frame; of the fused pose with the
                                  ///< error common to all images
};

constexpr PerSource<Pose> poses_of(const PerSource<Estimate>& estimates) {
  PerSource<Pose> poses;
  for (const PoseSource source : kPoseSources) poses[source] = estimates[source].pose;
  return poses;
}

/// Results of the filter of the fused estimate besides its pose, twist and covariance.
struct FilterFigures {
  double slip_left = 0.0;  ///< estimated
  double slip_right = 0.0;
  double gyro_bias_radps = 0.0;
  double nis = 0.0;       ///< normalized innovation squared of the last camera sample, 3 DoF
  double nis_mean = 0.0;  ///< mean over the samples since the run began, without outliers; 3 if
                          ///< noise is as assumed
  std::uint32_t nis_count = 0;        ///< of those samples
  std::int64_t camera_age_us = -1;    ///< now - when the last used sample was taken; -1: none yet
  std::uint32_t camera_used = 0;      ///< since the run began
  std::uint32_t camera_rejected = 0;  ///< outside the gate, too old or out of order
  std::uint32_t recoveries = 0;       ///< the camera contradicted the estimate and was accepted
};

/// Slope along the robot, as far as its pitch shows it.
enum class Slope : std::uint8_t { kFlat, kUp, kDown };

/// Names as in messages and results.
inline constexpr std::array<EnumName<Slope>, 3> kSlopeNames = {{
    {Slope::kFlat, "flat"},
    {Slope::kUp, "up"},
    {Slope::kDown, "down"},
}};
constexpr const char* to_string(Slope slope) { return name_in(kSlopeNames, slope); }

/// Where pitch and roll of the published poses come from; follows from the set-up.
enum class PitchSource : std::uint8_t {
  kVirtual,   ///< the virtual world (stand, flat)
  kImu,       ///< the robot's own IMU (terrain)
  kExternal,  ///< an external world (udp, files)
};

/// Names as in messages.
inline constexpr std::array<EnumName<PitchSource>, 3> kPitchSourceNames = {{
    {PitchSource::kVirtual, "virtual"},
    {PitchSource::kImu, "imu"},
    {PitchSource::kExternal, "external"},
}};
constexpr const char* to_string(PitchSource source) { return name_in(kPitchSourceNames, source); }

/// Obstacle class: what carries the robot.
enum class ObstacleClass : std::uint8_t {
  kNone,   ///< the level floor alone
  kRamp,   ///< a ramp, at least in part; its flat top included
  kBlock,  ///< a block, at least in part
};

/// Names as in messages.
inline constexpr std::array<EnumName<ObstacleClass>, 3> kObstacleClassNames = {{
    {ObstacleClass::kNone, "none"},
    {ObstacleClass::kRamp, "ramp"},
    {ObstacleClass::kBlock, "block"},
}};
constexpr const char* to_string(ObstacleClass obstacle) {
  return name_in(kObstacleClassNames, obstacle);
}

/// Whether the tracks still move the robot.
enum class Traction : std::uint8_t {
  kHolding,      ///< slip within its bound, or no evidence
  kSlipping,     ///< slip beyond its bound
  kImmobilised,  ///< the tracks run and the robot hardly moves
};

/// Names as in messages.
inline constexpr std::array<EnumName<Traction>, 3> kTractionNames = {{
    {Traction::kHolding, "holding"},
    {Traction::kSlipping, "slipping"},
    {Traction::kImmobilised, "immobilised"},
}};
constexpr const char* to_string(Traction traction) { return name_in(kTractionNames, traction); }

/// The ground under the steering pose.
struct TerrainContact {
  PitchSource pitch_source = PitchSource::kVirtual;
  ObstacleClass obstacle = ObstacleClass::kNone;  ///< by the course's map
  bool climbing = false;     ///< between touching a block and lying flat behind it
  double slope_rad = 0.0;    ///< climb angle, nose-up positive
  double slip_offset = 0.0;  ///< of the surface, added to both slip ratios
  Traction traction = Traction::kHolding;
};

}  // namespace tp100
