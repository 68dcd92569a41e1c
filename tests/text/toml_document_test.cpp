#include "text/toml_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "support/refusal.h"

namespace tp100::text {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// The error message for `text`; empty if there is no error.
std::string error_of(const std::string& text, const std::function<void(TomlTable&)>& read) {
  return test::refusal([&] {
    TomlDocument document(text, "f.toml");
    TomlTable root = document.root();
    read(root);
    root.finish();
  });
}

void read_speed(TomlTable& table) { table.number("speed_mps", 0.1, {0.01, 0.3}); }

TEST(TomlDocument, NamesTheFirstUnknownKeyAndTheNearestOrAllValidNames) {
  EXPECT_EQ(error_of("\n speeed_mps = 0.1\naa = 2\n", read_speed),
            "f.toml:2:2: unknown key 'speeed_mps'; did you mean 'speed_mps'?");
  EXPECT_EQ(error_of("colour = 1\naa = 2\n", read_speed),
            "f.toml:1:1: unknown key 'colour'; valid here: speed_mps");
  const auto read = [](TomlTable& t) { t.choice("type", "line", {"line", "arc"}); };
  EXPECT_EQ(error_of("type = 'lnie'", read),
            "f.toml:1:8: 'type' is 'lnie'; did you mean 'line'? Allowed: 'line', 'arc'");
  EXPECT_EQ(error_of("type = 'arc'", read), "");
}

// Seeds and marker ids are read this way.
TEST(TomlDocument, RefusesAnIntegerOutOfItsRange) {
  long long value = -1;
  const auto read = [&](TomlTable& table) { value = table.integer("seed", 1, {0, 250}); };
  for (const auto& [good, means] : {std::pair{"0", 0},
                                    {"-0", 0},
                                    {"+7", 7},
                                    {"250", 250},
                                    {"0xFA", 250},
                                    {"0o372", 250},
                                    {"0b1111_1010", 250}}) {
    EXPECT_THAT(error_of("seed = " + std::string(good), read), IsEmpty());
    EXPECT_EQ(value, means) << good;
  }
  for (const char* bad :
       {"-1", "251", "0xFB", "0x7FFFFFFFFFFFFFFF", "9223372036854775807", "-9223372036854775808"})
    EXPECT_THAT(error_of("seed = " + std::string(bad), read),
                testing::AllOf(StartsWith("f.toml:1:8: 'seed' is "), HasSubstr("0 to 250")))
        << bad;
}

TEST(TomlDocument, RefusesWhatIsNoIntegerOfSixtyFourBits) {
  const auto read = [](TomlTable& table) { table.integer("seed", 1, {0, 250}); };
  for (const char* bad : {"1.5", "1.0", "1e2", "1e300", "nan", "inf"})
    EXPECT_THAT(error_of("seed = " + std::string(bad), read), HasSubstr("expected an integer"))
        << bad;
  for (const char* bad : {"9223372036854775808", "-9223372036854775809", "0x8000000000000000",
                          "0xFFFFFFFFFFFFFFFFFFFF", "0x", "1_", "007", "-0x1", "--1"})
    EXPECT_THAT(error_of("seed = " + std::string(bad), read),
                testing::AllOf(StartsWith("f.toml:1:"), HasSubstr("not TOML")))
        << bad;
}

TEST(TomlDocument, SaysValueRangeAndUnitWhenOutOfRange) {
  EXPECT_EQ(error_of("speed_mps = 3.5", read_speed),
            "f.toml:1:13: 'speed_mps' is 3.5, allowed 0.01 to 0.3 m/s");
  EXPECT_THAT(error_of("speed_mps = nan", read_speed),
              HasSubstr("is nan, allowed 0.01 to 0.3 m/s"));
  EXPECT_THAT(error_of("speed_mps = -inf", read_speed), HasSubstr("is -inf, allowed"));
}

TEST(TomlDocument, SaysFoundAndExpectedType) {
  EXPECT_EQ(error_of("speed_mps = 'fast'", read_speed),
            "f.toml:1:13: 'speed_mps' is a string, expected a number");
  EXPECT_EQ(error_of("a = 1.0",
                     [](TomlTable& t) {
                       t.integer("a", 0, {0, 9});
                     }),
            "f.toml:1:5: 'a' is a number, expected an integer");
  EXPECT_EQ(error_of("a = 1", [](TomlTable& t) { t.boolean("a", false); }),
            "f.toml:1:5: 'a' is an integer, expected true or false");
  EXPECT_EQ(error_of("a = 1979-05-27", [](TomlTable& t) { t.text("a", ""); }),
            "f.toml:1:5: 'a' is a date or time, expected a string");
  EXPECT_EQ(error_of("a = 1", [](TomlTable& t) { t.table("a"); }),
            "f.toml:1:5: 'a' is an integer, expected a table");
  EXPECT_THAT(error_of("[a]\nb = 1", [](TomlTable& t) { t.tables("a"); }),
              HasSubstr("'a' is a table, expected an array of tables, each headed [[a]]"));
  EXPECT_THAT(error_of("a = [1, 2]", [](TomlTable& t) { t.tables("a"); }),
              HasSubstr("is an array,"));
}

TEST(TomlDocument, ReportsAMissingKeyOrItsMisspelling) {
  const auto read = [](TomlTable& t) { t.table("a").required_number("length_m", {0, 1}); };
  EXPECT_EQ(error_of("\n[a]\n", read), "f.toml:2:1: missing key 'a.length_m'; it has no default");
  EXPECT_EQ(error_of("[a]\nlenght_m = 1\n", read),
            "f.toml:2:1: unknown key 'a.lenght_m'; did you mean 'a.length_m'?");
}

TEST(TomlDocument, FindsUnknownKeysInTablesAndInArraysOfTables) {
  const auto read = [](TomlTable& t) {
    t.table("drive").number("dead_band", 0, {0, 1});
    for (TomlTable one : t.tables("segment")) one.number("length_m", 0, {0, 1});
  };
  EXPECT_THAT(
      error_of("[drive]\ndeadband = 0", read),
      StartsWith("f.toml:2:1: unknown key 'drive.deadband'; did you mean 'drive.dead_band'?"));
  EXPECT_THAT(error_of("[[segment]]\n[[segment]]\nlenth_m = 0", read),
              StartsWith("f.toml:3:1: unknown key 'segment.lenth_m'"));
  EXPECT_THAT(error_of("[drvie]\n", read), HasSubstr("did you mean 'drive'?"));
}

TEST(TomlDocument, RefusesTextThatIsNotTomlAtItsPlace) {
  EXPECT_THAT(error_of("a = 1\nb = = 2\n", read_speed), StartsWith("f.toml:2:"));
  EXPECT_THAT(error_of("a = 1\na = 2\n", read_speed), StartsWith("f.toml:2:"));
  EXPECT_THAT(error_of("a = 1\n\x01", read_speed), StartsWith("f.toml:2:"));
  EXPECT_THAT(error_of("a = \"\xc3\x28\"\n", read_speed), StartsWith("f.toml:1:"));
  EXPECT_THAT(error_of(std::string("a = 1\0 # nul", 12), read_speed), StartsWith("f.toml:1:"));
  EXPECT_THAT(error_of("speed_mps = 1e999", read_speed), StartsWith("f.toml:1:"));
  EXPECT_THAT(error_of("\"\\u001b[31m\\n\" = 1", read_speed), HasSubstr("unknown key '?[31m?'"));
}

TEST(TomlDocument, SurvivesDeepAndLargeFiles) {
  std::string dotted = "a", brackets = "a = ", tables;
  for (int i = 0; i < 100000; ++i) dotted += ".a";
  for (int i = 0; i < 100000; ++i) brackets += "[";
  for (int i = 0; i < 120; ++i) tables += "[{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = [\n";
  EXPECT_THAT(error_of(dotted + " = 1", read_speed), HasSubstr("more than 32 dots"));
  EXPECT_THAT(error_of("[" + dotted + "]", read_speed), HasSubstr("more than 32 dots"));
  EXPECT_THAT(error_of(brackets, read_speed), StartsWith("f.toml:1:"));
  EXPECT_THAT(error_of("a = " + tables, read_speed), StartsWith("f.toml:"));
  EXPECT_THAT(error_of(std::string(kMaxTomlSize + 1, '#'), read_speed),
              HasSubstr("larger than 256 kB"));
  EXPECT_THAT(error_of(std::string(100000, 'a').append(" = 1"), read_speed), HasSubstr("aaa...'"));
}

// A fence of many corners is written on one line.
TEST(TomlDocument, DotsThatAreInNoKeyAreNotCounted) {
  std::string corners = "polygon = [";
  for (int i = 0; i < 100; ++i) corners += "[0.5, -1.25e-1], ";
  const std::string dots(99, '.');
  for (const std::string& text : {corners + "]", "text = \"" + dots + "\"", "a = 1 # " + dots,
                                  "text = \"\"\"\n" + dots + "\n\"\"\"", "text = '" + dots + "'"})
    EXPECT_THAT(error_of(text + "\n", read_speed), Not(HasSubstr("dots"))) << text;
}

// A text of a viewer that hides a deep key from the count would overflow the stack.
TEST(TomlDocument, NoTextBeforeItHidesADeepKey) {
  const std::vector<std::string> values = {R"("")",
                                           R"('')",
                                           R"("\"")",
                                           R"("\\")",
                                           R"('\')",
                                           R"("'")",
                                           R"('"')",
                                           R"("#")",
                                           R"('#')",
                                           R"("""""")",
                                           R"('''''')",
                                           R"("""a"""")",
                                           R"("""a""""")",
                                           R"("""\"""")",
                                           R"("""\"""a""")",
                                           R"(""""a""b""""")",
                                           R"('''a''b''''')",
                                           R"('''\''')",
                                           "\"\"\"\n\"\n\"\"\"",
                                           "'''\n'\n'''",
                                           "\"\"\"\\\n\"\"\"",
                                           "[\n1.5, # ]\"\n]",
                                           R"([["a", 'b'], ["#"]])",
                                           R"({ a.b = '"' })",
                                           R"(1.5 # ")",
                                           "1.5 # '''",
                                           "2026-11-29T14:00:00.5",
                                           R"("""'''""")",
                                           R"('''"""''')"};
  constexpr std::size_t kOneLine = 18;  // values that an inline table may have
  const std::vector<std::string> parts = {".a", ".\"b.,=\"", " . 'c[{'", ".1"};
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    std::string text, key = "x";
    for (int i = 0; i < 6; ++i)
      text += "k" + std::to_string(i) + " = " + values[random() % values.size()] + "\n";
    for (int i = 0; i < 40; ++i) key += parts[random() % parts.size()];
    const std::string inside = "y = { z = " + values[random() % kOneLine] + ", ";
    const auto how = random() % 3;
    const auto with = [&](const std::string& last) {
      return text + (how == 0   ? "[" + last + "]\n"
                     : how == 1 ? last + " = 1\n"
                                : inside + last + " = 1 }\n");
    };
    ASSERT_THAT(error_of(with("x.a"), read_speed),
                Not(AnyOf(HasSubstr("dots"), HasSubstr("not TOML"))))
        << with("x.a");
    ASSERT_THAT(error_of(with(key), read_speed), HasSubstr("more than 32 dots")) << with(key);
  }
}

TEST(TomlDocument, ValuesAreOfAnySimpleType) {
  EXPECT_EQ(error_of("a = true\nb = 3\nc = 0.5\nd = \"x\"\ne = [1, 2.5, \"y\"]\n[f]\n",
                     [](TomlTable& t) {
                       EXPECT_EQ(t.required_value("a"), TomlValue(true));
                       EXPECT_EQ(t.required_value("b"), TomlValue(3LL));
                       EXPECT_EQ(t.required_value("c"), TomlValue(0.5));
                       EXPECT_EQ(t.required_value("d"), TomlValue(std::string("x")));
                       EXPECT_THAT(t.values("e"), ElementsAre(TomlValue(1LL), TomlValue(2.5),
                                                              TomlValue(std::string("y"))));
                       EXPECT_THAT(t.values("none"), IsEmpty());
                       EXPECT_TRUE(t.holds_table("f"));
                       EXPECT_FALSE(t.holds_table("a"));
                       t.table("f");
                     }),
            "");
  const auto read = [](TomlTable& t) { t.required_value("a"); };
  EXPECT_EQ(error_of("a = [1]", read),
            "f.toml:1:5: 'a' is an array, expected true, false, a number or a string");
  EXPECT_THAT(error_of("b = 1", read), HasSubstr("missing key 'a'"));
}

TEST(WithValues, OtherValuesStandInTheirPlacesAndNewOnesBesideThem) {
  const std::string text = with_values("# note\nspeed = 1\n[drive]\nkp = 2.0\n", "f.toml",
                                       {{"drive.kp", 3.5},
                                        {"drive.ki", 4LL},
                                        {"body.shape.name", std::string("flat \"x\"")},
                                        {"on", true}});
  EXPECT_EQ(error_of(text,
                     [](TomlTable& t) {
                       EXPECT_EQ(t.required_value("speed"), TomlValue(1LL));
                       EXPECT_EQ(t.required_value("on"), TomlValue(true));
                       TomlTable drive = t.table("drive");
                       EXPECT_EQ(drive.required_value("kp"), TomlValue(3.5));
                       EXPECT_EQ(drive.required_value("ki"), TomlValue(4LL));
                       EXPECT_EQ(t.table("body").table("shape").required_value("name"),
                                 TomlValue(std::string("flat \"x\"")));
                     }),
            "");
}

TEST(WithValues, APathThroughAValueIsRefused) {
  EXPECT_EQ(test::refusal([&] {
              with_values("drive = 1", "f.toml", {{"drive.kp", 2.0}});
            }),
            "f.toml: 'drive' is not a table, so it has no 'kp'");
}

TEST(WithoutKeys, OtherValuesStay) {
  const std::string text = without_keys(
      "# note\nspeed = 0.1\nname = 'x'\n[start]\nx = 1\n[[segment]]\ny = 2\n[[segment]]\n"
      "[fence]\ncorners = [[0.1, -2.5e-7], [3, 4]]\n",
      "f.toml", {"name", "segment", "start", "none"});
  EXPECT_EQ(
      error_of(text,
               [](TomlTable& t) {
                 EXPECT_EQ(t.keys(), (std::vector<std::string>{"fence", "speed"}));
                 EXPECT_EQ(t.required_value("speed"), TomlValue(0.1));
                 const auto corners = t.table("fence").pairs("corners", {-10.0, 10.0});
                 EXPECT_EQ(corners, (std::vector<std::array<double, 2>>{{0.1, -2.5e-7}, {3, 4}}));
               }),
      "");
  EXPECT_THROW(without_keys("a = ", "f.toml", {}), SetupError);
}

}  // namespace
}  // namespace tp100::text
