#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "core/statistics.h"
#include "report/colours.h"
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
  // What is no number is the worst.
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

TEST(HtmlPage, EscapesWhatItIsGivenAndMarksWhatDoesNotHold) {
  HtmlPage page("a & b");
  page.table({{"head"}, {Cell("1.0", true)}, {"<script>"}, {"!"}}, "caption");
  EXPECT_THAT(page.text(), HasSubstr("a &amp; b"));
  EXPECT_THAT(page.text(), HasSubstr("<td class='missed'>1.0</td>"));
  EXPECT_THAT(page.text(), HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(page.text(), Not(HasSubstr("http")));
}

TEST(HtmlPage, HasVerdictAndFactsAboveItsContents) {
  HtmlPage page("title");
  page.verdict(false, "Not completed: tilt.");
  page.facts({{"robot", "a < b"}, {"steps", Cell("3 missing", true)}});
  for (const char* part : {"Errors", "Figures", "Settings"}) page.heading(part);
  const std::string text = page.text();
  EXPECT_THAT(text, HasSubstr("<dt>robot</dt><dd>a &lt; b</dd>"));
  EXPECT_THAT(text, HasSubstr("<dd class='missed'>3 missing</dd>"));
  EXPECT_THAT(text, HasSubstr("<a href='#part-2'>Figures</a>"));
  EXPECT_THAT(text, HasSubstr("<h2 id='part-2'>Figures</h2>"));
  const auto at = [&](const char* part) { return text.find(part); };
  EXPECT_LT(at("Not completed"), at("<dl>"));
  EXPECT_LT(at("<dl>"), at("<nav"));
  EXPECT_LT(at("<nav"), at("<h2"));
}

TEST(HtmlPage, AlignsColumnsOfWordsToTheLeft) {
  HtmlPage page("title");
  page.table({{"", "number", "words"}, {"a", "-1.5 cm", "1-curve"}, {"b", "-", "2026-01-02"}},
             "caption");
  EXPECT_THAT(page.text(), HasSubstr("<td></td><th scope='col'>number</th>"
                                     "<th scope='col' class='t'>words</th>"));
  EXPECT_THAT(page.text(), HasSubstr("<td>a</td><td>-1.5 cm</td><td class='t'>1-curve</td>"));
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

}  // namespace
}  // namespace tp100::report
