#include "text/toml_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace tp100::text {
namespace {

using ::testing::HasSubstr;

std::string edited(const std::string& text, const NamedValues& values) {
  try {
    return with_values_in_place(text, "f.toml", values);
  } catch (const SetupError& error) {
    return std::string("refused: ") + error.what();
  }
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

TEST(TomlEdit, AValueAtTheEndNeedsNoLineEnd) {
  EXPECT_EQ(edited("a = 1", {{"a", 22LL}}), "a = 22");
  EXPECT_EQ(edited("a = \"x\"", {{"a", 22LL}}), "a = 22");
  EXPECT_EQ(edited("a = true", {{"a", false}}), "a = false");
  EXPECT_EQ(edited("a = 1", {{"b", 2LL}}), "a = 1\nb = 2\n");
  EXPECT_EQ(edited("[t]", {{"t.b", 2LL}, {"u.c", 3LL}}), "[t]\nb = 2\n\n[u]\nc = 3\n");
}

TEST(TomlEdit, NewKeysStandBehindTheLastOnesOfTheirTable) {
  EXPECT_EQ(edited("a = 1 # one\n# of t\n[t]\nb = 2\n# end\n[u]\n",
                   {{"t.c", 3LL}, {"t.d", 4LL}, {"z", 5LL}, {"u.e", 6LL}, {"v.f", 0.5}}),
            "a = 1 # one\nz = 5\n# of t\n[t]\nb = 2\nc = 3\nd = 4\n# end\n[u]\ne = 6\n\n[v]\n"
            "f = 0.5\n");
  EXPECT_EQ(edited("", {{"v.f", 0.5}}), "[v]\nf = 0.5\n");
  EXPECT_EQ(edited("", {{"f", 0.5}}), "f = 0.5\n");
  EXPECT_EQ(edited("# head\n[t]\nb = 1\n", {{"a", true}}), "a = true\n# head\n[t]\nb = 1\n");
  EXPECT_EQ(edited("t.b = 1\nc = 2\n", {{"t.d", 3LL}}), "t.b = 1\nt.d = 3\nc = 2\n");
  EXPECT_EQ(edited("[t]\nb = [\n 1,\n 2 ]\n[t.s]\n", {{"t.d", 3LL}}),
            "[t]\nb = [\n 1,\n 2 ]\nd = 3\n[t.s]\n");
}

TEST(TomlEdit, KeepsCarriageReturnsAndTheByteOrderMark) {
  EXPECT_EQ(edited("\xef\xbb\xbf"
                   "a = 1\r\n[t]\r\nb = 2\r\n",
                   {{"a", 3LL}, {"t.c", 4LL}}),
            "\xef\xbb\xbf"
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
