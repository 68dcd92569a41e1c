#include "link/transport.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "../support/temporary_folder.h"
#include "core/error.h"
#include "pty_pair.h"

namespace tp100::link {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string failure(const std::string& path) {
  try {
    open_port(path, {});
  } catch (const SetupError& error) {
    return error.what();
  }
  return "no error";
}

class Transport : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  PtyPair pty_;
};

TEST_F(Transport, GivesARawNonBlockingCloseOnExecDescriptor) {
  const Port port = open_port(pty_.near(), {});
  EXPECT_TRUE(port.pseudo_terminal());
  EXPECT_TRUE(::fcntl(port.fd(), F_GETFL) & O_NONBLOCK);
  EXPECT_TRUE(::fcntl(port.fd(), F_GETFD) & FD_CLOEXEC);
  termios settings{};
  ASSERT_EQ(::tcgetattr(port.fd(), &settings), 0);
  EXPECT_EQ(settings.c_cc[VMIN], 1);
  EXPECT_EQ(settings.c_lflag & (ICANON | ECHO), 0u);
  EXPECT_EQ(settings.c_cflag & HUPCL, 0u);
  std::uint8_t byte = 0;
  EXPECT_EQ(::read(port.fd(), &byte, 1), -1);
  EXPECT_EQ(errno, EAGAIN);
}

TEST_F(Transport, PassesEveryByteBothWays) {
  const Port port = open_port(pty_.near(), {});
  std::vector<std::uint8_t> all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  pty_.write(all);
  std::vector<std::uint8_t> got(all.size());
  std::size_t n = 0;
  for (int tries = 0; n < got.size() && tries < 1000; ++tries) {
    pollfd wait{port.fd(), POLLIN, 0};
    ::poll(&wait, 1, 100);
    const ssize_t more = ::read(port.fd(), got.data() + n, got.size() - n);
    if (more > 0) n += static_cast<std::size_t>(more);
  }
  EXPECT_EQ(got, all);
  ASSERT_EQ(::write(port.fd(), all.data(), all.size()), static_cast<ssize_t>(all.size()));
  EXPECT_TRUE(pty_.wait(1000));
  EXPECT_EQ(pty_.read(), all);
}

TEST_F(Transport, OpensThroughASymbolicLink) {
  const auto link = folder_.path() / "robot";
  std::filesystem::create_symlink(pty_.near(), link);
  EXPECT_TRUE(open_port(link.string(), {}).is_open());
}

TEST_F(Transport, OpensAPseudoTerminalWhateverSpeedIsAsked) {
  PortOptions options;
  options.baud = 123457;
  EXPECT_TRUE(open_port(pty_.near(), options).is_open());
}

TEST_F(Transport, KnowsAPseudoTerminalByItsNumberOnly) {
  for (const unsigned number : {136U, 140U, 143U})
    EXPECT_TRUE(is_pseudo_terminal(S_IFCHR, ::makedev(number, 3)));
  // Major numbers of the Mega's driver, of bridge drivers, of 16550s, of a pty's master and of old
  // ptys.
  for (const unsigned number : {166U, 188U, 4U, 5U, 3U, 128U, 135U, 144U})
    EXPECT_FALSE(is_pseudo_terminal(S_IFCHR, ::makedev(number, 3)));
  EXPECT_FALSE(is_pseudo_terminal(S_IFREG, ::makedev(136, 3)));
  struct stat status {};
  ASSERT_EQ(::stat(pty_.near().c_str(), &status), 0);
  const std::string node = folder_.file("ttyACM0");
  if (::mknod(node.c_str(), S_IFCHR | 0600, status.st_rdev) != 0)
    GTEST_SKIP() << "only root makes a device's node; run it as root";
  Port port;
  try {
    port = open_port(node, {});
  } catch (const SetupError& error) {
    GTEST_SKIP() << "no devices are opened in this folder: " << error.what();
  }
  EXPECT_TRUE(port.pseudo_terminal()) << "its name must not matter";
}

TEST_F(Transport, SaysThatAPortIsMissing) {
  const std::string message = failure(folder_.file("none"));
  EXPECT_THAT(message, HasSubstr("none: no such port"));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  std::filesystem::create_symlink(folder_.path() / "nowhere", folder_.path() / "dangling");
  EXPECT_THAT(failure(folder_.file("dangling")), HasSubstr("no such port"));
}

TEST_F(Transport, RefusesASecondClientUntilTheFirstIsGone) {
  {
    const Port port = open_port(pty_.near(), {});
    EXPECT_THAT(failure(pty_.near()), HasSubstr("port is busy"));
  }
  EXPECT_TRUE(open_port(pty_.near(), {}).is_open());
}

TEST_F(Transport, NamesTheProgramThatHoldsAPort) {
  int ready[2];
  int finish[2];
  ASSERT_EQ(::pipe(ready), 0);
  ASSERT_EQ(::pipe(finish), 0);
  const std::string path = pty_.near();
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pty_.far());
    ::close(finish[1]);
    const int fd = ::open(path.c_str(), O_RDWR | O_NOCTTY);
    ::flock(fd, LOCK_EX | LOCK_NB);
    char byte = 'x';
    if (::write(ready[1], &byte, 1) < 0 || ::read(finish[0], &byte, 1) < 0) ::_exit(1);
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const std::string message = failure(path);
  for (const int fd : {ready[0], ready[1], finish[0], finish[1]}) ::close(fd);
  EXPECT_THAT(message, HasSubstr("port is busy, held by "));
  EXPECT_THAT(message, HasSubstr("pid"));
}

TEST_F(Transport, RefusesWhatIsNoSerialPort) {
  std::ofstream(folder_.path() / "file") << "x";
  EXPECT_THAT(failure(folder_.file("file")), HasSubstr("not a serial port"));
  EXPECT_THAT(failure(folder_.path().string()), HasSubstr("not a serial port"));
  EXPECT_THAT(failure("/dev/null"), HasSubstr("not a serial port"));
}

// A terminal whose name the system knows, but without the lines of a serial port.
TEST_F(Transport, SaysThatAProgramsTerminalCannotBeOpened) {
  if (!std::filesystem::exists("/sys/class/tty/tty")) GTEST_SKIP() << "/sys is not mounted";
  int report[2];
  ASSERT_EQ(::pipe(report), 0);
  const std::string path = pty_.near();
  const pid_t child = ::fork();
  if (child == 0) {
    // The pty becomes /dev/tty of a new session.
    const bool own = ::setsid() > 0 && ::open(path.c_str(), O_RDWR) >= 0;
    const std::string message = own ? failure("/dev/tty") : "no terminal";
    ::_exit(::write(report[1], message.data(), message.size()) > 0 ? 0 : 1);
  }
  ::close(report[1]);
  char text[512];
  const ssize_t size = ::read(report[0], text, sizeof text);
  ::close(report[0]);
  ::waitpid(child, nullptr, 0);
  ASSERT_GT(size, 0);
  EXPECT_THAT(std::string(text, static_cast<std::size_t>(size)),
              HasSubstr("/dev/tty: cannot be opened"));
}

TEST_F(Transport, LeavesNoDescriptorBehind) {
  const auto count = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                         std::filesystem::directory_iterator());
  };
  const auto before = count();
  for (int i = 0; i < 200; ++i) {
    open_port(pty_.near(), {});
    failure(folder_.file("none"));
    failure("/dev/null");
  }
  EXPECT_EQ(count(), before);
}

}  // namespace
}  // namespace tp100::link
