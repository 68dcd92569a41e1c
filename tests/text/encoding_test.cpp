// Text as editors of other systems save it.

#include "text/encoding.h"

#include <gtest/gtest.h>

namespace tp100::text {
namespace {

using namespace std::string_literals;

TEST(Encoding, ReadsWhatProgramsOnWindowsSave) {
  EXPECT_EQ(as_utf8("\xef\xbb\xbf"
                    "a"),
            "a");
  EXPECT_EQ(as_utf8("\xff\xfe\x61\0\xfc\0\xac\x20\x3d\xd8\x42\xde\x0a\0"s), "aü€🙂\n");
  EXPECT_EQ(as_utf8("\xfe\xff\0\x61\0\xfc\x20\xac\xd8\x3d\xde\x42\0\x0a"s), "aü€🙂\n");
}

TEST(Encoding, KeepsTheRestAndReplacesHalfACharacter) {
  for (const std::string& text : {""s, "a"s, "\xff"s, "\xfc"s, "a\0b"s})
    EXPECT_EQ(as_utf8(text), text);
  EXPECT_EQ(as_utf8("\xff\xfe\x3d\xd8\x61\0\x42\xde\x7a"s),
            "\xef\xbf\xbd"
            "a\xef\xbf\xbd");
}

}  // namespace
}  // namespace tp100::text
