#include <array>
#include <string_view>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "report/html_page.h"
#include "sim/lab/published.h"
#include "sim/lab/reproduce.h"
#include "sim/lab/reproduce_charts.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using report::Rows;
using text::format;

std::string fixed(double value, int decimals) { return format("%.*f", decimals, value); }

std::string mm(double metres) { return fixed(metres * 1e3, 0) + " mm"; }

Rows robot_table(const course::Robot& robot) {
  const course::EmulatedBody& body = robot.emulated.body;
  return {{"item", "paper, printed", "emulated robot", "remark"},
          {"mass without electronics", "0.650 kg", "-", "the emulated body is one rigid box"},
          {"mass", "0.922 kg", fixed(body.mass_kg, 3) + " kg", ""},
          {"size", "200 mm x 185 mm x 60 mm",
           mm(body.width_m) + " x " + mm(body.length_m) + " x " + mm(body.height_m),
           "printed as length x width x height; only width x length x height agrees with a track "
           "of 185 mm"},
          {"wheel size", "24 mm", mm(body.wheel_radius_m),
           "taken as a radius; ours with a track of 2 mm around it"},
          {"track width", "45 mm", mm(body.shoe_width_m), ""},
          {"track length", "185 mm", mm(robot.shape.length_m),
           "axle spacing " + mm(body.axle_spacing_m) + " and a wheel at each end"}};
}

void write_wheelbase(report::HtmlPage& page, const Reproduction& what) {
  const model::TrackParameters& found = what.reference.model;
  const auto& eqs = what.reference.baselines[model::kEqsFitted];
  WheelbaseGeometry geometry;
  Rows rows = {{"quantity", "value", "from"},
               {"a, length [m]", fixed(geometry.length_m, 4), "table 2"},
               {"b, width [m]", fixed(geometry.width_m, 4), "table 2"},
               {"offset in x [m]", fixed(geometry.offset_x_m, 5), "table 2"},
               {"offset in y [m]", fixed(geometry.offset_y_m, 5), "table 2"},
               {"gamma", fixed(geometry.gamma, 3),
                "ours: the paper does not print it; with this value eq 7 gives the printed L"}};
  const auto add = [&rows](const std::string& name, double value_m, const std::string& from) {
    rows.push_back({name, fixed(value_m, 4), from});
  };
  const auto by_eq_7 = [&](const std::string& name, const std::string& from) {
    add(name, equivalent_wheelbase_m(geometry), from);
  };
  by_eq_7("L by eq 7 [m]", "all of the above");
  geometry.gamma = 0.0;
  by_eq_7("L by eq 7, gamma 0 [m]", "the same without the offset in y");
  geometry.gamma = 1.0;
  by_eq_7("L by eq 7, gamma 1 [m]", "the same with the offsets as they are");
  add("L, printed [m]", kPublishedWheelbaseM, "table 2");
  const course::EmulatedBody& body = what.reference.emulated.body;
  geometry = {.length_m = body.axle_spacing_m,
              .width_m = body.gauge_m,
              .offset_x_m = body.com_forward_m,
              .offset_y_m = body.com_left_m,
              .gamma = 1.0};
  by_eq_7("L by eq 7, of the emulated robot [m]",
          format("its axle spacing, gauge and centre of mass, %.4f, %.4f, %.4f and %.4f m",
                 body.axle_spacing_m, body.gauge_m, body.com_forward_m, body.com_left_m));
  for (const BodyTurn& turn : what.turns)
    add("L of the emulated body, " + turn.name + " [m]", turn.wheelbase_m,
        format("its exact motion, tracks at %.2f and %.2f m/s", turn.left_mps, turn.right_mps));
  if (eqs) add("L of eqs 1-5, fitted [m]", eqs->wheelbase_m, "identification drives");
  const auto of_turns = [&](const std::string& turns, const model::TurnShape& shape) {
    add(turns + " [m]", turn_of(found, model::Mode::kExtended, shape).wheelbase_m,
        "identification drives");
  };
  of_turns("L of the extended model, wide turns", {});
  of_turns("... medium arcs", {.medium = 1.0});
  of_turns("... tight arcs", {.medium = 1.0, .arc = 1.0});
  of_turns("... on the spot", {.medium = 1.0, .arc = 1.0, .spin = 1.0});
  page.table(rows,
             "Eq 7, L = 2 ((b/2 - gamma dy)^2 + (a/2 - dx)^2) / (b/2 - gamma dy), and the "
             "wheelbase with which the emulated body turns. Its load distribution was chosen so "
             "that these agree: the agreement confirms the model's arithmetic, not eq 7.");
}

Rows slip_table(const course::Robot& robot) {
  Rows rows = {{"parameter", "paper: straight", "turning", "eqs 1-5 fitted: straight", "turning",
                "extended model: straight", "turning"}};
  const auto& eqs = robot.baselines[model::kEqsFitted];
  const model::TrackParameters& extended = robot.model;
  const auto add = [&](const std::string& name, double straight, double turning,
                       model::TrackParameter of_straight, model::TrackParameter of_turning,
                       double unit, int decimals) {
    const auto ours = [&](const model::TrackParameters& from, model::TrackParameter value) {
      return fixed(from.*value / unit, decimals);
    };
    rows.push_back({name, fixed(straight, decimals), fixed(turning, decimals),
                    eqs ? ours(*eqs, of_straight) : "-", eqs ? ours(*eqs, of_turning) : "-",
                    ours(extended, of_straight), ours(extended, of_turning)});
  };
  using model::TrackParameters;
  add("slip angle [deg]", kPublishedSlipAngleDeg, kPublishedSlipAngleTurningDeg,
      &TrackParameters::slip_angle_straight_rad, &TrackParameters::slip_angle_turning_rad,
      kRadPerDeg, 3);
  add("slip ratio, left", kPublishedSlipLeft, kPublishedSlipLeft, &TrackParameters::slip_left,
      &TrackParameters::slip_left, 1.0, 4);
  add("slip ratio, right", kPublishedSlipRight, kPublishedSlipRight, &TrackParameters::slip_right,
      &TrackParameters::slip_right, 1.0, 4);
  return rows;
}

Rows slope_table(const Reproduction& what) {
  Rows rows = {{"slope [deg]", "ours left", "ours right", "paper left", "paper right"}};
  for (std::size_t i = 0; i < what.slopes.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    rows.push_back({fixed(row.slope_deg, 0), fixed(what.slopes[i].left, 3),
                    fixed(what.slopes[i].right, 3),
                    row.paper_left ? fixed(*row.paper_left, 3) : "-",
                    row.paper_right ? fixed(*row.paper_right, 3) : "-"});
  }
  return rows;
}

/// In the order of model::ClimbPhase.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kPhases = {
    {{"approach", "on the ground in front of the block"},
     {"riser", "eq 6: the front of the track rolls up the riser"},
     {"wrap", "the edge passes around the front of the track"},
     {"cross", "the track slides over the edge, its rear on the ground"},
     {"tip", "the body falls forward about the near edge"},
     {"flat", "flat on the block"},
     {"tip off", "the body falls forward about the far edge"},
     {"nose", "the nose is on the ground, the track runs over the far edge"},
     {"slide off", "the rear end comes down the far face"},
     {"down", "the model is flat behind the block, the body not yet"}}};

Rows phase_table(const ClimbCheck& climb) {
  Rows rows = {
      {"phase", "from [cm]", "model, rms [deg]", "paper's eq 6, rms [deg]", "what happens"}};
  for (const ClimbPhaseCheck& phase : climb.phases) {
    const auto& [name, meaning] = kPhases.at(static_cast<std::size_t>(phase.phase));
    rows.push_back({std::string(name), fixed(phase.from_m * report::kCmPerM, 2),
                    fixed(phase.model_rms_rad * kDegPerRad, 2),
                    fixed(phase.paper_rms_rad * kDegPerRad, 2), std::string(meaning)});
  }
  return rows;
}

}  // namespace

double equivalent_wheelbase_m(const WheelbaseGeometry& geometry) {
  const double lateral = geometry.width_m / 2.0 - geometry.gamma * geometry.offset_y_m;
  const double longitudinal = geometry.length_m / 2.0 - geometry.offset_x_m;
  return 2.0 * (lateral * lateral + longitudinal * longitudinal) / lateral;
}

void write_tables(report::HtmlPage& page, const Reproduction& what) {
  if (!what.slopes.empty()) {
    page.heading("The robot (table 1)");
    page.table(robot_table(what.reference), "The paper's table beside the robot's file");
    page.heading("Equivalent wheelbase (table 2, eq 7)");
    write_wheelbase(page, what);
    page.heading("Slip parameters (table 3)");
    page.table(
        slip_table(what.reference),
        "Another floor, another robot: the values are not meant to agree. Both forms of ours "
        "have one pair of slip ratios for all manoeuvres, as the paper has; what a turn "
        "costs beyond it, the extended model describes by constants that the paper does "
        "not have.");
    page.heading("Slip against slope (table 4, figure 11)");
    page.table(slope_table(what),
               format("Largest difference %.3f, limit %.2f. The paper has no row for 4 deg.",
                      worst_slope_difference(what), kSlopeLimit));
    page.figures(slope_charts(what), "Slip against slope. Lines: ours. Dots: the paper's table.");
  }
  if (what.climb) {
    page.heading("Climbing a step (eq 6)");
    page.table(
        phase_table(*what.climb),
        format("Pitch of the model minus that of the body, by the model's phases: block of %.0f mm "
               "by %.0f mm, tracks without deficit and with hardly any creep. Travel of the tracks "
               "counts from where they touch the block. The paper prints eq 6 for the riser alone; "
               "beyond it, its line has the same continuation as the model, but tips where the "
               "centre of mass passes the edge.",
               what.climb->height_m * 1e3, what.climb->depth_m * 1e3));
    page.figure(climb_chart(*what.climb),
                "The emulated body, the model, and the model with the paper's eq 6 on the riser");
  }
}

}  // namespace tp100::sim
