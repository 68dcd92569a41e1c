// Files of people and viewers: every mistake is named with its place, no text overflows the reader,
// and where a value is changed in place, every other byte stays.

#include "text/toml_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <utility>

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

// Seeds and marker ids are read this way.
TEST(TomlDocument, RefusesWhatIsNoIntegerOrOutOfItsRange) {
  long long value = -1;
  const auto error = [&](const char* text) {
    return error_of("seed = " + std::string(text), [&](TomlTable& table) {
      value = table.integer("seed", 1, {0, 250});
    });
  };
  EXPECT_THAT(error("0xFA"), IsEmpty());
  EXPECT_EQ(value, 250);
  for (const char* bad : {"-1", "251", "9223372036854775807", "-9223372036854775808"})
    EXPECT_THAT(error(bad), HasSubstr("0 to 250")) << bad;
  for (const char* bad : {"1.0", "1e300", "nan"})
    EXPECT_THAT(error(bad), HasSubstr("expected an integer")) << bad;
  for (const char* bad : {"9223372036854775808", "0xFFFFFFFFFFFFFFFFFFFF", "1_"})
    EXPECT_THAT(error(bad), HasSubstr("not TOML")) << bad;
}

TEST(TomlDocument, EveryMistakeIsNamedWithItsPlaceAndWhatWasMeant) {
  const auto read = [](TomlTable& t) {
    t.number("speed_mps", 0.1, {0.01, 0.3});
    t.integer("seed", 0, {0, 9});
    t.boolean("on", false);
    t.text("name", "");
    t.choice("type", "line", {"line", "arc"});
    t.table("drive").number("dead_band", 0, {0, 1});
    for (TomlTable one : t.tables("segment")) one.required_number("length_m", {0, 1});
  };
  const char* good =
      "speed_mps = 0.2\nseed = 1\non = true\nname = 'x'\ntype = 'arc'\n[drive]\ndead_band = 0\n"
      "[[segment]]\nlength_m = 1\n";
  EXPECT_EQ(error_of(good, read), "");
  for (const auto& [text, error] : {
           std::pair{"\n sped_mps = 0.1\naa = 2\n",
                     "2:2: unknown key 'sped_mps'; did you mean 'speed_mps'?"},
           {"colour = 1\naa = 2\n", "1:1: unknown key 'colour'; valid here: speed_mps, seed, "},
           {"[drvie]\n", "1:2: unknown key 'drvie'; did you mean 'drive'?"},
           {"[drive]\ndeadband = 0",
            "2:1: unknown key 'drive.deadband'; did you mean 'drive.dead_band'?"},
           {"[[segment]]\nlength_m = 1\n[[segment]]\nlenth_m = 0",
            "4:1: unknown key 'segment.lenth_m'; did you mean 'segment.length_m'?"},
           {"\n[[segment]]\n", "2:1: missing key 'segment.length_m'; it has no default"},
           {"type = 'lnie'", "1:8: 'type' is 'lnie'; did you mean 'line'? Allowed: 'line', 'arc'"},
           {"speed_mps = 3.5", "1:13: 'speed_mps' is 3.5, allowed 0.01 to 0.3 m/s"},
           {"speed_mps = nan", "1:13: 'speed_mps' is nan, allowed 0.01 to 0.3 m/s"},
           {"speed_mps = -inf", "1:13: 'speed_mps' is -inf, allowed"},
           {"speed_mps = 'fast'", "1:13: 'speed_mps' is a string, expected a number"},
           {"seed = 1.0", "1:8: 'seed' is a number, expected an integer"},
           {"on = 1", "1:6: 'on' is an integer, expected true or false"},
           {"name = 1979-05-27", "1:8: 'name' is a date or time, expected a string"},
           {"drive = 1", "1:9: 'drive' is an integer, expected a table"},
           {"[segment]\nb = 1",
            "1:1: 'segment' is a table, expected an array of tables, each headed [[segment]]"},
           {"segment = [1, 2]", "1:11: 'segment' is an array,"},
       })
    EXPECT_THAT(error_of(text, read), StartsWith(std::string("f.toml:") + error)) << text;
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

TEST(TomlDocument, TextThatIsNotTomlIsRefusedByWhatItSeemsToBe) {
  using namespace std::string_literals;
  for (const auto& [text, advice] : {
           std::pair{"speed_mps=0,12"s, "not TOML: a decimal comma; write a decimal point"},
           {"speed_mps = .5"s, "a number that TOML does not have; write 0.5"},
           {"speed_mps = 0.1 m/s"s, "a unit behind the number"},
           {"speed_mps ="s, "a key without a value"},
           {"a = “x”"s, "typographic quotes; write \""},
           {"a = −1"s, "a typographic minus; write -"},
           {"a =\xc2\xa0"
            "1"s,
            "a space that does not break"},
           {"a = True"s, "a word that TOML does not have; write true or false"},
           {"a = 1-straight"s, "a text without quotes; write KEY"},
           {"a = straight"s, "a text without quotes; write KEY"},
           {"a = \"C:\\Users\""s, "a text with a \\; put it in '...'"},
           {"a = \"x"s, "a text whose quote is not closed"},
           {"// note"s, "a comment of another language; write #"},
           {"; note"s, "a comment of another language; write #"},
           {"a = 1\na = 2"s, "there twice; keep one"},
           {"a = 1\n<<<<<<< HEAD\nb = 1\n=======\n>>>>>>> x\n"s, "a git conflict; keep one"},
           {"<<<<<<< HEAD\na = 1\n=======\n>>>>>>> x\n"s, "a git conflict; keep one"},
           {"{\"a\": 1}"s, "JSON; write TOML"},
           {"\n [ {\"a\": 1}]"s, "JSON; write TOML"},
           {"a: 1\nb:\n  - c"s, "YAML; write TOML"},
           {"---\na: 1"s, "YAML; write TOML"},
           {"<?xml version=\"1.0\"?><robot/>"s, "XML; write TOML"},
           {"<gpx></gpx>"s, "a GPX track"},
           {"<!DOCTYPE html><html>"s, "a web page; download the file itself"},
           {"version https://git-lfs.github.com/spec/v1\n"s, "run git lfs pull"},
           {"PK\x03\x04\0\0"s, "a ZIP archive; unpack it"},
           {"\0\0\0\0"s, "only zero bytes"},
           {"a\0=\0001\0"s, "save it as UTF-8"},
           {"# f\xfcr\na = 1"s, "text in another encoding; save it as UTF-8"},
           {"!"s, "write KEY = VALUE, [TABLE] or # COMMENT"},
       })
    EXPECT_THAT(error_of(text, read_speed), HasSubstr(advice)) << text;
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
  // Values that may stand in an inline table, and these with those that may not.
  const std::vector<std::string> on_one_line = {
      R"("")",           R"('')",       R"("\"")",        R"("\\")",
      R"('\')",          R"("'")",      R"('"')",         R"("#")",
      R"('#')",          R"("""""")",   R"('''''')",      R"("""a"""")",
      R"("""a""""")",    R"("""\"""")", R"("""\"""a""")", R"(""""a""b""""")",
      R"('''a''b''''')", R"('''\''')"};
  std::vector<std::string> values = {
      "\"\"\"\n\"\n\"\"\"",     "'''\n'\n'''",      "\"\"\"\\\n\"\"\"", "[\n1.5, # ]\"\n]",
      R"([["a", 'b'], ["#"]])", R"({ a.b = '"' })", R"(1.5 # ")",       "1.5 # '''",
      "2026-11-29T14:00:00.5",  R"("""'''""")",     R"('''"""''')"};
  values.insert(values.end(), on_one_line.begin(), on_one_line.end());
  const std::vector<std::string> parts = {".a", ".\"b.,=\"", " . 'c[{'", ".1"};
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    std::string text, key = "x";
    for (int i = 0; i < 6; ++i)
      text += "k" + std::to_string(i) + " = " + values[random() % values.size()] + "\n";
    for (int i = 0; i < 40; ++i) key += parts[random() % parts.size()];
    const std::string inside = "y = { z = " + on_one_line[random() % on_one_line.size()] + ", ";
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

TEST(WithValues, ANameThatLeadsThroughAValueIsRefused) {
  EXPECT_THAT(test::refusal([] {
                with_values("drive = 1", "f.toml", {{"drive.kp", 2.0}});
              }),
              StartsWith("f.toml: 'drive' is not a table, so it has no 'kp'"));
}

std::string edited(const std::string& text, const NamedValues& values) {
  std::string result;
  const std::string error =
      test::refusal([&] { result = with_values_in_place(text, "f.toml", values); });
  return error.empty() ? result : "refused: " + error;
}

TEST(TomlEdit, ReplacesValuesAndNothingElse) {
  EXPECT_EQ(edited("# head \xc3\xa4\nname = \"\xc3\xa4\xf0\x9f\x98\x80\" # why\n\n[ drive ] # d\n"
                   "  kp=2.0# gain\n\tki\t=\t-1e-3\n'kd' = 0x10\nlist = [1,\n 2]\n",
                   {{"name", std::string("a \"b\"\\\n")},
                    {"drive.kp", 3.5},
                    {"drive.ki", -0.25},
                    {"drive.kd", 7LL}}),
            "# head \xc3\xa4\nname = \"a \\\"b\\\"\\\\\\u000A\" # why\n\n[ drive ] # d\n"
            "  kp=3.5# gain\n\tki\t=\t-0.25\n'kd' = 7\nlist = [1,\n 2]\n");
  EXPECT_EQ(edited("a = '''x\ny''' # z\nb = {c = 1, d = 2}\n", {{"a", true}, {"b.d", 3LL}}),
            "a = true # z\nb = {c = 1, d = 3}\n");
}

TEST(TomlEdit, NewKeysStandBehindTheLastOnesOfTheirTable) {
  EXPECT_EQ(edited("a = 1 # one\n# of t\n[t]\nb = 2\n# end\n[u]\n",
                   {{"t.c", 3LL}, {"t.d", 4LL}, {"z", 5LL}, {"u.e", 6LL}, {"v.f", 0.5}}),
            "a = 1 # one\nz = 5\n# of t\n[t]\nb = 2\nc = 3\nd = 4\n# end\n[u]\ne = 6\n\n[v]\n"
            "f = 0.5\n");
  EXPECT_EQ(edited("", {{"f", 0.5}}), "f = 0.5\n");
  EXPECT_EQ(edited("# head\n[t]\nb = 1\n", {{"a", true}}), "a = true\n# head\n[t]\nb = 1\n");
  EXPECT_EQ(edited("t.b = 1\nc = 2\n", {{"t.d", 3LL}}), "t.b = 1\nt.d = 3\nc = 2\n");
  EXPECT_EQ(edited("[t]\nb = [\n 1,\n 2 ]\n[t.s]\n", {{"t.d", 3LL}}),
            "[t]\nb = [\n 1,\n 2 ]\nd = 3\n[t.s]\n");
}

TEST(TomlEdit, KeepsCarriageReturns) {
  EXPECT_EQ(edited("a = 1\r\n[t]\r\nb = 2\r\n", {{"a", 3LL}, {"t.c", 4LL}}),
            "a = 3\r\n[t]\r\nb = 2\r\nc = 4\r\n");
}

TEST(TomlEdit, RefusesWhatItCannotChangeInPlace) {
  EXPECT_THAT(edited("t = 1\n", {{"t.a", 2LL}}), HasSubstr("f.toml: 't' is not a table"));
  EXPECT_THAT(edited("[t]\n", {{"t", 2LL}}), HasSubstr("'t' is a table"));
  EXPECT_THAT(edited("t = {a = 1}\n", {{"t.b", 2LL}}), HasSubstr("'t' is written on one line"));
  EXPECT_THAT(edited("t = [\n", {{"t", 2LL}}), HasSubstr("f.toml:"));
}

}  // namespace
}  // namespace tp100::text
