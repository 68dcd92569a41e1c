#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "sim/body/ode_body.h"
#include "sim/robot/options.h"
#include "sim/study/commands.h"
#include "sim/study/study.h"
#include "text/key.h"

namespace tp100::sim {
namespace {

constexpr double kRunInS = 0.5;
constexpr double kMeasureS = 2.0;

constexpr std::size_t kSlipRows = model::kSlipRows.size();

/// The paper's rows, and one of 4 deg after the first.
constexpr std::array<SlopeRow, kSlipRows + 1> rows_to_drive() {
  std::array<SlopeRow, kSlipRows + 1> rows{};
  for (std::size_t i = 0; i < kSlipRows; ++i) {
    const model::SlipRow& row = model::kSlipRows[i];
    rows[i == 0 ? 0 : i + 1] = {row.slope_deg, row.left, row.right};
  }
  rows[1].slope_deg = 4;
  return rows;
}
constexpr auto kRows = rows_to_drive();

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

/// How fast the body is over either track, along its own x axis.
double forward_mps(const BodyState& state) {
  const double cos_pitch = std::cos(state.pose.pitch_rad);
  return state.velocity_mps[0] * std::cos(state.pose.yaw_rad) * cos_pitch +
         state.velocity_mps[1] * std::sin(state.pose.yaw_rad) * cos_pitch -
         state.velocity_mps[2] * std::sin(state.pose.pitch_rad);
}

double signed_deviation(double measured, const std::optional<double>& paper) {
  return paper ? measured - *paper : 0.0;
}

void print_table(const std::string& robot, const std::array<SlopeSlip, kRows.size()>& measured) {
  std::printf("Slip against slope at %.2f m/s of track, robot %s\n\n", kSlopeTrackMps,
              robot.c_str());
  std::printf(
      "  slope        ours, measured     paper, as printed       ours - paper     ours, turn\n");
  std::printf(
      "  [deg]       left     right        left     right       left     right      [deg/s]\n");
  double worst = 0.0;
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    const SlopeRow& row = kRows[i];
    const SlopeSlip& slip = measured[i];
    std::printf("  %5.0f  ", row.slope_deg);
    if (!slip.climbed) {
      std::printf("   does not climb\n");
      continue;
    }
    std::printf("    %5.3f     %5.3f", slip.left, slip.right);
    if (row.paper_left && row.paper_right) {
      const double left = signed_deviation(slip.left, row.paper_left);
      const double right = signed_deviation(slip.right, row.paper_right);
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

std::string json_of(const SlopeRow& row, const SlopeSlip& slip) {
  const auto number = [](const std::optional<double>& value) {
    return value ? text::number_text(*value) : std::string("null");
  };
  const auto measured = [&](double value) {
    return number(slip.climbed ? std::optional<double>(value) : std::nullopt);
  };
  return R"({"slope_deg":)" + number(row.slope_deg) + R"(,"climbed":)" +
         (slip.climbed ? "true" : "false") + R"(,"slip_left":)" + measured(slip.left) +
         R"(,"slip_right":)" + measured(slip.right) + R"(,"yaw_rate_radps":)" +
         measured(slip.yaw_rate_radps) + R"(,"paper_slip_left":)" + number(row.paper_left) +
         R"(,"paper_slip_right":)" + number(row.paper_right) + "}";
}

void print_json(const std::string& robot, const std::array<SlopeSlip, kRows.size()>& measured) {
  std::string rows;
  for (std::size_t i = 0; i < kRows.size(); ++i)
    rows += (i == 0 ? "" : ",") + json_of(kRows[i], measured[i]);
  std::printf(R"({"robot":%s,"track_mps":%s,"slopes":[%s]})"
              "\n",
              text::toml_string(robot).c_str(), text::number_text(kSlopeTrackMps).c_str(),
              rows.c_str());
}

}  // namespace

std::span<const SlopeRow> slope_rows() { return kRows; }

SlopeSlip measure_slope(const course::EmulatedBody& values, double slope_rad, double track_mps) {
  const double start_m = 2.0 * values.length_m;
  const double distance_m = std::abs(track_mps) * (kRunInS + kMeasureS);
  const course::Terrain terrain = slope_of(slope_rad, 2.0 * start_m + 4.0 * distance_m);
  OdeBody body(values,
               {.x_m = start_m * std::cos(slope_rad),
                .z_m = start_m * std::sin(slope_rad),
                .pitch_rad = -slope_rad},
               false, terrain);
  const int run_in = static_cast<int>(std::lround(kRunInS * 1e9 / kPhysicsStepNs));
  const int measured = static_cast<int>(std::lround(kMeasureS * 1e9 / kPhysicsStepNs));
  for (int i = 0; i < run_in; ++i) body.step(track_mps, track_mps);
  double forward = 0.0, turned = 0.0;
  for (int i = 0; i < measured; ++i) {
    body.step(track_mps, track_mps);
    forward += forward_mps(body.state());
    turned += body.state().rate_radps[2];
  }
  forward /= measured;
  turned /= measured;
  const double half = turned * values.gauge_m / 2.0;
  SlopeSlip slip{slope_rad, 1.0 - (forward - half) / track_mps, 1.0 - (forward + half) / track_mps,
                 turned};
  // Up the slope with the nose in front, and not merely grinding.
  slip.climbed = std::max(slip.left, slip.right) < 0.9 &&
                 std::abs(-body.state().pose.pitch_rad - slope_rad) < 5.0 * kRadPerDeg;
  return slip;
}

int run_slope(const SlopeCommand& command) {
  Options options;
  options.robot = command.robot;
  const course::Robot robot = load(options).robot;
  std::array<SlopeSlip, kRows.size()> measured{};
  bool all_climbed = true;
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    measured[i] =
        measure_slope(robot.emulated.body, kRows[i].slope_deg * kRadPerDeg, kSlopeTrackMps);
    all_climbed = all_climbed && measured[i].climbed;
  }
  command.json ? print_json(robot.name, measured) : print_table(robot.name, measured);
  return all_climbed ? 0 : 1;
}

}  // namespace tp100::sim
