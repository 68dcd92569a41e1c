// The page as it is built into tp100d.
#include "web/bundle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

#include "support/paths.h"

namespace tp100::web {
namespace {

std::filesystem::path dist() { return source_path("daemon/web/dist"); }

TEST(Bundle, HoldsEveryFileOfThePage) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dist())) {
    const File* file = find("/" + entry.path().filename().string());
    ASSERT_NE(file, nullptr) << entry.path();
    EXPECT_FALSE(file->mime.empty());
    EXPECT_EQ(file->bytes.size(), entry.file_size());
    ++files;
  }
  EXPECT_EQ(bundle().size(), files);
}

TEST(Bundle, AnswersTheRootWithThePageAndKnowsNothingElse) {
  const File* page = find("/");
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page, find("/index.html"));
  EXPECT_EQ(page->mime, "text/html; charset=utf-8");
  for (const char* other : {"", "/../CMakeLists.txt", "/cockpit.js/"})
    EXPECT_EQ(find(other), nullptr) << other;
}

TEST(Bundle, TagsDifferAndAreQuoted) {
  for (const File& file : bundle()) {
    ASSERT_GT(file.etag.size(), 2U);
    EXPECT_EQ(file.etag.front(), '"');
    EXPECT_EQ(file.etag.back(), '"');
    EXPECT_EQ(std::ranges::count(bundle(), file.etag, &File::etag), 1) << file.path;
  }
}

}  // namespace
}  // namespace tp100::web
