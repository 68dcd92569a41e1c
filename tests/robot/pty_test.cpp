#include "sim/robot/pty.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "../support/temporary_folder.h"
#include "core/error.h"

namespace tp100::sim {
namespace {

namespace fs = std::filesystem;

class PtyTest : public testing::Test {
 protected:
  std::string link() const { return folder_.file("tp100"); }
  test::TemporaryFolder folder_;
};

TEST_F(PtyTest, NoticesOpeningAndClosing) {
  Pty pty("");
  EXPECT_FALSE(pty.open());
  const int client = ::open(pty.device().c_str(), O_RDWR | O_NOCTTY);
  ASSERT_GE(client, 0);
  EXPECT_TRUE(pty.open());
  ::close(client);
  EXPECT_FALSE(pty.open());
}

TEST_F(PtyTest, ReplacesADanglingLinkAndRemovesItsOwn) {
  fs::create_symlink("/dev/pts/no-such", link());
  {
    Pty pty(link());
    EXPECT_EQ(fs::read_symlink(link()), pty.device());
  }
  EXPECT_FALSE(fs::is_symlink(link()));
}

TEST_F(PtyTest, DoesNotReplaceAFileOrALiveLink) {
  std::ofstream(link()) << "mine";
  EXPECT_THROW(Pty pty(link()), UserError);
  EXPECT_TRUE(fs::is_regular_file(link()));
  const std::string other = folder_.file("other");
  Pty first(other);
  EXPECT_THROW(Pty second(other), UserError);
}

}  // namespace
}  // namespace tp100::sim
