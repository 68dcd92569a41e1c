#include "sim/lab/body_slope.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "sim/body/ode_body.h"
#include "sim/trials/commands.h"

namespace tp100::sim {
namespace {

constexpr double kRunInS = 0.5;
constexpr double kMeasureS = 2.0;

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
  const course::Terrain terrain = ramp_of(slope_rad, 2.0 * start_m + 4.0 * distance_m);
  OdeBody body(values, standing_on_ramp(slope_rad, start_m), false, terrain);
  const MeanMotion motion = mean_motion(body, {track_mps, track_mps}, kRunInS, kMeasureS);
  const double half_mps = motion.yaw_rate_radps * values.gauge_m / 2.0;
  SlopeSlip slip{slope_rad, 1.0 - (motion.forward_mps - half_mps) / track_mps,
                 1.0 - (motion.forward_mps + half_mps) / track_mps, motion.yaw_rate_radps};
  // It moved up the slope nose first, and did not merely spin its tracks.
  slip.climbed = std::max(slip.left, slip.right) < 0.9 &&
                 std::abs(-body.state().pose.pitch_rad - slope_rad) < kSameSlopeRad;
  return slip;
}

int run_slope(const std::string& name) {
  Options options;
  options.robot = name;
  const course::Robot robot = load(options).robot;
  std::vector<SlopeSlip> measured;
  bool all_climbed = true;
  for (const SlopeRow& row : slope_rows()) {
    measured.push_back(
        measure_slope(robot.emulated.body, row.slope_deg * kRadPerDeg, kSlopeTrackMps));
    all_climbed = all_climbed && measured.back().climbed;
  }
  print_table(robot.name, measured);
  return all_climbed ? 0 : 1;
}

}  // namespace tp100::sim
