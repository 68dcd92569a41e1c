#include "report/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace tp100::report {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

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

TEST(SvgChart, EveryPointLiesInTheFrameAndTheExtremesNearItsEdges) {
  const std::string picture =
      svg({.series = {{.colour = "blue", .points = {{-3, 10}, {1, -20}, {5, 40}}}}});
  double left, top, width, height;
  ASSERT_EQ(
      std::sscanf(picture.c_str() + picture.find("<rect x="),
                  "<rect x='%lf' y='%lf' width='%lf' height='%lf'", &left, &top, &width, &height),
      4);
  double x[3], y[3];
  const auto at = picture.find("d='M", picture.find("stroke='blue'"));
  ASSERT_EQ(std::sscanf(picture.c_str() + at, "d='M%lf %lfL%lf %lfL%lf %lf", x, y, x + 1, y + 1,
                        x + 2, y + 2),
            6);
  EXPECT_LT(left, x[0]);
  EXPECT_LT(x[0], left + 0.1 * width);
  EXPECT_GT(x[2], left + 0.9 * width);
  EXPECT_LT(x[2], left + width);
  EXPECT_GT(y[2], top);
  EXPECT_LT(y[2], top + 0.1 * height);
  EXPECT_GT(y[1], top + 0.9 * height);
  EXPECT_LT(y[1], top + height);
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

TEST(SvgChart, NamesItsSeriesAboveThePlotInAsManyRowsAsTheyNeed) {
  const auto top_of_plot = [](std::size_t names) {
    Chart chart;
    for (std::size_t i = 0; i < names; ++i)
      chart.series.push_back({.name = "a series with a long name", .points = {{0, 0}, {1, 1}}});
    const std::string picture = svg(chart);
    double x = 0.0, y = 0.0;
    const auto at = picture.find("<rect x=");
    EXPECT_EQ(std::sscanf(picture.c_str() + at, "<rect x='%lf' y='%lf'", &x, &y), 2);
    return y;
  };
  EXPECT_GT(top_of_plot(1), top_of_plot(0));
  EXPECT_EQ(top_of_plot(2), top_of_plot(1));
  EXPECT_GT(top_of_plot(3), top_of_plot(2));
}

TEST(SvgChart, ABroadLineShowsBelowAThinOne) {
  const std::string picture = svg({.series = {{.points = {{0, 0}, {1, 1}}, .broad = true}}});
  EXPECT_THAT(picture, HasSubstr("stroke-width='5' stroke-opacity='.45'"));
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
