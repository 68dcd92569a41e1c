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

TEST(Bundle, HoldsEveryFileOfThePageWithATagOfItsOwn) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("daemon/web/dist"))) {
    const File* file = find("/" + entry.path().filename().string());
    ASSERT_NE(file, nullptr) << entry.path();
    EXPECT_FALSE(file->mime.empty());
    EXPECT_EQ(file->bytes.size(), entry.file_size());
    EXPECT_TRUE(file->etag.starts_with('"') && file->etag.ends_with('"')) << file->etag;
    EXPECT_EQ(std::ranges::count(bundle(), file->etag, &File::etag), 1) << file->path;
    ++files;
  }
  EXPECT_EQ(bundle().size(), files);
  EXPECT_EQ(find("/"), find("/index.html"));
  for (const char* other : {"", "/../CMakeLists.txt", "/cockpit.js/"})
    EXPECT_EQ(find(other), nullptr) << other;
}

}  // namespace
}  // namespace tp100::web
