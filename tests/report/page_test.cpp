#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/angle.h"
#include "core/statistics.h"
#include "report/html_page.h"
#include "report/run_result.h"

namespace tp100::report {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(Spread, IsMedianAndNinetyFifthPercentile) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  EXPECT_DOUBLE_EQ(spread(values).median, 50.0);
  EXPECT_DOUBLE_EQ(spread(values).p95, 95.0);
  EXPECT_DOUBLE_EQ(percentile({1.0, 2.0}, 0.25), 1.25);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
}

TEST(Spread, WhatIsNoNumberIsTheWorst) {
  EXPECT_DOUBLE_EQ(percentile({1.0, kNone, 2.0}, 0.5), 2.0);
  EXPECT_TRUE(std::isinf(percentile({1.0, kNone}, 1.0)));
}

TEST(Tum, TurnsAnglesIntoAQuaternion) {
  EXPECT_EQ(tum_line(1.5, {.x_m = 1.0, .y_m = -2.0, .z_m = 0.25}),
            "1.500000 1.000000 -2.000000 0.250000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
  EXPECT_THAT(tum_line(0.0, {.yaw_rad = kPi / 2}), HasSubstr("0.000000000 0.000000000 "
                                                             "0.707106781 0.707106781"));
  EXPECT_THAT(tum_line(0.0, {.pitch_rad = kPi / 2}), HasSubstr(" 0.707106781 0.000000000 0.7"));
}

TEST(SvgChart, DrawsEverySeriesAndBreaksLinesWhereThereIsNothing) {
  const std::string picture =
      svg({.title = "a < b",
           .x_label = "x",
           .y_label = "y",
           .series = {{.name = "one",
                       .colour = "#123456",
                       .points = {{0, 0}, {1, 1}, {2, kNone}, {3, 1}, {4, 0}}},
                      {.name = "two", .colour = "red", .points = {{0, 1}}, .marks = true}}});
  EXPECT_THAT(picture, HasSubstr("a &lt; b"));
  EXPECT_THAT(picture, HasSubstr("stroke='#123456'"));
  EXPECT_THAT(picture, HasSubstr("<circle"));
  EXPECT_THAT(picture, Not(HasSubstr("nan")));
  const auto at = picture.find("d='M", picture.find("#123456"));
  const std::string path = picture.substr(at, picture.find("'/>", at) - at);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
}

TEST(SvgChart, OfNothingIsStillAPicture) {
  EXPECT_THAT(svg({}), testing::AllOf(HasSubstr("</svg>"), Not(HasSubstr("inf"))));
}

TEST(SvgChart, ValuesThatHardlyDifferStillHaveAxes) {
  for (const double x : {1e6, -1e6, 1e-9, 0.0})
    EXPECT_THAT(svg({.series = {{.points = {{x, x}, {x + 1e-10, x + 1e-10}}}}}),
                HasSubstr("</svg>"));
}

TEST(SvgChart, AMapHasOneScale) {
  const std::string picture =
      svg({.series = {{.colour = "blue", .points = {{0, 0}, {1, 0}, {1, 1}}}},
           .equal_scale = true,
           .width_px = 700,
           .height_px = 300});
  double x0, y0, x1, y1, x2, y2;
  const auto at = picture.find("d='M", picture.find("stroke='blue'"));
  ASSERT_EQ(std::sscanf(picture.c_str() + at, "d='M%lf %lfL%lf %lfL%lf %lf", &x0, &y0, &x1, &y1,
                        &x2, &y2),
            6);
  EXPECT_NEAR(x1 - x0, y1 - y2, 0.3);
}

TEST(HtmlPage, EscapesWhatItIsGivenAndMarksWhatDoesNotHold) {
  HtmlPage page("a & b");
  page.table({{"head"}, {Cell("1.0", true)}, {"<script>"}, {"!"}}, "caption");
  EXPECT_THAT(page.text(), HasSubstr("a &amp; b"));
  EXPECT_THAT(page.text(), HasSubstr("<td class='missed'>1.0</td>"));
  EXPECT_THAT(page.text(), HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(page.text(), Not(HasSubstr("http")));
}

}  // namespace
}  // namespace tp100::report
