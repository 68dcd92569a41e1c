// Results of a run as JSON, table and POSES.csv, and charts and pages of reports.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "core/statistics.h"
#include "report/chart.h"
#include "report/colours.h"
#include "report/html_page.h"
#include "report/result_text.h"
#include "report/run_result.h"

namespace tp100::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

RunResult a_run() {
  RunResult run;
  run.course = "2";
  run.board = "native";
  run.robot = "end-loaded";
  run.setup = "flat";
  run.seed = 7;
  run.completed = true;
  run.duration_s = 41.25;
  run.realtime_factor = 30.0;
  run.disturbances = {{8.0, 8.3}, {30.0, 30.3}};
  run.link.samples = 8000;
  run.loop = {{"steps", 8250.0}};
  run.points.emplace_back();
  return run;
}

RunFigures some_figures() {
  RunFigures figures;
  figures.estimates[PoseSource::kModel].emplace().max_position_error_m = 0.1 + 0.2;
  figures.estimates[PoseSource::kOdometry].emplace().mse_x_m2 = 1.25e-5;
  figures.baselines[model::kEqsFitted].emplace().max_position_error_m = 0.0394;
  figures.tracking.recovery = {{.begin_s = 8.0,
                                .detection_s = 0.03,
                                .peak_cross_track_m = 0.041,
                                .peak_yaw_error_rad = 0.25,
                                .settling_s = 1.5,
                                .overshoot_m = 0.002,
                                .shortcut_m = 0.0},
                               {.begin_s = 30.0}};
  return figures;
}

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

TEST(ResultJson, ARunThatNeverBeganHasNoFigures) {
  RunResult run = a_run();
  run.points.clear();
  const Json json = Json::parse(result_json(run, {}));
  for (const char* name : {"model", "odometry", "baselines", "tracking"})
    EXPECT_TRUE(json.at(name).is_null()) << name;
  EXPECT_THAT(result_table(run, {}), HasSubstr("The run never began: there is nothing to judge."));
  EXPECT_THAT(result_table(run, {}), Not(HasSubstr("cross-track")));
}

TEST(ResultJson, HasTheDocumentedKeysInOrder) {
  const Json json = Json::parse(result_json(a_run(), some_figures()));
  EXPECT_THAT(keys(json), ElementsAre("course", "board", "robot", "setup", "seed", "completed",
                                      "duration_s", "realtime_factor", "model", "odometry",
                                      "baselines", "tracking", "link", "loop"));
  const auto errors = ElementsAre("max_position_error_m", "mean_position_error_m",
                                  "rms_position_error_m", "final_position_error_m", "mse_x_m2",
                                  "mse_y_m2", "mse_yaw_rad2", "max_yaw_error_rad");
  EXPECT_THAT(keys(json["model"]), errors);
  EXPECT_THAT(keys(json["odometry"]), errors);
  EXPECT_THAT(keys(json["baselines"]), ElementsAre("eqs_1_5"));
  EXPECT_THAT(keys(json["baselines"]["eqs_1_5"]), errors);
  EXPECT_EQ(json["baselines"]["eqs_1_5"]["max_position_error_m"], 0.0394);
  EXPECT_THAT(keys(json["tracking"]),
              ElementsAre("max_cross_track_m", "rms_cross_track_m", "max_yaw_error_rad",
                          "recovery_s", "recovery", "false_alarms"));
  ASSERT_EQ(json["tracking"]["recovery"].size(), 2u);
  EXPECT_THAT(keys(json["tracking"]["recovery"][0]),
              ElementsAre("begin_s", "detection_s", "peak_cross_track_m", "peak_yaw_error_rad",
                          "settling_s", "overshoot_m", "shortcut_m"));
  EXPECT_EQ(json["tracking"]["recovery"][0]["detection_s"], 0.03);
  EXPECT_TRUE(json["tracking"]["recovery"][1]["settling_s"].is_null());
  EXPECT_EQ(json["tracking"]["recovery_s"].dump(), "[1.5,null]");
  EXPECT_EQ(json["link"]["samples"], 8000);
  EXPECT_EQ(json["loop"]["steps"], 8250.0);
  EXPECT_EQ(json["seed"], 7);
}

TEST(ResultJson, EachEstimateSaysHowOftenItsCovarianceHeldTheTruth) {
  RunFigures figures = some_figures();
  figures.within_2_sd[PoseSource::kModel] = Coverage{.position = 0.95, .yaw = 0.875};
  const Json json = Json::parse(result_json(a_run(), figures));
  EXPECT_EQ(json["model"]["within_2_sd"]["position"], 0.95);
  EXPECT_EQ(json["model"]["within_2_sd"]["yaw"], 0.875);
  EXPECT_FALSE(json["odometry"].contains("within_2_sd"));
}

TEST(ResultJson, IsOneLineWhoseNumbersReadBackExactlyWhateverTheNames) {
  const std::string text = result_json(a_run(), some_figures());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["model"]["max_position_error_m"].get<double>(), 0.1 + 0.2);
  RunResult run = a_run();
  run.completed = false;
  run.cause = "fence";
  run.course = "a\xff\n\"b";
  const std::string odd = result_json(run, {});
  EXPECT_EQ(odd.find('\n'), std::string::npos);
  EXPECT_EQ(Json::parse(odd)["cause"], "fence");
}

TEST(ResultJson, FusedIsThereOnlyIfACameraWas) {
  EXPECT_FALSE(Json::parse(result_json(a_run(), some_figures())).contains("fused"));
  RunFigures figures = some_figures();
  figures.estimates[PoseSource::kFused].emplace().max_position_error_m = 0.004;
  RunResult run = a_run();
  run.has_camera = true;
  const Json json = Json::parse(result_json(run, figures));
  EXPECT_EQ(json["fused"]["max_position_error_m"], 0.004);
  EXPECT_EQ(keys(json["fused"]), keys(json["model"]));
}

TEST(ResultTable, ShowsEachFigureInAHundredColumns) {
  RunFigures figures = some_figures();
  std::string text = result_table(a_run(), figures);
  EXPECT_THAT(text, HasSubstr("completed\n41.2 s of robot time"));
  EXPECT_THAT(text, HasSubstr("form: eqs_1_5                  3.94"));
  EXPECT_THAT(text,
              HasSubstr("disturbance at   8.0 s               0.03      4.10      14.3      1.50"));
  EXPECT_THAT(text,
              HasSubstr("disturbance at  30.0 s              never      0.00       0.0     never"));
  RunResult own = a_run();
  own.course = "my-own";
  own.completed = false;
  own.cause = "fence";
  for (auto& errors : figures.baselines) errors.emplace().max_position_error_m = 99.9;
  text = result_table(own, figures);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

/// All values of a pose differ from each other and from those of poses with other numbers.
Pose pose(double number) {
  return {.x_m = number + 0.1,
          .y_m = number + 0.2,
          .z_m = number + 0.3,
          .roll_rad = number + 0.4,
          .pitch_rad = number + 0.5,
          .yaw_rad = number + 0.6};
}

TEST(PosesCsv, HasAPoseOfEachKindWithAllItsValues) {
  RunResult run;
  run.points.push_back({.t_s = 70,
                        .truth = pose(10),
                        .world = pose(20),
                        .estimates = {{pose(30), pose(40), pose(50)}},
                        .progress_m = 60});
  const std::string csv = poses_csv(run);
  EXPECT_THAT(csv, testing::StartsWith("t_s,truth_x_m,truth_y_m,truth_z_m,truth_roll_rad,"
                                       "truth_pitch_rad,truth_yaw_rad,world_x_m,"));
  EXPECT_THAT(csv, HasSubstr(",odometry_yaw_rad,progress_m\n70,10.1"));
  EXPECT_THAT(csv, testing::ContainsRegex(",world_yaw_rad,model_x_m.*,model_yaw_rad,odometry_x_m"));
  EXPECT_THAT(csv, testing::MatchesRegex(".*\n70(,10\\.[0-9]+){6}(,20\\.[0-9]+){6}"
                                         "(,30\\.[0-9]+){6}(,40\\.[0-9]+){6},60\n"));
  run.has_camera = true;
  EXPECT_THAT(poses_csv(run), HasSubstr(",fused_x_m,"));
}

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

TEST(Percentile, LiesBetweenNeighboursAndWhatIsNoNumberIsTheWorst) {
  EXPECT_DOUBLE_EQ(percentile({2.0, 1.0}, 0.25), 1.25);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
  EXPECT_DOUBLE_EQ(percentile({1.0, kNothing, 2.0}, 0.5), 2.0);
  EXPECT_TRUE(std::isinf(percentile({1.0, kNothing}, 1.0)));
}

TEST(HtmlPage, EscapesWhatItIsGivenAndHasVerdictAndFactsAboveItsContents) {
  HtmlPage page("a & b");
  page.verdict(false, "Not completed: tilt.");
  page.facts({{"robot", "a < b"}, {"steps", Cell("3 missing", true)}});
  for (const char* part : {"Errors", "Figures", "Settings"}) page.heading(part);
  page.table(
      {{"", "number", "words"}, {"<script>", "-1.5 cm", "1-curve"}, {"b", Cell("1.0", true)}},
      "caption");
  const std::string text = page.text();
  for (const char* part :
       {"a &amp; b", "<dt>robot</dt><dd>a &lt; b</dd>", "<dd class='missed'>3 missing</dd>",
        "<a href='#part-2'>Figures</a>", "<h2 id='part-2'>Figures</h2>",
        "<td>&lt;script&gt;</td><td>-1.5 cm</td><td class='t'>1-curve</td>",
        "<td class='missed'>1.0</td>"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, Not(HasSubstr("http")));
  const auto at = [&](const char* part) { return text.find(part); };
  EXPECT_LT(at("Not completed"), at("<dl>"));
  EXPECT_LT(at("<dl>"), at("<nav"));
  EXPECT_LT(at("<nav"), at("<h2"));
}

/// WCAG 2's relative luminance of "#rrggbb".
double luminance(const char* colour) {
  double sum = 0.0;
  for (const auto& [at, weight] : {std::pair{std::size_t{1}, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
    const double part = std::stoi(std::string(colour).substr(at, 2), nullptr, 16) / 255.0;
    sum += weight * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const char* a, const char* b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

TEST(Colours, AreReadableOnPaperAndInTheDark) {
  EXPECT_NEAR(contrast("#000000", "#ffffff"), 21.0, 1e-9);
  for (const Colour& colour : kColours) {
    EXPECT_GE(contrast(colour.light, kGround.light), 4.5) << colour.name;
    EXPECT_GE(contrast(colour.dark, kGround.dark), 4.5) << colour.name;
  }
}

TEST(SvgChart, DrawsEverySeriesAndBreaksLinesWhereThereIsNothing) {
  const std::string picture =
      svg({.title = "a < b",
           .x_label = "x",
           .y_label = "y",
           .series = {{.name = "one",
                       .colour = "#123456",
                       .points = {{0, 0}, {1, 1}, {2, kNothing}, {3, 1}, {4, 0}}},
                      {.name = "two", .colour = "red", .points = {{0, 1}}, .marks = true}}});
  EXPECT_THAT(picture, HasSubstr("a &lt; b"));
  EXPECT_THAT(picture, HasSubstr("stroke='#123456'"));
  EXPECT_THAT(picture, HasSubstr("<circle"));
  EXPECT_THAT(picture, Not(HasSubstr("nan")));
  const auto at = picture.find("d='M", picture.find("#123456"));
  const std::string path = picture.substr(at, picture.find("'/>", at) - at);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
}

TEST(Charts, OfNothingOrOfValuesThatHardlyDifferAreStillPictures) {
  const auto a_picture = testing::AllOf(HasSubstr("</svg>"), Not(HasSubstr("inf")));
  EXPECT_THAT(svg({}), a_picture);
  EXPECT_THAT(box_plot({}), a_picture);
  for (const double x : {1e6, -1e6, 1e-9, 0.0})
    EXPECT_THAT(svg({.series = {{.points = {{x, x}, {x + 1e-10, x + 1e-10}}}}}), a_picture);
}

/// The points of the blue line of a picture.
std::array<std::array<double, 2>, 3> blue_line(const std::string& picture) {
  std::array<std::array<double, 2>, 3> p{};
  const auto at = picture.find("d='M", picture.find("stroke='blue'"));
  EXPECT_EQ(std::sscanf(picture.c_str() + at, "d='M%lf %lfL%lf %lfL%lf %lf", &p[0][0], &p[0][1],
                        &p[1][0], &p[1][1], &p[2][0], &p[2][1]),
            6);
  return p;
}

TEST(SvgChart, EveryPointLiesInTheFrameAndTheExtremesNearItsEdges) {
  const std::string picture =
      svg({.series = {{.colour = "blue", .points = {{-3, 10}, {1, -20}, {5, 40}}}}});
  double left, top, width, height;
  ASSERT_EQ(
      std::sscanf(picture.c_str() + picture.find("<rect x="),
                  "<rect x='%lf' y='%lf' width='%lf' height='%lf'", &left, &top, &width, &height),
      4);
  const auto p = blue_line(picture);
  EXPECT_LT(left, p[0][0]);
  EXPECT_LT(p[0][0], left + 0.1 * width);
  EXPECT_GT(p[2][0], left + 0.9 * width);
  EXPECT_LT(p[2][0], left + width);
  EXPECT_GT(p[2][1], top);
  EXPECT_LT(p[2][1], top + 0.1 * height);
  EXPECT_GT(p[1][1], top + 0.9 * height);
  EXPECT_LT(p[1][1], top + height);
}

TEST(SvgChart, AMapHasOneScale) {
  const auto p = blue_line(svg({.series = {{.colour = "blue", .points = {{0, 0}, {1, 0}, {1, 1}}}},
                                .equal_scale = true,
                                .width_px = 700,
                                .height_px = 300}));
  EXPECT_NEAR(p[1][0] - p[0][0], p[1][1] - p[2][1], 0.3);
}

TEST(BoxPlot, HasABoxForEveryRowWithItsCount) {
  const std::string picture = box_plot(
      {.title = "t",
       .x_label = "error [cm]",
       .boxes = {{"all <runs>", {1, 2, 3, 4, 100}}, {"a", {1, 2, kNothing}}, {"none", {}}}});
  for (const char* part : {"all &lt;runs&gt; (5)", "a (3)", "none (0)", "error [cm]"})
    EXPECT_THAT(picture, HasSubstr(part));
  // The frame and two boxes.
  const std::string box = "fill='white' stroke='";
  EXPECT_NE(picture.find(box), std::string::npos);
  EXPECT_NE(picture.find(box), picture.rfind(box));
  EXPECT_THAT(picture, testing::AllOf(HasSubstr("<circle"), Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace tp100::report
