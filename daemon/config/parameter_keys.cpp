#include "config/parameter_keys.h"

#include <array>

#include "core/arithmetic.h"
#include "course/camera.h"

namespace tp100::config {
namespace {

using text::Choice;
using text::Key;

constexpr double kDeg = kRadPerDeg;
constexpr double kMs = 1e-3;

}  // namespace

std::span<const Key<bridge::Parameters>> setup_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 1> kKeys = {{
      {"setup",
       text::enum_choice<T, &T::setup, bridge::kSetupNames>(),
       {},
       "Place of the robot. stand: the tracks turn freely and the gyro is not used for "
       "steering; flat: a flat floor, with obstacles only in the virtual world; terrain: the "
       "real floor has the obstacles, too"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> model_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 1> kKeys = {{
      {"mode",
       Choice<T>{{"extended", "paper"},
                 [](const T& p) { return static_cast<std::size_t>(p.paper_model); },
                 [](T& p, std::size_t i) { p.paper_model = i == 1; }},
       {},
       "paper: eqs 1-5 with the paper's constants whatever the robot file says; extended: the "
       "robot's values, turning centre and slope"},
  }};
  return kKeys;
}

std::span<const Key<model::TrackParameters>> track_keys() {
  using T = model::TrackParameters;
  static const std::array<Key<T>, 2> kKeys = {{
      {"slip_curve",
       text::enum_choice<T, &T::slip_curve, model::kSlipCurveNames>(),
       {},
       "Slip as a function of the slope. table: the paper's table; fit: the straight line "
       "through it. Downhill, where the paper has no values, both keep their value for level "
       "ground; table-downhill and fit-downhill continue the curve instead, which is our "
       "extension"},
      {"turning_threshold_radps",
       &T::turning_threshold_radps,
       {0, 10},
       "Above this yaw rate the slip angle of turning applies"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> steering_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 1> kKeys = {{
      {"steering",
       text::enum_choice<T, &T::steering, kPoseSourceNames>(),
       {},
       "Pose that the controller uses. model: from the encoders alone; odometry: from encoders "
       "and gyro; fused: from these and the overhead camera"},
  }};
  return kKeys;
}

std::span<const Key<estimation::Parameters>> estimation_keys() {
  using T = estimation::Parameters;
  static const std::array<Key<T>, 3> kKeys = {{
      {"still_s",
       &T::still_s,
       {0.1, 10},
       "Both tracks must be at standstill for this long before the gyro bias is measured"},
      {"still_gyro_sd_radps",
       &T::still_gyro_sd_radps,
       {0.0005, 0.2},
       "Standard deviation of the gyro above which the robot is not at standstill"},
      {"bias_time_s", &T::bias_time_s, {0.05, 60}, "Time constant of the gyro bias at standstill"},
  }};
  return kKeys;
}

std::span<const Key<estimation::CameraParameters>> camera_keys() {
  using T = estimation::CameraParameters;
  static const auto mount = course::camera_mount_keys<T>();
  static const std::array<Key<T>, 8> kKeys = {{
      {"position_sd_m",
       &T::position_sd_m,
       {1e-4, 0.1},
       "Standard deviation of the marker's position from image to image"},
      {"yaw_sd_deg", &T::yaw_sd_rad, {0.01, 20}, "Same for its direction", kDeg},
      {"time_sd_ms", &T::time_sd_s, {0, 100}, "Same for its time stamps", kMs},
      {"constant_sd_m",
       &T::constant_sd_m,
       {0, 0.1},
       "Standard deviation of the position error that all images have in common; it is added to "
       "the published uncertainty"},
      mount[0],
      mount[1],
      mount[2],
      mount[3],
  }};
  return kKeys;
}

std::span<const Key<control::Parameters>> control_keys() {
  using T = control::Parameters;
  static const std::array<Key<T>, 31> kKeys = {{
      {"law",
       text::enum_choice<T, &T::law, control::kLawNames>(),
       {},
       "Control law for lines and arcs. stanley: desired yaw from cross-track and heading "
       "error; pure-pursuit: the circle to a point ahead; lqr: gains of a linear-quadratic "
       "regulator for each speed"},
      {"preview_s",
       &T::preview_s,
       {0, 1},
       "Lag of loop and motors, by which the controller looks ahead on the path"},
      {"cross_track_gain_1ps",
       &T::cross_track_gain_1ps,
       {0, 50},
       "Stanley: the approach angle is the arc tangent of this times the cross-track error "
       "divided by the speed"},
      {"soft_speed_mps",
       &T::soft_speed_mps,
       {0.001, 1},
       "Stanley: added to that speed, so that the approach angle stays steady near a stop"},
      {"max_approach_deg", &T::max_approach_rad, {1, 80}, "Steepest approach to the path", kDeg},
      {"pursuit_s",
       &T::pursuit_s,
       {0.1, 10},
       "Pure pursuit: the distance to the point ahead is the distance driven in this time"},
      {"pursuit_min_m",
       &T::pursuit_min_m,
       {0.01, 2},
       "Pure pursuit: smallest distance to that point"},
      {"pursuit_max_m",
       &T::pursuit_max_m,
       {0.01, 2},
       "Pure pursuit: largest distance to that point"},
      {"lqr_cross_track_m",
       &T::lqr_cross_track_m,
       {0.001, 1},
       "LQR: cross-track error that weighs as much as the heading error and turn rate below"},
      {"lqr_heading_deg", &T::lqr_heading_rad, {0.1, 180}, "LQR: that heading error", kDeg},
      {"lqr_turn_radps", &T::lqr_turn_radps, {0.01, 10}, "LQR: that turn rate"},
      {"acceleration_mps2", &T::acceleration_mps2, {0.01, 5}, "Acceleration along the path"},
      {"full_speed_radius_m",
       &T::full_speed_radius_m,
       {0, 10},
       "In arcs with a smaller radius than this, the speed decreases with the radius"},
      {"min_speed_mps", &T::min_speed_mps, {0.001, 0.3}, "Lowest speed on the approach to a stop"},
      {"pivot_rate_radps", &T::pivot_rate_radps, {0.05, 5}, "Turn rate on the spot"},
      {"pivot_acceleration_radps2",
       &T::pivot_acceleration_radps2,
       {0.05, 50},
       "Rate of change of the turn rate on the spot"},
      {"pivot_tolerance_deg",
       &T::pivot_tolerance_rad,
       {0.05, 20},
       "Heading error within which a turn on the spot ends",
       kDeg},
      {"stop_tolerance_m",
       &T::stop_tolerance_m,
       {0.0005, 0.1},
       "Distance from its end within which a line or arc ends"},
      {"settle_s",
       &T::settle_s,
       {0, 5},
       "A segment of the path is complete after standstill within the tolerances for this long"},
      {"max_cross_track_m",
       &T::max_cross_track_m,
       {0.01, 10},
       "Abort beyond this distance from the path"},
      {"max_heading_error_deg",
       &T::max_heading_error_rad,
       {5, 180},
       "Abort beyond this heading error",
       kDeg},
      {"max_tilt_deg", &T::max_tilt_rad, {5, 90}, "Abort beyond this roll or pitch", kDeg},
      {"time_limit_factor",
       &T::time_limit_factor,
       {1, 100},
       "Abort after this many times the nominal duration of the course"},
      {"min_battery_v", &T::min_battery_v, {0, 20}, "Abort below this battery voltage"},
      {"stall_s",
       &T::stall_s,
       {0.1, 30},
       "Abort after a track has stood still for this long although it is commanded to move"},
      {"disagreement_radps",
       &T::disagreement_radps,
       {0.05, 10},
       "Largest difference between the yaw rates of gyro and encoders"},
      {"disagreement_s",
       &T::disagreement_s,
       {0.1, 30},
       "Abort after the difference has been larger for this long"},
      {"turn_slip_share",
       &T::turn_slip_share,
       {0, 1},
       "Abort when the total difference between gyro and encoders exceeds this share of the "
       "turn plus 6 deg; the limit is higher for a robot that is not identified"},
      {"disturbance_radps",
       &T::disturbance_radps,
       {0.05, 10},
       "Difference between the yaw rates of gyro and encoders that counts as a disturbance, "
       "from which the robot recovers"},
      {"recovery_speed_share",
       &T::recovery_speed_share,
       {0.1, 1},
       "Share of the course's speed after a disturbance, until the robot heads back to the path"},
      {"recovery_window_m",
       &T::recovery_window_m,
       {0, 1},
       "After a disturbance, the path is searched this far before and behind the last position "
       "on it"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> bridge_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 2> kKeys = {{
      {"command_life_ms",
       &T::command_life_s,
       {20, 190},
       "Lifetime of a command: the robot stops if no newer one arrives within it; the robot "
       "refuses 200 and more",
       kMs},
      {"max_sample_age_ms",
       &T::max_sample_age_s,
       {10, 200},
       "No command is sent in response to a sample older than this",
       kMs},
  }};
  return kKeys;
}

}  // namespace tp100::config
