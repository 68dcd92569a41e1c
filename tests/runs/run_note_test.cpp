#include "runs/run_note.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace tp100::runs {
namespace {

using ::testing::HasSubstr;

TEST(RunNote, IsReadAsItWasWritten) {
  const RunNote note{.name = "Wet \"floor\" \\ \xE2\x9C\x93",
                     .note = "first line\nsecond = \"line\"\t# no comment",
                     .tags = "wet lab",
                     .keep = true};
  const RunNote again = parse_run_note(write_run_note(note), "run.toml");
  EXPECT_EQ(again.name, note.name);
  EXPECT_EQ(again.note, note.note);
  EXPECT_EQ(again.tags, note.tags);
  EXPECT_TRUE(again.keep);
}

TEST(RunNote, KeepsWhatAChangeDoesNotName) {
  const RunNote note =
      changed({.name = "a", .note = "b", .tags = "c", .keep = true}, {.note = "", .keep = false});
  EXPECT_EQ(note.name, "a");
  EXPECT_EQ(note.note, "");
  EXPECT_EQ(note.tags, "c");
  EXPECT_FALSE(note.keep);
  EXPECT_TRUE(changed(note, {.name = "", .tags = ""}).empty());
}

TEST(RunNote, TakesNoControlCharactersNoForeignBytesAndNoEndlessText) {
  using namespace std::string_literals;
  for (const std::string& bad : {"a\0b"s, "a\nb"s, "\x1b[31m"s, "\x7f"s, "\xff"s, "\xc0\x80"s,
                                 "\xed\xa0\x80"s, std::string(kMaxRunName + 1, 'x')}) {
    EXPECT_THAT(why_not({.name = bad}), HasSubstr("name takes"));
    EXPECT_THAT(why_not({.tags = bad.size() > kMaxRunName ? std::string(kMaxTags + 1, 'x') : bad}),
                HasSubstr("tags takes"));
  }
  EXPECT_EQ(why_not({.note = "two\nlines\tand a tab"}), "");
  EXPECT_THAT(why_not({.note = "a\0b"s}), HasSubstr("note takes"));
  EXPECT_THAT(why_not({.note = std::string(kMaxNote + 1, 'x')}), HasSubstr("note takes"));
  EXPECT_EQ(why_not({.name = std::string(kMaxRunName, 'x')}), "");
}

TEST(RunNote, ErrorsInTheFileAreNamedWithTheirPlace) {
  for (const char* text : {"nmae = \"x\"", "keep = 1", "name = ", "name = \"a\\u0000b\"", "\xff"})
    EXPECT_THROW(parse_run_note(text, "run.toml"), SetupError) << text;
  try {
    parse_run_note("\nnmae = \"x\"", "run.toml");
  } catch (const SetupError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run.toml:2:1"));
    EXPECT_THAT(error.what(), HasSubstr("name"));
  }
}

}  // namespace
}  // namespace tp100::runs
