#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "identify/model_fit.h"
#include "model/track_model.h"
#include "sim/body/ode_body.h"
#include "sim/trials/commands.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

// As many boards as a robot file holds.
constexpr std::array<double, model::kMaxSlopes> kBoardsDeg = {-28, -22, -16, -8, 8, 16, 22, 28};
constexpr double kOnBoardS = 6.0;
constexpr double kHeldS = 1.0;  // before and after it
constexpr double kSampleS = 0.005;

/// A run straight up a board, or down if the slope is negative, with what a person measures of it;
/// nothing if the robot slips by more than three quarters or does not stay on the board.
std::optional<identify::RecordedDrive> on_board(const course::Emulated& robot, double slope_rad) {
  const double middle_m = 2.0 * robot.body.length_m + kSlopeTrackMps * kOnBoardS;
  OdeBody body(robot.body, standing_on_ramp(slope_rad, middle_m), false,
               ramp_of(std::abs(slope_rad), 2.0 * middle_m));
  identify::RecordedDrive drive;
  double track_m = 0.0;
  const auto steps = static_cast<int>(std::lround((2.0 * kHeldS + kOnBoardS) / kPhysicsStepS));
  const auto of_sample = static_cast<int>(std::lround(kSampleS / kPhysicsStepS));
  Pose begin{};
  for (int i = 0; i <= steps; ++i) {
    const double t_s = i * kPhysicsStepS;
    const double mps = t_s >= kHeldS && t_s < kHeldS + kOnBoardS ? kSlopeTrackMps : 0.0;
    if (track_m == 0.0) begin = body.state().pose;
    if (i % of_sample == 0) {
      const std::int64_t counts = std::llround(track_m * robot.encoder.counts_per_metre);
      drive.samples.push_back({t_s, counts, counts, 0.0});
    }
    body.step(mps, mps);
    track_m += mps * kPhysicsStepS;
  }
  const Pose& end = body.state().pose;
  const double along_m = (end.x_m - begin.x_m) * std::cos(begin.yaw_rad);
  if (along_m < 0.25 * track_m || std::abs(end.pitch_rad + slope_rad) > kSameSlopeRad) return {};
  drive.measured.slope_rad = slope_rad;
  drive.measured.distance_m =
      std::hypot(end.x_m - begin.x_m, end.y_m - begin.y_m, end.z_m - begin.z_m);
  drive.measured.turned_rad = wrap_angle(end.yaw_rad - begin.yaw_rad);
  return drive;
}

}  // namespace

course::Terrain ramp_of(double slope_rad, double length_m) {
  course::Terrain terrain;
  if (slope_rad <= 0.0) return terrain;
  course::Ramp ramp{};
  ramp.height_m = length_m * std::sin(slope_rad);
  ramp.up_rad = ramp.down_rad = slope_rad;
  ramp.width_m = length_m;
  ramp.place.x_m = ramp.length_m() / 2.0;
  terrain.obstacles.emplace_back(ramp);
  return terrain;
}

Pose standing_on_ramp(double slope_rad, double along_m) {
  const double steep_rad = std::abs(slope_rad);
  return {.x_m = along_m * std::cos(steep_rad),
          .z_m = along_m * std::sin(steep_rad),
          .pitch_rad = -slope_rad,
          .yaw_rad = slope_rad < 0.0 ? kPi : 0.0};
}

std::vector<identify::RecordedDrive> slope_drives(const course::Robot& robot, std::uint64_t seed) {
  std::vector<identify::RecordedDrive> drives;
  if (robot.emulated.contact_law != course::ContactLaw::kOde) return drives;
  const identify::IdentifySettings assumed;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (const double slope_deg : kBoardsDeg) {
    std::optional<identify::RecordedDrive> drive = on_board(robot.emulated, slope_deg * kRadPerDeg);
    if (!drive) continue;
    drive->name =
        text::format("board-%s-%02.0f-", slope_deg > 0.0 ? "up" : "down", std::abs(slope_deg)) +
        robot.name + "-" + std::to_string(seed);
    *drive->measured.distance_m += assumed.tape_sd_m * normal(random);
    *drive->measured.turned_rad += assumed.protractor_sd_rad * normal(random);
    drives.push_back(*std::move(drive));
  }
  return drives;
}

}  // namespace tp100::sim
