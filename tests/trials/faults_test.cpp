// Tests every fault of the list on every board that can have it, and compares the rows of the fault
// page with the results; `scripts/test --accept` writes the rows again. The page also names the
// tests of the faults that have no --fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "course/bundled_files.h"
#include "encoder_study.h"
#include "fault_study.h"
#include "live/link_monitor.h"
#include "live/live_events.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

const std::string kPage = source_path("sim/faults/FAULTS.md");
constexpr const char* kMark = "<!-- rows -->\n";
constexpr const char* kEnd = "<!-- end of rows -->\n";
constexpr const char* kEncoderMark = "<!-- encoders -->\n";
constexpr const char* kEncoderEnd = "<!-- end of encoders -->\n";

std::string page() { return course::read_text_file(kPage).text; }

/// The text between two marks of the page.
std::string part(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from), end = text.find(to);
  if (begin == std::string::npos || end == std::string::npos) return "";
  return text.substr(begin + from.size(), end - begin - from.size());
}

constexpr const char* kHead = "| `--fault` | expected | native | avr |\n|---|---|---|---|\n";

std::map<std::pair<std::string_view, BoardKind>, std::string> seen_cells;
std::string encoder_table;

/// The beginning of a row: the fault and what is expected.
std::string begin_of_row(const FaultTrial& trial) {
  return "| `" + std::string(trial.fault) + "` | " + expected_effect(trial) + " | ";
}

bool rewriting() { return std::getenv("TP100_ACCEPT") != nullptr; }

struct Case {
  FaultTrial trial;
  BoardKind board;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const FaultTrial& trial : fault_trials()) {
    if (!trial.chip_only) all.push_back({trial, BoardKind::kNative});
#ifdef TP100_HAS_IMAGE
    all.push_back({trial, BoardKind::kAvr});
#endif
  }
  return all;
}

/// The events of a run that the log and the viewers receive.
std::vector<messages::Event> words_of(const FaultOutcome& outcome, live::LinkMonitor& watch) {
  std::vector<messages::Event> all = watch.drain_events();
  const auto add = [&](const live::LiveEvent& event) {
    for (messages::Event& word : live::describe_event(event)) all.push_back(std::move(word));
  };
  for (const SessionMessage& one : outcome.session_messages)
    add(live::SessionReport{one.event, one.hello});
  if (outcome.faults != 0)
    add(live::RunChange{
        .from = RunState::kRunning, .to = RunState::kAborted, .faults = outcome.faults});
  return all;
}

/// The event in `all` that names `what`, with cause and fix; null if there is none.
const messages::Event* complete(const std::vector<messages::Event>& all, std::string_view what) {
  for (const messages::Event& word : all)
    if (word.level != messages::Event::Level::kInfo && !word.cause.empty() && !word.fix.empty() &&
        word.text.find(what) != std::string::npos)
      return &word;
  return nullptr;
}

std::string joined(const std::vector<messages::Event>& all) {
  std::string out;
  for (const messages::Event& word : all)
    out += "  " + word.text + ": " + word.cause + "; " + word.fix + "\n";
  return out;
}

class FaultTest : public ::testing::TestWithParam<Case> {};

TEST_P(FaultTest, EndsAsExpectedAndAsThePageSays) {
  const auto& [trial, board] = GetParam();
  live::LinkMonitor watch;
  const FaultOutcome seen = try_fault(trial, board, &watch);
  const std::string cell = seen_effect(trial, seen) + " |", begin = begin_of_row(trial);
  EXPECT_TRUE(seen.as_expected) << begin << cell;
  EXPECT_EQ(seen.wild, 0u) << "commands that no robot may receive";
  const std::vector<messages::Event> words = words_of(seen, watch);
  if (trial.end != "completed" && trial.end != "never began") {
    EXPECT_TRUE(complete(words, trial.end)) << trial.end << " is not in\n" << joined(words);
  }
  if (!trial.log.empty()) {
    EXPECT_TRUE(complete(words, trial.log)) << trial.log << " is not in\n" << joined(words);
  }
  seen_cells[{trial.fault, board}] = cell;
  const std::string row = part(page(), "\n" + begin, "\n<!-- end");
  const std::size_t second = std::min(row.size(), row.find(" | ") + 3);
  EXPECT_TRUE(rewriting() || row.substr(board == BoardKind::kAvr ? second : 0).starts_with(cell))
      << "not on the page: " << begin << cell;
}

/// Letters and digits of `text`, with underscores between them.
std::string as_name(std::string text) {
  for (char& letter : text)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return text;
}

INSTANTIATE_TEST_SUITE_P(List, FaultTest, ::testing::ValuesIn(cases()), [](const auto& param) {
  return as_name(std::string(param.param.trial.fault) + "_" + to_string(param.param.board));
});

std::vector<EncoderFailure> failures_on_the_page() {
  std::vector<EncoderFailure> all;
  for (const EncoderFailure& failure : encoder_failures())
    if (failure.on_page) all.push_back(failure);
  return all;
}

std::string told(const EncoderTrial& trial, const EncoderOutcome& outcome) {
  std::ostringstream out;
  out << trial.failure.fault << " at " << trial.speed_mps << ", " << to_string(trial.onset) << ", "
      << trial.robot << ": " << outcome.end << ", " << outcome.beyond_m << " m, "
      << outcome.beyond_rad << " rad";
  return out.str();
}

class EncoderTest : public ::testing::TestWithParam<EncoderFailure> {};

// Each speed is tested with one robot in turn; EncoderSweep has all robots and more failures.
TEST_P(EncoderTest, TheMotorsAreOffBeforeTheRobotIsFarFromWhereItShouldBe) {
  EncoderStudy study;
  std::vector<EncoderOutcome> row;
  for (const double speed_mps : encoder_speeds()) {
    row.emplace_back();
    for (const EncoderTrial& trial :
         encoder_trials(GetParam(), speed_mps, BoardKind::kNative, false)) {
      const EncoderOutcome outcome = study.drive(trial);
      EXPECT_TRUE(outcome.good()) << told(trial, outcome);
      row.back().merge(outcome);
    }
  }
  const std::string text = encoder_row(GetParam(), row);
  encoder_table += text;
  EXPECT_TRUE(rewriting() || page().find(text) != std::string::npos) << "not on the page: " << text;
}

INSTANTIATE_TEST_SUITE_P(Sweep, EncoderTest, ::testing::ValuesIn(failures_on_the_page()),
                         [](const auto& param) { return as_name(std::string(param.param.fault)); });

class EncoderSweep : public EncoderTest {};

TEST_P(EncoderSweep, TheMotorsAreOffInTimeWithEveryRobot) {
  EncoderStudy study;
  for (const double speed_mps : encoder_speeds())
    for (const EncoderTrial& trial :
         encoder_trials(GetParam(), speed_mps, BoardKind::kNative, true)) {
      const EncoderOutcome outcome = study.drive(trial);
      EXPECT_TRUE(outcome.good()) << told(trial, outcome);
    }
}

INSTANTIATE_TEST_SUITE_P(Nightly, EncoderSweep,
                         ::testing::ValuesIn(encoder_failures().begin(), encoder_failures().end()),
                         [](const auto& param) { return as_name(std::string(param.param.fault)); });

#ifdef TP100_HAS_IMAGE
TEST(EncoderFaultsOnTheChip, EndTheRunAsWell) {
  EncoderStudy study;
  for (const char* fault : {"encoder-stuck:left", "encoder-lose:0.3:right", "encoder-lose:0.5"}) {
    for (const Onset onset : {Onset::kStraight, Onset::kArc}) {
      const EncoderTrial trial{{fault}, 0.1, onset, "end-loaded", BoardKind::kAvr};
      const EncoderOutcome outcome = study.drive(trial);
      EXPECT_TRUE(outcome.good()) << told(trial, outcome);
    }
  }
}
#endif

// Without the daemon's supervision, only the firmware can stop the robot.
TEST(EncoderFaultsWithoutTheHost, StopTheRobotOnAStraight) {
  EncoderStudy study(false);
  for (const char* fault :
       {"encoder-stuck:left", "encoder-silent", "encoder-lose:0.3", "encoder-lose:0.3:left",
        "encoder-lose:0.5:right", "encoder-lose:0.7"}) {
    for (const double speed_mps : {0.03, 0.06, 0.1, 0.15}) {
      const EncoderTrial trial{{fault}, speed_mps, Onset::kStraight, "end-loaded"};
      const EncoderOutcome outcome = study.drive(trial);
      EXPECT_TRUE(outcome.good()) << told(trial, outcome);
      EXPECT_TRUE(outcome.end.starts_with("stalled_")) << told(trial, outcome);
    }
  }
}

TEST(EncoderFaultsWithoutTheHost, StopTheRobotInATurn) {
  EncoderStudy study(false);
  for (const std::string_view robot : encoder_robots()) {
    for (const Onset onset : {Onset::kArc, Onset::kSpin}) {
      for (const EncoderFailure& failure :
           {EncoderFailure{"encoder-lose:0.3"}, EncoderFailure{"encoder-lose:0.3:left"},
            EncoderFailure{"encoder-lose:0.3:right"}, EncoderFailure{"encoder-stuck"},
            EncoderFailure{"encoder-jump:-200", 0.25}}) {
        for (const double speed_mps : {0.15, 0.2}) {
          const EncoderTrial trial{failure, speed_mps, onset, robot};
          const EncoderOutcome outcome = study.drive(trial);
          EXPECT_TRUE(outcome.good()) << told(trial, outcome);
        }
      }
    }
  }
}

TEST(FaultList, HasATrialForEveryKind) {
  std::set<std::string_view> tried;
  for (const FaultTrial& trial : fault_trials())
    tried.insert(kInjectableFaults[parse_fault(trial.fault).kind].name);
  for (const InjectableFault& row : kInjectableFaults)
    EXPECT_TRUE(tried.contains(row.name)) << row.name;
}

// Without this test, a trial could pass although its fault has no effect.
TEST(FaultList, WithoutAFaultNothingIsCountedAndNothingSaid) {
  for (const FaultTrial& trial : fault_trials()) {
    EXPECT_FALSE(trial.counter.empty()) << trial.fault;
    EXPECT_GT(trial.at_least, 0.0) << trial.fault;
    const bool aborted = trial.end != "completed" && trial.end != "never began";
    EXPECT_EQ(trial.off_within_s > 0.0, aborted) << trial.fault;
    EXPECT_EQ(trial.again_s > 0.0, trial.end != "completed") << trial.fault;
  }
  FaultTrial none = fault_trials()[0];
  none.fault = "";
  live::LinkMonitor watch;
  const FaultOutcome seen = try_fault(none, BoardKind::kNative, &watch);
  EXPECT_EQ(seen.end, "completed");
  EXPECT_EQ(joined(watch.drain_events()), "");
  for (const FaultTrial& trial : fault_trials()) {
    const auto figure = std::find_if(seen.figures.begin(), seen.figures.end(),
                                     [&](const Figure& one) { return one.name == trial.counter; });
    ASSERT_NE(figure, seen.figures.end()) << trial.counter;
    EXPECT_LT(figure->value, trial.at_least) << trial.fault << ": " << trial.counter;
  }
}

/// Expects these rows, by how they begin, between two marks of the page, and no other.
void expect_rows(const std::string& from, const std::string& to,
                 const std::vector<std::string>& expected) {
  std::istringstream lines(part(page(), from, to));
  std::size_t i = 0;
  for (std::string line; std::getline(lines, line); ++i) {
    ASSERT_LT(i, expected.size()) << "unexpected row: " << line;
    EXPECT_EQ(line.substr(0, expected[i].size()), expected[i]);
  }
  EXPECT_EQ(i, expected.size()) << kPage << ": rows are missing, the marks or the table head";
}

TEST(FaultPage, HasOneRowForEveryTrialAndEncoderFailureAndNoOther) {
  std::vector<std::string> trials, failures;
  for (const FaultTrial& trial : fault_trials()) trials.push_back(begin_of_row(trial));
  expect_rows(std::string(kMark) + kHead, kEnd, trials);
  for (const EncoderFailure& failure : failures_on_the_page())
    failures.push_back("| `" + std::string(failure.fault) + "`");
  expect_rows(kEncoderMark + encoder_table_head(), kEncoderEnd, failures);
}

/// Every `Suite.Name` in the sources below tests/.
std::set<std::string> tests_in_the_sources() {
  std::set<std::string> names;
  const std::regex pattern(R"(TEST(_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_path("tests"))) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = course::read_text_file(entry.path()).text;
    for (std::size_t at = 0; (at = text.find("\nTEST", at)) != std::string::npos; ++at) {
      const std::string head = text.substr(at + 1, 200);
      std::smatch found;
      if (std::regex_search(head, found, pattern, std::regex_constants::match_continuous))
        names.insert(found[2].str() + "." + found[3].str());
    }
  }
  return names;
}

TEST(FaultPage, EveryTestThatProvesAFaultOfAnotherKindExists) {
  const std::string text = course::read_text_file(source_path("tests/PROOF.md")).text;
  const std::string rest = text.substr(std::min(text.size(), text.find("\n## Faults")));
  const std::set<std::string> known = tests_in_the_sources();
  const std::regex pattern(R"(`([A-Z]\w+\.[A-Z]\w+|tests/[\w/]+\.(?:py|sh))`)");
  std::size_t named = 0;
  std::istringstream lines(rest);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| fault") || line.starts_with("|---"))
      continue;
    std::size_t in_row = 0;
    for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it) {
      ++in_row;
      const std::string name = (*it)[1].str();
      EXPECT_TRUE(known.contains(name) || std::filesystem::exists(source_path(name)))
          << "no such test: " << name;
    }
    EXPECT_GT(in_row, 0u) << "the row names no test: " << line;
    named += in_row;
  }
  EXPECT_GT(named, 20u) << "PROOF.md: the rows of faults are missing";
}

class Page : public ::testing::Environment {
 public:
  void TearDown() override {
    if (!rewriting()) return;
    std::string text = page();
    const auto put = [&](const std::string& from, const std::string& to, const std::string& rows) {
      const std::size_t begin = text.find(from) + from.size();
      text.replace(begin, text.find(to) - begin, rows);
    };
    std::string table = kHead;
    for (const FaultTrial& trial : fault_trials()) {
      std::string& native = seen_cells[{trial.fault, BoardKind::kNative}];
      table += begin_of_row(trial) + (trial.chip_only ? "- |" : native) + " " +
               seen_cells[{trial.fault, BoardKind::kAvr}] + "\n";
    }
    put(kMark, kEnd, table);
    if (!encoder_table.empty())
      put(kEncoderMark, kEncoderEnd, encoder_table_head() + encoder_table);
    std::ofstream(kPage) << text;
  }
};
const auto* const kPageWriter = ::testing::AddGlobalTestEnvironment(new Page);

}  // namespace
}  // namespace tp100::sim
