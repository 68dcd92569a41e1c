// Parameters that a viewer saves into a person's configuration: every other byte stays, and what
// decides who reaches the daemon is not saved.

#include "config/parameter_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <sstream>

#include "config/configuration.h"
#include "support/refusal.h"

namespace tp100::config {
namespace {

using testing::HasSubstr;
using text::KeyText;
using Value = KeyText::Value;

std::string edited(const std::string& text, const ParameterValues& values) {
  std::string result;
  const std::string error = test::refusal([&] {
    result = with_parameters({"tp100.toml", text}, values);
  });
  return error.empty() ? result : "refused: " + error;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A value of the parameter, as a file holds it: ten digits.
Value some_value(const KeyText& key, std::mt19937& random) {
  const auto below = [&](std::size_t count) { return random() % count; };
  switch (key.type) {
    case KeyText::Type::kNumber: {
      std::uniform_real_distribution<double> within(key.range.min, key.range.max);
      const double value = below(8) == 0 ? key.range.max : within(random);
      return std::strtod(text::toml_number(value).c_str(), nullptr);
    }
    case KeyText::Type::kInteger:
      return std::floor(
          std::uniform_real_distribution<double>(key.range.min, key.range.max)(random));
    case KeyText::Type::kBoolean:
      return below(2) == 0;
    case KeyText::Type::kText: {
      static const std::vector<std::string> kTexts = {
          "", "plain", "a \"quoted\" \\ one", "two\nlines", "# no comment", "gr\xc3\xbc\xc3\x9f"};
      return kTexts[below(kTexts.size())];
    }
    case KeyText::Type::kChoice:
      break;
  }
  return key.choices[below(key.choices.size())];
}

/// Equal within the precision of a file, in which angles are converted.
bool same(const Value& a, const Value& b) {
  const double* x = std::get_if<double>(&a);
  const double* y = std::get_if<double>(&b);
  return x && y ? std::abs(*x - *y) <= 1e-12 * std::abs(*y) : a == b;
}

/// The lines of the file; of those with the value of a key of `wanted`, the text around it.
std::vector<std::string> without_values(const std::string& text,
                                        const std::map<std::string, Value>& wanted) {
  std::vector<std::string> lines = lines_of(text);
  std::string table;
  for (std::string& line : lines) {
    if (line.starts_with('[')) table = line.substr(1, line.find(']') - 1) + ".";
    const std::size_t begin = line.find_first_not_of(' '), equals = line.find(" = ");
    if (line.starts_with('#') || equals == line.npos) continue;
    if (!wanted.contains(table + line.substr(begin, equals - begin))) continue;
    line.erase(equals + 3, std::min(line.find("\t# mine"), line.size()) - equals - 3);
  }
  return lines;
}

TEST(ParameterFile, AnyValuesOfAllParametersReadBackAndNoOtherByteChanges) {
  std::mt19937 random(11);
  const std::vector<KeyText> keys = configuration_keys({});
  for (int round = 0; round < 60; ++round) {
    // A commented file that lacks some keys and is written by hand.
    std::string text;
    for (std::string line : lines_of(write_configuration({}))) {
      const bool has_key = line.find(" = ") != line.npos && !line.starts_with('#');
      if (has_key && random() % 4 == 0) continue;
      if (has_key && random() % 4 == 0) line = "  " + line + "\t# mine, \xc3\xa4";
      text += line + (round % 3 == 1 ? "\r\n" : "\n");
    }
    if (round % 3 == 2) text.pop_back();

    ParameterValues values;
    std::map<std::string, Value> wanted;
    for (const KeyText& key : keys) {
      const Value value = some_value(key, random);
      if (random() % 2 == 0) continue;
      values.emplace_back(key.name, value);
      wanted[key.name] = value;
    }
    const std::string result = edited(text, values);
    const auto before = configuration_keys(parse_configuration(text, "f"));
    const auto after = configuration_keys(parse_configuration(result, "f"));
    ASSERT_EQ(after.size(), keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto found = wanted.find(keys[i].name);
      EXPECT_TRUE(same(after[i].value, found == wanted.end() ? before[i].value : found->second))
          << keys[i].name;
    }

    const std::vector<std::string> old = without_values(text, wanted);
    const std::vector<std::string> now = without_values(result, wanted);
    std::size_t kept = 0;
    for (const std::string& line : now) kept += kept < old.size() && line == old[kept] ? 1U : 0U;
    ASSERT_EQ(kept, old.size()) << "lost: " << old[kept];
    EXPECT_LE(now.size(), old.size() + wanted.size());
  }
}

TEST(ParameterFile, DifferencesAreOfValuesNotOfText) {
  const course::TextFile before{"f", "# note\n[control]\npreview_s = 0.05\n"};
  const course::TextFile after{
      "f", "course = \"3\"\n[control]\npreview_s = 5e-2 # same\nmax_approach_deg = 20\n"};
  const auto differences = parameter_differences(before, after);
  ASSERT_EQ(differences.size(), 2u);
  EXPECT_EQ(differences[0].name, "course");
  EXPECT_EQ(differences[1].name, "control.max_approach_deg");
  EXPECT_EQ(differences[1].before, "24.0");
  EXPECT_EQ(differences[1].after, "20.0");
}

TEST(ParameterFile, HostileNamesAndValuesAreRefusedByName) {
  const std::string file = "[control]\npreview_s = 0.05\n";
  for (const char* unknown : {"control.nonsense", "", "control", "robot.model.wheelbase_m"})
    EXPECT_THAT(edited(file, {{unknown, 1.0}}), HasSubstr(std::string("has no '") + unknown));
  EXPECT_THAT(edited(file, {{"a\nb", 1.0}}), HasSubstr("has no 'a?b'"));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1.0, 1e300})
    EXPECT_THAT(edited(file, {{"control.preview_s", bad}}), HasSubstr("'control.preview_s' is"))
        << bad;
  EXPECT_THAT(edited(file, {{"loop.spin_us", std::nan("")}}), HasSubstr("loop.spin_us takes no"));
  EXPECT_THAT(edited(file, {{"loop.spin_us", 1.5}}), HasSubstr("loop.spin_us takes no value"));
  EXPECT_THAT(edited(file, {{"control.preview_s", std::string("1")}}),
              HasSubstr("preview_s takes"));
  EXPECT_THAT(edited(file, {{"control.law", std::string("bang\nbang")}}),
              HasSubstr("'control.law' is 'bang?bang'"));
  EXPECT_THAT(edited("[control]\npreview_s = 7\n", {{"control.preview_s", 0.1}}),
              HasSubstr("allowed 0 to 1"))
      << "a file that is wrong already is not touched";
}

TEST(ParameterFile, WhoReachesTheDaemonAndWhichFilesItOpensIsNotSaved) {
  std::vector<std::string> kept;
  for (const KeyText& key : configuration_keys({}))
    if (!may_save(key)) kept.push_back(key.name);
  for (const char* name :
       {"server.commands", "server.max_clients", "ros2.enabled", "library", "link.port",
        "record.directory", "camera.listen", "world.address", "world.encoder_file"})
    EXPECT_THAT(kept, testing::Contains(name));
  for (const char* name : {"robot", "course", "setup", "control.preview_s", "loop.rate_hz"})
    EXPECT_THAT(kept, testing::Not(testing::Contains(name)));
}

}  // namespace
}  // namespace tp100::config
