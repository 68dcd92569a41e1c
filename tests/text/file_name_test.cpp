// Names of files and addresses from what people and viewers write.

#include "text/file_name.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace tp100::text {
namespace {

TEST(FileName, IsMadeOfWhatAPersonCalledIt) {
  EXPECT_EQ(file_name_of("slalom (copy)"), "slalom-copy");
  EXPECT_EQ(file_name_of("Größe Ærø – Łódź, Čáslav"), "Groesse-Aero-Lodz-Caslav");
  EXPECT_EQ(file_name_of("../../etc/passwd"), "etc-passwd");
  EXPECT_EQ(file_name_of("...hidden"), "hidden");
  EXPECT_EQ(file_name_of("a  -  b"), "a-b");
  EXPECT_EQ(file_name_of("道路"), "unnamed");
  EXPECT_EQ(file_name_of("a\xff b"), "a-b");
  EXPECT_EQ(file_name_of(std::string(245, 'x')), std::string(64, 'x'));
  EXPECT_EQ(file_name_of(std::string(63, 'x') + "ü"), std::string(63, 'x'));
}

// A run of such a course would be recorded, and then neither listed nor deleted.
TEST(FileName, EveryNameThatIsMadeIsFoundAgain) {
  const std::vector<std::string> pieces = {
      "a", "Z", ".",  "-", "_",  " ",    "/",   std::string(1, '\0'), "\\", "%", "ä",
      "ß", "é", "道", ":", "\n", "\xff", "\xc3"};
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t n = random() % 90; n > 0; --n) text += pieces[random() % pieces.size()];
    const std::string made = file_name_of(text);
    ASSERT_TRUE(is_file_name(made)) << text << " gives " << made;
    ASSERT_TRUE(is_found_name(made)) << made;
    ASSERT_EQ(file_name_of(made), made) << "a name stays as it is";
    ASSERT_TRUE(!is_file_name(text) || made == text) << "a name stays as it is";
    ASSERT_EQ(percent_decoded(percent_encoded(text)), text);
  }
}

TEST(FileName, WhatIsFoundHasNoMeaningInPathsAndAddresses) {
  for (const char* name : {"slalom (copy)", "Prüf strecke", "a&b=c", "道路", "<script>", "a'b\"c"})
    EXPECT_TRUE(is_found_name(name)) << name;
  for (const char* name : {"", ".", "..", ".hidden", "a/b", "a\\b", "c:d", "a%2Fb", "a#b", "a?b",
                           "a\nb", "a\x7f", "\xff"})
    EXPECT_FALSE(is_found_name(name)) << name;
  EXPECT_TRUE(is_found_name(std::string(255, 'a')));
  EXPECT_FALSE(is_found_name(std::string(256, 'a')));
}

TEST(FileName, AnAddressIsReadOnlyIfItIsOne) {
  EXPECT_EQ(percent_encoded("a b/ü"), "a%20b%2F%C3%BC");
  EXPECT_EQ(percent_decoded("a%20b%2f"), "a b/");
  for (const char* text : {"%", "%2", "a%2", "%zz", "%-1", "%+1", "% 1"})
    EXPECT_FALSE(percent_decoded(text)) << text;
}

}  // namespace
}  // namespace tp100::text
