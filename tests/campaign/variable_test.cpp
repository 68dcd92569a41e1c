#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/campaign/campaign_spec.h"

namespace tp100::sim {
namespace {

std::vector<Variable> read(const std::string& text) {
  text::TomlTable root = text::TomlDocument(text, "spec.toml").root();
  std::vector<Variable> variables = read_variables(root);
  root.finish();
  return variables;
}

Variable one(const std::string& text) { return read("x = " + text).at(0); }

double number(const Variable& variable, std::uint64_t index, std::uint64_t seed = 1) {
  return std::get<double>(draw(variable, {seed, index, index}));
}

TEST(Variable, AValueIsTheSameInEveryRun) {
  const Variable variable = one("0.25");
  EXPECT_FALSE(variable.varies());
  EXPECT_EQ(number(variable, 0), 0.25);
  EXPECT_EQ(number(variable, 999), 0.25);
  EXPECT_EQ(std::get<bool>(draw(one("true"), {1, 0, 0})), true);
  EXPECT_EQ(std::get<long long>(draw(one("7"), {1, 0, 0})), 7);
}

TEST(Variable, UniformValuesFillTheirRangeAndNothingElse) {
  const Variable variable = one("{ uniform = [-1, 3.0] }");
  double sum = 0.0, least = 9.0, most = -9.0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const double value = number(variable, i);
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, -1.0);
  EXPECT_LT(least, -0.99);
  EXPECT_LE(most, 3.0);
  EXPECT_GT(most, 2.99);
  EXPECT_NEAR(sum / 4000.0, 1.0, 0.06);
}

TEST(Variable, NormalValuesHaveTheirMeanAndDeviation) {
  const Variable variable = one("{ normal = [5, 2] }");
  double sum = 0.0, squares = 0.0;
  int within = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const double off = number(variable, i) - 5.0;
    sum += off;
    squares += off * off;
    within += std::abs(off) < 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(sum / 4000.0, 0.0, 0.12);
  EXPECT_NEAR(std::sqrt(squares / 4000.0), 2.0, 0.08);
  EXPECT_NEAR(within / 4000.0, 0.683, 0.025);
}

TEST(Variable, WhatIsSampledDependsOnSeedIndexAndName) {
  const std::vector<Variable> two = read("a = { uniform = [0, 1] }\nb = { uniform = [0, 1] }");
  std::set<double> values;
  for (const Variable& variable : two)
    for (const std::uint64_t seed : {1U, 2U})
      for (std::uint64_t index = 0; index < 100; ++index) {
        values.insert(number(variable, index, seed));
        EXPECT_EQ(number(variable, index, seed), number(variable, index, seed));
      }
  EXPECT_EQ(values.size(), 400u);
}

TEST(Variable, AListGoesRound) {
  const Variable variable = one(R"({ list = ["a", "b", "c"] })");
  EXPECT_EQ(variable.choices(), 3u);
  for (std::uint64_t turn = 0; turn < 9; ++turn)
    EXPECT_EQ(std::get<std::string>(draw(variable, {1, 0, turn})),
              std::string(1, static_cast<char>('a' + turn % 3)));
}

TEST(Variable, TablesWithinAreNamedInFull) {
  const std::vector<Variable> variables =
      read("b.d = 1\n[a]\nx = { normal = [0, 1] }\n[a.c]\ny = \"text\"");
  ASSERT_EQ(variables.size(), 3u);
  EXPECT_EQ(variables[0].name, "a.c.y");
  EXPECT_EQ(variables[1].name, "a.x");
  EXPECT_EQ(variables[2].name, "b.d");
}

TEST(Variable, NonsenseIsRefusedWithItsPlace) {
  for (const auto& [text, error] :
       {std::pair{"x = { uniform = [2, 1] }", "spec.toml:1:17: the lowest comes first"},
        {"x = { uniform = [2] }",
         "spec.toml:1:17: uniform needs two numbers: the lowest and the highest"},
        {"x = { normal = [0, -1] }", "spec.toml:1:16: a standard deviation is not negative"},
        {"x = { list = [] }", "needs a value, or one of"},
        {"x = [1, 2]", "expected true, false, a number or a string"},
        {"x = { uniform = [0, 1], sd = 1 }", "unknown key 'x.sd'"},
        {"x = { uniform = [0, nan] }", "two numbers"}})
    EXPECT_THAT([text = text] { read(text); },
                testing::ThrowsMessage<SetupError>(testing::HasSubstr(error)));
}

}  // namespace
}  // namespace tp100::sim
