// Figures of a campaign's runs, merged.

#include "sim/campaign/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "sim/campaign/shown_figures.h"
#include "sim/campaign/summary.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

CampaignSpec spec() {
  return parse_campaign(
      "runs = 6\ncourse = \"3\"\nrobot = { list = [\"a\", \"b\"] }\n"
      "[configuration]\ncontrol.gain = { uniform = [0, 1] }",
      "spec.toml");
}

/// The file of run `index`, whose error grows with the index.
std::string file_of(int index, const char* more = "") {
  const std::string i = std::to_string(index);
  return R"({"index":)" + i + R"(,"seed":)" + std::to_string(index + 1) +
         R"(,"sampled":{"robot":")" + (index % 2 == 0 ? "a" : "b") + R"(","control.gain":0.)" + i +
         R"(},"result":{"completed":true,"duration_s":)" + i +
         R"(.5,"realtime_factor":3,"model":{"max_position_error_m":0.0)" + i +
         R"(},"tracking":{"recovery_s":[1,null]},"loop":{"p50":1})" + more + "}}";
}

std::string failed_file_of(int index, const std::string& cause) {
  std::string text = file_of(index);
  const std::string completed = R"("completed":true)";
  return text.replace(text.find(completed), completed.size(),
                      R"("completed":false,"cause":")" + cause + "\"");
}

std::vector<MergedRun> runs_of(std::initializer_list<int> indices) {
  std::vector<MergedRun> runs;
  for (const int index : indices) runs.push_back(*parse_run_file(file_of(index)));
  return runs;
}

const MergedFigure& figure(const Merged& merged, const std::string& name) {
  for (const MergedFigure& one : merged.figures)
    if (one.name == name) return one;
  throw std::out_of_range(name);
}

TEST(Merge, TakesEveryFigureButThoseOfTheMachine) {
  const MergedRun run = *parse_run_file(file_of(4));
  EXPECT_EQ(run.index, 4u);
  EXPECT_EQ(run.seed, 5u);
  EXPECT_EQ(run.figures.size(), 3u);
  EXPECT_EQ(run.figures.at("duration_s"), 4.5);
  EXPECT_FALSE(std::isfinite(run.figures.at("tracking.recovery_s"))) << "the robot never recovered";
  EXPECT_EQ(run.sampled_numbers.at("control.gain"), 0.4);
}

TEST(Merge, CountsWhatIsMissingAndGroupsByWhatWasListed) {
  const Merged merged = merge(spec(), runs_of({0, 1, 4}));
  EXPECT_THAT(merged.missing, testing::ElementsAre(2, 3, 5));
  EXPECT_EQ(merged.driven, 3u);
  EXPECT_EQ(merged.completed, 3u);
  ASSERT_EQ(merged.groups.size(), 2u);
  EXPECT_EQ(merged.groups[0].value, "a");
  EXPECT_EQ(merged.groups[0].driven, 2u);
  EXPECT_DOUBLE_EQ(merged.groups[0].figures.at("duration_s").percentiles[1].value, 2.5);
  EXPECT_EQ(merged.groups[1].driven, 1u);
}

TEST(Merge, NamesTheWorstRunsFirst) {
  const Merged merged = merge(spec(), runs_of({0, 1, 2, 3, 4, 5}));
  const MergedFigure& of = figure(merged, "model.max_position_error_m");
  EXPECT_EQ(of.summary.count, 6u);
  ASSERT_EQ(of.worst.size(), 5u);
  EXPECT_EQ(of.worst[0], std::pair(std::uint64_t{5}, 0.05));
  EXPECT_THAT(of.correlations, testing::ElementsAre(testing::Pair("control.gain", 1.0)));
}

TEST(Merge, ARefusedRunIsNoRunThatFailed) {
  std::vector<MergedRun> runs = runs_of({0, 1});
  runs.push_back(*parse_run_file(
      R"({"index":2,"seed":3,"sampled":{"robot":"a"},"refused":"robot.toml: too heavy"})"));
  const Merged merged = merge(spec(), std::move(runs));
  EXPECT_EQ(merged.driven, 2u);
  const Json json = Json::parse(merged_json(merged));
  EXPECT_EQ(json["refused"][0]["why"], "robot.toml: too heavy");
  EXPECT_EQ(json["refused"][0]["seed"], 3);
  EXPECT_TRUE(json["failed"].empty());
  EXPECT_THAT(merge_page(merged, "x"), HasSubstr("too heavy"));
}

TEST(Merge, NamesEveryFailedRunItsCauseAndWhatWasSampled) {
  std::vector<MergedRun> runs = runs_of({0, 1});
  for (const int index : {2, 3, 4})
    runs.push_back(*parse_run_file(failed_file_of(index, index == 3 ? "tilt" : "cross_track")));
  const Merged merged = merge(spec(), std::move(runs));
  EXPECT_EQ(merged.driven, 5u);
  EXPECT_EQ(merged.completed, 2u);
  EXPECT_THAT(merged.causes(),
              testing::ElementsAre(testing::Pair("cross_track", 2u), testing::Pair("tilt", 1u)));
  EXPECT_EQ(figure(merged, "duration_s").summary.count, 2u)
      << "only completed runs count in figures";
  const Json json = Json::parse(merged_json(merged));
  EXPECT_EQ(json["causes"], Json::parse(R"({"cross_track":2,"tilt":1})"));
  ASSERT_EQ(json["failed"].size(), 3u);
  EXPECT_EQ(json["failed"][1], Json::parse(R"({"index":3,"seed":4,"cause":"tilt",
                                               "sampled":{"robot":"b","control.gain":0.3}})"));
  EXPECT_THAT(merged_csv(merged), HasSubstr("\n3,4,0,tilt,,0.3,b,3.5,"));
}

TEST(Merge, WritesOneRowARun) {
  std::vector<MergedRun> runs = runs_of({0});
  runs[0].refused = "a, \"b\"";
  const std::string csv = merged_csv(merge(spec(), runs));
  EXPECT_EQ(csv,
            "index,seed,completed,cause,refused,control.gain,robot,duration_s,"
            "model.max_position_error_m,tracking.recovery_s\n"
            "0,1,1,,\"a, \"\"b\"\"\",0.0,a,0.5,0.0,inf\n");
}

TEST(Merge, AFileOfARunThatIsNotWholeIsNone) {
  const std::string whole = file_of(4);
  for (std::size_t size = 0; size < whole.size() - 1; ++size)
    EXPECT_FALSE(parse_run_file(whole.substr(0, size))) << "cut off after " << size;
  for (const std::string& text :
       {std::string(), std::string(4000, '\0'), std::string("{}"), std::string("[1]"),
        std::string(R"({"index":1,"seed":1,"sampled":[]})")})
    EXPECT_FALSE(parse_run_file(text)) << text;
}

TEST(MergePage, BeginsWithVerdictAndFactsAndEndsWithTheSpecification) {
  const std::string page = merge_page(merge(spec(), runs_of({0, 1, 2, 3, 4, 5})), "runs = 6",
                                      {{"begun", "2026-05-31 14:05 UTC"}, {"course", "3"}});
  const std::string top = page.substr(0, page.find("<h2"));
  EXPECT_THAT(top, HasSubstr("<p class='verdict good'>6 of 6 driven runs completed"));
  EXPECT_THAT(top, HasSubstr("<dt>begun</dt><dd>2026-05-31 14:05 UTC</dd>"));
  EXPECT_THAT(page, HasSubstr("runs = 6"));
  EXPECT_THAT(page, Not(HasSubstr("Failed runs")));
  EXPECT_THAT(merge_page(merge(spec(), runs_of({0})), "x"), HasSubstr("<p class='verdict bad'>"));
  // 0 to 5 cm, of all runs and of either robot.
  EXPECT_THAT(page, HasSubstr("<td>Model: largest position error [cm]</td><td>6</td><td>2.50 ("));
  for (const char* part : {"all (6)</text>", "a (3)</text>", "b (3)</text>"})
    EXPECT_THAT(page, HasSubstr(part));
}

TEST(MergePage, ShowsFailedRunsAheadOfTheWorstAndHowToDriveThemAgain) {
  std::vector<MergedRun> runs = runs_of({0, 1});
  runs.push_back(*parse_run_file(failed_file_of(2, "<cross_track>")));
  runs.push_back(runs_of({5})[0]);
  const std::string page = merge_page(merge(spec(), std::move(runs)), "x");
  EXPECT_THAT(page, HasSubstr("&lt;cross_track&gt;"));
  EXPECT_THAT(page, HasSubstr("control.gain 0.2, robot a"));
  EXPECT_LT(page.find("Failed runs"), page.find("Worst completed runs"));
  for (const char* index : {"2", "5"})
    EXPECT_THAT(page, HasSubstr("tp100-sim campaign spec.toml --out again --index " +
                                std::string(index) + " --record again"));
  std::vector<MergedRun> many;
  for (int index = 0; index < 2000; ++index)
    many.push_back(*parse_run_file(failed_file_of(index, "tilt")));
  EXPECT_THAT(merge_page(merge(spec(), std::move(many)), "x"),
              HasSubstr("The first 500 of 2000 failed runs; merged.json lists all"));
}

TEST(MergePage, HasAChartForEveryStrongCorrelation) {
  EXPECT_TRUE(is_strong(-0.61, 100));
  EXPECT_FALSE(is_strong(0.6, 100));
  EXPECT_FALSE(is_strong(0.85, 6)) << "chance alone gives as much";
  EXPECT_FALSE(is_strong(1.0, 1));
  const char* chart = "Model: largest position error against control.gain</figcaption>";
  EXPECT_THAT(merge_page(merge(spec(), runs_of({0, 1, 2, 3, 4, 5})), "x"), HasSubstr(chart));
  EXPECT_THAT(merge_page(merge(spec(), runs_of({0, 1, 2})), "x"), Not(HasSubstr(chart)));
}

TEST(Summary, OfHundredNumbersIsWhatTablesSay) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  const Summary of = summarise(values);
  EXPECT_EQ(of.count, 100u);
  EXPECT_DOUBLE_EQ(of.mean, 50.5);
  EXPECT_NEAR(of.sd, 29.0115, 1e-4);
  EXPECT_EQ(of.least, 1.0);
  EXPECT_EQ(of.most, 100.0);
  ASSERT_EQ(of.percentiles.size(), 4u);
  EXPECT_DOUBLE_EQ(of.percentiles[1].value, 50.5);
  // Order statistics 40 and 61 are the textbook interval of the median of 100 values.
  ASSERT_TRUE(of.percentiles[1].interval.has_value());
  EXPECT_EQ(*of.percentiles[1].interval, std::pair(40.0, 61.0));
  // t(99) = 1.984.
  ASSERT_TRUE(of.mean_interval.has_value());
  EXPECT_NEAR(of.mean_interval->first, 50.5 - 1.984 * 2.90115, 1e-3);
  // A hundred runs are too few for an interval of the 99th percentile.
  EXPECT_FALSE(of.percentiles[3].interval.has_value());
}

TEST(Summary, IntervalsHoldTheTruthAsOftenAsTheySay) {
  std::mt19937 random(7);
  std::exponential_distribution<double> draw(1.0);
  int median_held = 0, p95_held = 0;
  constexpr int kCampaigns = 600;
  for (int i = 0; i < kCampaigns; ++i) {
    std::vector<double> values(200);
    for (double& value : values) value = draw(random);
    const Summary of = summarise(values);
    const auto held = [&](std::size_t at, double truth) {
      return of.percentiles[at].interval->first <= truth &&
             truth <= of.percentiles[at].interval->second;
    };
    median_held += held(1, std::log(2.0)) ? 1 : 0;
    p95_held += held(2, std::log(20.0)) ? 1 : 0;
  }
  EXPECT_GE(median_held, 0.93 * kCampaigns);
  EXPECT_GE(p95_held, 0.93 * kCampaigns);
  EXPECT_LE(median_held, 0.985 * kCampaigns);
}

TEST(Summary, OfNothingOrOneClaimsNothingAndWhatNeverHappenedIsTheLargest) {
  EXPECT_EQ(summarise({}).count, 0u);
  const Summary one = summarise({3.0});
  EXPECT_EQ(one.mean, 3.0);
  EXPECT_FALSE(one.mean_interval.has_value());
  EXPECT_FALSE(one.percentiles[1].interval.has_value());
  const Summary of = summarise({1.0, std::numeric_limits<double>::infinity(), 2.0});
  EXPECT_FALSE(std::isfinite(of.most));
  EXPECT_EQ(of.percentiles[1].value, 2.0);
  EXPECT_FALSE(of.mean_interval.has_value());
}

TEST(Summary, SharesAreClopperAndPearsons) {
  EXPECT_NEAR(share_interval(8, 10).first, 0.4439, 1e-4);
  EXPECT_NEAR(share_interval(8, 10).second, 0.9748, 1e-4);
  EXPECT_NEAR(share_interval(0, 20).second, 0.1684, 1e-4);
  EXPECT_EQ(share_interval(0, 20).first, 0.0);
  EXPECT_EQ(share_interval(20, 20).second, 1.0);
}

TEST(RankCorrelation, SeesOrderAndNothingElse) {
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4}, {1, 8, 27, 64}), 1.0, 1e-12);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4}, {9, 5, 2, -7}), -1.0, 1e-12);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4, 5}, {2, 1, 4, 3, 5}), 0.8, 1e-12);
  EXPECT_FALSE(rank_correlation({1, 2, 3}, {5, 5, 5}).has_value());
  EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}).has_value());
}

}  // namespace
}  // namespace tp100::sim
