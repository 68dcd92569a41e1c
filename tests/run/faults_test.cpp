// Every fault of the list on every board that can have it; the page that people read says what is
// seen here. TP100_REWRITE_FAULTS=1 writes it anew, from one process: build/dev/bin/faults_test.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "sim/run/fault_study.h"

namespace tp100::sim {
namespace {

const std::string kPage = TP100_SOURCE_DIR "/sim/faults/FAULTS.md";
constexpr const char* kMark = "<!-- rows -->\n";

std::string page() {
  std::ifstream file(kPage);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string table;

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

class FaultTest : public ::testing::TestWithParam<Case> {};

TEST_P(FaultTest, EndsAsExpectedAndAsThePageSays) {
  const auto& [trial, board] = GetParam();
  const FaultOutcome seen = try_fault(trial, board);
  const std::string row = fault_row(trial, board, seen);
  EXPECT_TRUE(seen.as_expected) << row << "motors off after " << seen.off_after_s << " s";
  EXPECT_EQ(seen.wild, 0u) << "commands that no robot may get";
  table += row;
  const bool rewriting = std::getenv("TP100_REWRITE_FAULTS") != nullptr;
  EXPECT_TRUE(rewriting || page().find(row) != std::string::npos) << "not on the page: " << row;
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  std::string name = std::string(info.param.trial.fault) + "_" + to_string(info.param.board);
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(List, FaultTest, ::testing::ValuesIn(cases()), name_of);

TEST(FaultList, HasATrialForEveryKind) {
  std::set<std::string_view> tried;
  for (const FaultTrial& trial : fault_trials())
    tried.insert(text_of(parse_fault(trial.fault).kind).name);
  for (const FaultText& text : fault_texts()) EXPECT_TRUE(tried.contains(text.name)) << text.name;
}

class Page : public ::testing::Environment {
 public:
  void TearDown() override {
    if (std::getenv("TP100_REWRITE_FAULTS") == nullptr) return;
    const std::string old = page();
    std::ofstream(kPage) << old.substr(0, old.find(kMark)) << kMark << fault_table_head() << table;
  }
};
const auto* const kPageWriter = ::testing::AddGlobalTestEnvironment(new Page);

}  // namespace
}  // namespace tp100::sim
