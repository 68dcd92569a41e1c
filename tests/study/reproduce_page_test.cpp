#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "sim/robot/options.h"
#include "sim/study/commands.h"
#include "sim/study/reproduce.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;

Reproduction made_up(double fused_cm) {
  Reproduction what;
  what.reference = load({}).robot;
  what.runs = 1;
  for (const SlopeRow& row : slope_rows())
    what.slopes.push_back({row.slope_deg, row.paper_left.value_or(0.1) + 0.015,
                           row.paper_right.value_or(0.1), 0.0, true});
  CourseStudy one;
  one.course = "1-curve";
  one.robot = what.reference.name;
  one.setup = "flat";
  one.board = "native";
  one.runs = one.completed = 1;
  one.distance_m = 2.0;
  one.forms = {{"eqs_1_5", {.max_position_error_m = 0.05}},
               {"extended", {.max_position_error_m = 0.002, .max_yaw_error_rad = 0.01}}};
  one.judged.push_back(
      {"1-curve", one.robot, "fused max on the level", "cm", 0.6, {fused_cm, fused_cm, 1}});
  what.studies.push_back(one);
  return what;
}

TEST(Reproduction, SaysWhichLimitDoesNotHold) {
  EXPECT_TRUE(all_hold(made_up(0.5)));
  const Reproduction missed = made_up(0.7);
  EXPECT_FALSE(all_hold(missed));
  EXPECT_THAT(reproduction_table(missed), HasSubstr("DOES NOT HOLD"));
  EXPECT_THAT(reproduction_page(made_up(0.5)),
              HasSubstr("<td>0.50</td><td>0.60</td><td class='t'>holds</td><td>0.50</td>"));
  EXPECT_THAT(reproduction_page(missed), HasSubstr("<td class='missed'>0.70</td><td>0.60</td>"
                                                   "<td class='missed t'>exceeded</td>"));
  const auto json = nlohmann::json::parse(reproduction_json(missed));
  EXPECT_EQ(json["all_hold"], false);
  EXPECT_EQ(json["studies"][0]["figures"][0]["holds"], false);
  EXPECT_NEAR(json["slope_max_difference"].get<double>(), 0.015, 1e-12);
  EXPECT_EQ(json["studies"][0]["paper"]["max_position_error_cm"], 1.2028);
  // Nor does a figure that is no number, or a run that was not completed.
  EXPECT_FALSE(all_hold(made_up(std::numeric_limits<double>::infinity())));
  EXPECT_FALSE(all_hold(made_up(std::numeric_limits<double>::quiet_NaN())));
  Reproduction aborted = made_up(0.5);
  aborted.studies[0].completed = 0;
  EXPECT_FALSE(all_hold(aborted));
}

TEST(Reproduction, ThePageSaysFirstWhatItCameTo) {
  Reproduction what = made_up(0.5);
  what.date = "2026-05-31 14:05 UTC";
  what.program = "tp100-sim 1.2.3";
  const std::string page = reproduction_page(what);
  const std::string top = page.substr(0, page.find("<h2"));
  for (const char* part : {"<p class='verdict good'>2 of 2 limits hold; every run was completed.",
                           "2026-05-31 14:05 UTC", "tp100-sim 1.2.3", "end-loaded"})
    EXPECT_THAT(top, HasSubstr(part));
  EXPECT_THAT(
      reproduction_page(made_up(0.7)),
      HasSubstr("<p class='verdict bad'>1 of 2 limits hold; every run was completed. Exceeded: "
                "1-curve flat end-loaded fused max on the level."));
}

TEST(Reproduction, ShowsErrorsOverTimeAndNoCaptionTwice) {
  Reproduction what = made_up(0.5);
  report::RunResult& run = what.studies[0].shown.result;
  run.has_camera = true;
  for (int i = 0; i < 10; ++i) {
    report::TrajectoryPoint& point = run.points.emplace_back();
    point.t_s = i;
    point.truth.x_m = 0.1 * i;
    for (Pose& pose : point.estimates.values) pose = point.truth;
    point.estimates[PoseSource::kModel].y_m = 0.01 * i;
  }
  what.studies.push_back(what.studies[0]);
  what.studies.back().setup = "stand";
  const std::string page = reproduction_page(what);
  const auto times = [&](const std::string& part) {
    int count = 0;
    for (std::size_t at = 0; (at = page.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(times("aria-label='Path'"), 2);
  EXPECT_EQ(times("aria-label='Position error'"), 1) << "on a stand nothing is known of errors";
  EXPECT_EQ(times("aria-label='Yaw error'"), 1);
  EXPECT_EQ(times("Course 1-curve, flat: seed"), 1);
  EXPECT_EQ(times("Course 1-curve, stand: seed"), 1);
  EXPECT_GE(times("stroke-opacity='.45'"), 4) << "the truth is a band";
}

TEST(Reproduction, ShowsTheModelAsItIsJudgedRestartedAfterEachPush) {
  Reproduction what = made_up(0.5);
  report::RunResult& run = what.studies[0].shown.result;
  for (int i = 0; i < 10; ++i) {
    report::TrajectoryPoint& point = run.points.emplace_back();
    point.t_s = i;
    point.truth.x_m = point.estimates[PoseSource::kModel].x_m = 0.1 * i;
    // Pushed aside between 2.5 and 4.5 s, which the model does not see.
    if (i > 2) point.truth.y_m = i < 5 ? 0.05 * (i - 2) : 0.15;
  }
  const auto model = [](const report::TrajectoryPoint& point) -> const Pose& {
    return point.estimates[PoseSource::kModel];
  };
  run.disturbances = {{2.5, 4.5}};
  const report::RestartedPoses shown = report::restarted_poses(run.points, run.disturbances, model);
  EXPECT_EQ(shown.restarts, std::vector<std::size_t>{5});
  for (std::size_t i = 0; i < run.points.size(); ++i) {
    ASSERT_EQ(shown.poses[i].has_value(), i < 3 || i > 4) << i;
    if (!shown.poses[i]) continue;
    EXPECT_NEAR(shown.poses[i]->y_m, run.points[i].truth.y_m, 1e-12) << i;
  }
  EXPECT_NEAR(report::pose_errors_between(run.points, run.disturbances, model).max_position_error_m,
              0.0, 1e-12);
  const std::string page = reproduction_page(what);
  EXPECT_THAT(page, HasSubstr(">model, restarted<"));
  EXPECT_THAT(page, HasSubstr(">its restart<"));
  EXPECT_THAT(page, HasSubstr("reset to the truth"));
  run.disturbances.clear();
  EXPECT_THAT(reproduction_page(what), testing::Not(HasSubstr("model, restarted")));
}

TEST(Reproduction, SetsThePapersTablesAndEq7BesideTheEmulatedRobot) {
  Reproduction what = made_up(0.5);
  what.turns = {{"on the spot", -0.08, 0.08, 0.2715, 0.5}};
  const std::string page = reproduction_page(what);
  const auto cell = [](double value, int decimals = 4) {
    return "<td>" + text::format("%.*f", decimals, value) + "</td>";
  };
  model::WheelbaseGeometry geometry;
  for (const double gamma : {geometry.gamma, 0.0, 1.0}) {
    geometry.gamma = gamma;
    EXPECT_THAT(page, HasSubstr(cell(model::equivalent_wheelbase_m(geometry)))) << gamma;
  }
  const course::EmulatedBody& body = what.reference.emulated.body;
  EXPECT_THAT(page, HasSubstr(cell(body.gauge_m +
                                   body.axle_spacing_m * body.axle_spacing_m / body.gauge_m)));
  const model::TrackParameters& found = what.reference.model;
  for (const double wheelbase_m :
       {0.2715, found.wheelbase_m, found.wheelbase_tight_m, found.wheelbase_spin_m,
        what.reference.baselines[model::kEqsFitted]->wheelbase_m})
    EXPECT_THAT(page, HasSubstr(cell(wheelbase_m)));
  EXPECT_THAT(page, HasSubstr("0.922 kg"));
  EXPECT_THAT(page, HasSubstr("200 mm x 185 mm x 60 mm"));
  // Both columns of table 3 and those of both of our forms.
  const double slip_angle_deg =
      what.reference.baselines[model::kEqsFitted]->slip_angle_straight_rad * kDegPerRad;
  EXPECT_THAT(page, HasSubstr("<td>0.404</td><td>0.000</td>" + cell(slip_angle_deg, 3)));
  EXPECT_THAT(page, HasSubstr("<td>0.1188</td><td>0.1188</td>"));
  EXPECT_THAT(page, testing::Not(HasSubstr("Climbing a step"))) << "it was not driven";
}

TEST(Reproduction, ShowsThePaperBesideEqs15AndTheExtendedModel) {
  const Reproduction what = made_up(0.5);
  EXPECT_THAT(
      reproduction_page(what),
      HasSubstr("<td>1.20</td><td>-</td><td>5.00</td><td>0.20</td><td>0.50 (limit 0.60)</td>"));
  // Of two metres.
  EXPECT_THAT(reproduction_table(what), HasSubstr("2.50 / 2.50"));
  EXPECT_THAT(reproduction_table(what), HasSubstr("0.10 / 0.10"));
  const auto forms = nlohmann::json::parse(reproduction_json(what))["studies"][0]["forms"];
  EXPECT_EQ(forms["eqs_1_5"]["max_position_error_m"], 0.05);
  EXPECT_EQ(forms["extended"]["max_yaw_error_rad"], 0.01);
}

}  // namespace
}  // namespace tp100::sim
