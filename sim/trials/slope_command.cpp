#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "identify/model_fit.h"
#include "model/track_model.h"
#include "sim/body/ode_body.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"
#include "text/format.h"
#include "text/json_writer.h"

namespace tp100::sim {
namespace {

constexpr double kRunInS = 0.5;
constexpr double kSameSlopeRad = 5.0 * kRadPerDeg;  // else it fell over or came to the end
constexpr double kMeasureS = 2.0;

// Boards of slope_drives(): as many as a robot file holds.
constexpr std::array<double, model::kMaxSlopes> kBoardsDeg = {-28, -22, -16, -8, 8, 16, 22, 28};
constexpr double kOnBoardS = 6.0;
constexpr double kHeldS = 1.0;  // before and after it
constexpr double kSampleS = 0.005;

/// A ramp that the drive does not leave, and where it starts.
course::Terrain slope_of(double slope_rad, double length_m) {
  course::Terrain terrain;
  if (slope_rad <= 0.0) return terrain;
  course::Ramp ramp{};
  ramp.height_m = length_m * std::sin(slope_rad);
  ramp.up_rad = ramp.down_rad = slope_rad;
  ramp.width_m = length_m;
  ramp.place.x_m = ramp.length_m() / 2.0;
  terrain.ramps.push_back(ramp);
  return terrain;
}

/// On a ramp, `along_m` from its foot; its nose points up, or down if the slope is negative.
Pose standing(double slope_rad, double along_m) {
  const double steep_rad = std::abs(slope_rad);
  return {.x_m = along_m * std::cos(steep_rad),
          .z_m = along_m * std::sin(steep_rad),
          .pitch_rad = -slope_rad,
          .yaw_rad = slope_rad < 0.0 ? kPi : 0.0};
}

/// A run straight up a board, or down if the slope is negative, with what a person measures of it;
/// nothing if the robot slips by more than three quarters or does not stay on the board.
std::optional<identify::RecordedDrive> on_board(const course::Emulated& robot, double slope_rad) {
  const double middle_m = 2.0 * robot.body.length_m + kSlopeTrackMps * kOnBoardS;
  OdeBody body(robot.body, standing(slope_rad, middle_m), false,
               slope_of(std::abs(slope_rad), 2.0 * middle_m));
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

void print_table(const std::string& robot, const std::vector<SlopeSlip>& measured) {
  std::printf("Slip against slope at %.2f m/s of track, robot %s\n\n", kSlopeTrackMps,
              robot.c_str());
  std::printf(
      "  slope        ours, measured     paper, as printed       ours - paper     ours, turn\n");
  std::printf(
      "  [deg]       left     right        left     right       left     right      [deg/s]\n");
  double worst = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    const SlopeSlip& slip = measured[i];
    std::printf("  %5.0f  ", row.slope_deg);
    if (!slip.climbed) {
      std::printf("   does not climb\n");
      continue;
    }
    std::printf("    %5.3f     %5.3f", slip.left, slip.right);
    if (row.paper_left && row.paper_right) {
      const double left = slip.left - *row.paper_left;
      const double right = slip.right - *row.paper_right;
      worst = std::max({worst, std::abs(left), std::abs(right)});
      std::printf("       %5.3f     %5.3f     %+6.3f    %+6.3f", *row.paper_left, *row.paper_right,
                  left, right);
    } else {
      std::printf("           -         -          -         -");
    }
    std::printf("      %+7.2f\n", slip.yaw_rate_radps / kRadPerDeg);
  }
  std::printf(
      "\nlargest difference %.3f\n\n"
      "The reference robot's table is fitted through its contact creep, not predicted, and the "
      "slip\non the level is a track speed deficit that no physics explains: see its file. "
      "The paper has no\nrow for 4 deg.\n",
      worst);
}

void print_json(const std::string& robot, const std::vector<SlopeSlip>& measured) {
  std::string out;
  text::JsonWriter json(out);
  json.begin_object().field("robot", robot).field("track_mps", kSlopeTrackMps);
  json.key("slopes").begin_array();
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    const SlopeSlip& slip = measured[i];
    const auto if_climbed = [&slip](double value) {
      return slip.climbed ? std::optional(value) : std::nullopt;
    };
    json.begin_object().field("slope_deg", row.slope_deg).field("climbed", slip.climbed);
    json.field("slip_left", if_climbed(slip.left)).field("slip_right", if_climbed(slip.right));
    json.field("yaw_rate_radps", if_climbed(slip.yaw_rate_radps));
    json.field("paper_slip_left", row.paper_left).field("paper_slip_right", row.paper_right);
    json.end_object();
  }
  json.end_array().end_object();
  std::printf("%s\n", out.c_str());
}

}  // namespace

std::span<const SlopeRow> slope_rows() {
  static const std::vector<SlopeRow> rows = [] {
    std::vector<SlopeRow> all;
    all.reserve(model::kSlipRows.size() + 1);
    for (const model::SlipRow& row : model::kSlipRows)
      all.push_back({row.slope_deg, row.left, row.right});
    all.insert(all.begin() + 1, {4.0, std::nullopt, std::nullopt});
    return all;
  }();
  return rows;
}

MeanMotion mean_motion(Body& body, const TrackSpeeds& tracks, double run_in_s, double measured_s) {
  const auto steps = [](double s) { return std::lround(s / kPhysicsStepS); };
  for (long i = 0; i < steps(run_in_s); ++i) body.step(tracks.left_mps, tracks.right_mps);
  MeanMotion sum;
  for (long i = 0; i < steps(measured_s); ++i) {
    body.step(tracks.left_mps, tracks.right_mps);
    const BodyState& state = body.state();
    const double cos_pitch = std::cos(state.pose.pitch_rad);
    sum.forward_mps += state.velocity_mps[0] * std::cos(state.pose.yaw_rad) * cos_pitch +
                       state.velocity_mps[1] * std::sin(state.pose.yaw_rad) * cos_pitch -
                       state.velocity_mps[2] * std::sin(state.pose.pitch_rad);
    sum.yaw_rate_radps += state.rate_radps[2];
  }
  const auto count = static_cast<double>(steps(measured_s));
  return {sum.forward_mps / count, sum.yaw_rate_radps / count};
}

SlopeSlip measure_slope(const course::EmulatedBody& values, double slope_rad, double track_mps) {
  const double start_m = 2.0 * values.length_m;
  const double distance_m = std::abs(track_mps) * (kRunInS + kMeasureS);
  const course::Terrain terrain = slope_of(slope_rad, 2.0 * start_m + 4.0 * distance_m);
  OdeBody body(values, standing(slope_rad, start_m), false, terrain);
  const MeanMotion motion = mean_motion(body, {track_mps, track_mps}, kRunInS, kMeasureS);
  const double half_mps = motion.yaw_rate_radps * values.gauge_m / 2.0;
  SlopeSlip slip{slope_rad, 1.0 - (motion.forward_mps - half_mps) / track_mps,
                 1.0 - (motion.forward_mps + half_mps) / track_mps, motion.yaw_rate_radps};
  // It moved up the slope nose first, and did not merely spin its tracks.
  slip.climbed = std::max(slip.left, slip.right) < 0.9 &&
                 std::abs(-body.state().pose.pitch_rad - slope_rad) < kSameSlopeRad;
  return slip;
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

int run_slope(const SlopeCommand& command) {
  Options options;
  options.robot = command.robot;
  const course::Robot robot = load(options).robot;
  std::vector<SlopeSlip> measured;
  bool all_climbed = true;
  for (const SlopeRow& row : slope_rows()) {
    measured.push_back(
        measure_slope(robot.emulated.body, row.slope_deg * kRadPerDeg, kSlopeTrackMps));
    all_climbed = all_climbed && measured.back().climbed;
  }
  command.json ? print_json(robot.name, measured) : print_table(robot.name, measured);
  return all_climbed ? 0 : 1;
}

}  // namespace tp100::sim
