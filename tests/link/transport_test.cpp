// How a port is opened, and what the user is told if that is not possible.
#include "link/transport.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "../support/as_nobody.h"
#include "../support/temporary_folder.h"
#include "core/error.h"
#include "link/port_holder.h"
#include "pty_pair.h"
#include "support/container_terminal.h"
#include "support/refusal.h"

namespace tp100::link {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string failure(const std::string& path) {
  return test::refusal([&] { open_port(path, {}); });
}

class Transport : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  PtyPair pty_;
};

TEST_F(Transport, SetsTheSpeedThatIsAskedForOrLeavesIt) {
  const std::pair<int, speed_t> speeds[] = {
      {9600, B9600},     {19200, B19200},     {38400, B38400},     {57600, B57600},
      {115200, B115200}, {230400, B230400},   {460800, B460800},   {500000, B500000},
      {921600, B921600}, {1000000, B1000000}, {2000000, B2000000}, {123457, B2000000}};
  for (const auto& [baud, speed] : speeds) {
    PortOptions options;
    options.baud = baud;
    const Port port = open_port(pty_.near(), options);
    termios settings{};
    ASSERT_EQ(::tcgetattr(port.fd(), &settings), 0);
    EXPECT_EQ(::cfgetospeed(&settings), speed) << baud;
    EXPECT_EQ(::cfgetispeed(&settings), speed) << baud;
  }
}

TEST_F(Transport, SetsEightBitsOneStopBitAndNoFlowControlWhateverWasSet) {
  for (const bool hang_up : {false, true}) {
    termios before{};
    const int fd = ::open(pty_.near().c_str(), O_RDWR | O_NOCTTY);
    ASSERT_EQ(::tcgetattr(fd, &before), 0);
    before.c_cflag |= CSTOPB | CRTSCTS | PARENB;
    before.c_cflag &= ~static_cast<tcflag_t>(CLOCAL | CREAD);
    before.c_cflag ^= hang_up ? 0U : tcflag_t{HUPCL};
    before.c_iflag |= IXON | ICRNL;
    before.c_lflag |= ICANON | ECHO;
    ::cfsetspeed(&before, B9600);
    before.c_cc[VMIN] = 0;
    before.c_cc[VTIME] = 7;
    ASSERT_EQ(::tcsetattr(fd, TCSANOW, &before), 0);
    ::close(fd);
    const Port port = open_port(pty_.near(), {.hang_up = hang_up});
    termios after{};
    ASSERT_EQ(::tcgetattr(port.fd(), &after), 0);
    EXPECT_EQ(after.c_cflag & (CSTOPB | CRTSCTS | PARENB), 0U);
    EXPECT_EQ(after.c_cflag & (CLOCAL | CREAD), tcflag_t{CLOCAL | CREAD});
    EXPECT_EQ(after.c_cflag & CSIZE, tcflag_t{CS8});
    EXPECT_EQ((after.c_cflag & HUPCL) != 0, hang_up);
    EXPECT_EQ(::cfgetospeed(&after), speed_t{B500000});
    EXPECT_EQ(after.c_iflag & (IXON | ICRNL), 0U);
    EXPECT_EQ(after.c_lflag & (ICANON | ECHO), 0U);
    EXPECT_EQ(after.c_oflag & OPOST, 0U);
    EXPECT_EQ(after.c_cc[VMIN], 1);
    EXPECT_EQ(after.c_cc[VTIME], 0);
  }
}

TEST_F(Transport, BytesFromBeforeTheOpeningAreDroppedAndAllOthersPass) {
  const std::vector<std::uint8_t> old{1, 2, 3};
  pty_.write(old);
  const std::string link = folder_.file("robot");
  std::filesystem::create_symlink(pty_.near(), link);
  const Port port = open_port(link, {});
  EXPECT_TRUE(port.pseudo_terminal());
  EXPECT_TRUE(::fcntl(port.fd(), F_GETFD) & FD_CLOEXEC);
  std::uint8_t bytes[8];
  EXPECT_EQ(::read(port.fd(), bytes, sizeof bytes), -1);
  EXPECT_EQ(errno, EAGAIN) << "it never waits";
  // From then on each byte passes as it is, both ways.
  std::vector<std::uint8_t> all(256), got;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  pty_.write(all);
  pollfd wait{port.fd(), POLLIN, 0};
  while (got.size() < all.size() && ::poll(&wait, 1, 5000) == 1) {
    const ssize_t n = ::read(port.fd(), bytes, sizeof bytes);
    ASSERT_GT(n, 0);
    got.insert(got.end(), bytes, bytes + n);
  }
  EXPECT_EQ(got, all);
  ASSERT_EQ(::write(port.fd(), all.data(), all.size()), static_cast<ssize_t>(all.size()));
  EXPECT_TRUE(pty_.wait(1000));
  EXPECT_EQ(pty_.read(), all);
}

// A descriptor that is closed twice may be another program's connection by then.
TEST_F(Transport, APortMovesWithItsDescriptorAndClosesOnce) {
  const auto is_valid = [](int fd) { return ::fcntl(fd, F_GETFD) >= 0; };
  PtyPair other;
  Port port = open_port(pty_.near(), {});
  const int fd = port.fd();
  Port moved(std::move(port));
  EXPECT_FALSE(port.is_open());
  Port target = open_port(other.near(), {});
  const int replaced = target.fd();
  target = std::move(moved);
  EXPECT_FALSE(is_valid(replaced));
  Port& same = target;
  target = std::move(same);
  EXPECT_EQ(target.fd(), fd);
  EXPECT_EQ(target.path(), pty_.near());
  EXPECT_TRUE(target.pseudo_terminal());
  target.close();
  EXPECT_FALSE(is_valid(fd));
  const int again = ::fcntl(STDIN_FILENO, F_DUPFD, fd);
  ASSERT_EQ(again, fd);
  target = Port();
  EXPECT_TRUE(is_valid(fd)) << "it is no longer the port's";
  ::close(again);
}

TEST(PseudoTerminal, IsKnownByItsNumberOnly) {
  for (const unsigned number : {136U, 140U, 143U})
    EXPECT_TRUE(is_pseudo_terminal(S_IFCHR, ::makedev(number, 3)));
  // Major numbers of the Mega's driver, of bridge drivers, of 16550s, of a pty's master and of old
  // ptys.
  for (const unsigned number : {166U, 188U, 4U, 5U, 3U, 128U, 135U, 144U})
    EXPECT_FALSE(is_pseudo_terminal(S_IFCHR, ::makedev(number, 3)));
  EXPECT_FALSE(is_pseudo_terminal(S_IFREG, ::makedev(136, 3)));
}

TEST_F(Transport, SaysThatAPortIsMissing) {
  const std::string message = failure(folder_.file("none"));
  EXPECT_THAT(message, HasSubstr("none: no such port"));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  std::filesystem::create_symlink(folder_.path() / "nowhere", folder_.path() / "dangling");
  EXPECT_THAT(failure(folder_.file("dangling")), HasSubstr("no such port"));
}

TEST_F(Transport, SaysWhoMayOpenAPort) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become nobody; run it as root";
  const std::string port = pty_.near();
  const auto refusal = [&](const char* group, mode_t mode) {
    EXPECT_EQ(::chown(port.c_str(), 0, ::getgrnam(group)->gr_gid), 0);
    EXPECT_EQ(::chmod(port.c_str(), mode), 0);
    const test::AsNobody nobody;
    return failure(port);
  };
  EXPECT_THAT(refusal("dialout", 0660),
              HasSubstr("no permission; run `sudo adduser $USER dialout`"));
  // A group that may not use it, or that gives more than the port, is of no help.
  for (const auto& [group, mode] : {std::pair("dialout", 0600),
                                    {"dialout", 0640},
                                    {"tty", 0620},
                                    {"root", 0600},
                                    {"root", 0660}})
    EXPECT_THAT(refusal(group, static_cast<mode_t>(mode)),
                AllOf(HasSubstr("its group " + std::string(group) + " is not meant for users"),
                      Not(HasSubstr("adduser"))))
        << group << mode;
}

TEST_F(Transport, SaysThatAPortThatItCannotSeeInUseIsBusy) {
  const int holder = ::open(pty_.near().c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(::flock(holder, LOCK_EX | LOCK_NB), 0);
  // This process itself is not named.
  const bool hidden = port_holder("/dev/null").others_hidden;
  EXPECT_THAT(failure(pty_.near()),
              HasSubstr(hidden ? ": port is busy, held by a program of another account or container"
                               : ": port is busy; end that program or choose another port"));
  ::close(holder);
  {
    const Port first = open_port(pty_.near(), {});
    EXPECT_THAT(failure(pty_.near()), HasSubstr("port is busy"));
  }
  EXPECT_TRUE(open_port(pty_.near(), {}).is_open());
}

TEST_F(Transport, NoOtherAccountOpensAPortThatIsOpen) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become nobody; run it as root";
  ASSERT_EQ(::chmod(pty_.near().c_str(), 0666), 0);
  const auto as_nobody = [&] {
    const test::AsNobody nobody;
    const int fd = ::open(pty_.near().c_str(), O_RDWR | O_NOCTTY);
    const int error = fd < 0 ? errno : 0;
    if (fd >= 0) ::close(fd);
    return error;
  };
  EXPECT_EQ(as_nobody(), 0);
  Port port = open_port(pty_.near(), {});
  EXPECT_EQ(as_nobody(), EBUSY);
  port.close();
  EXPECT_EQ(as_nobody(), 0);
}

TEST_F(Transport, NamesTheProgramThatHoldsAPort) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::flock(::open(pty_.near().c_str(), O_RDWR | O_NOCTTY), LOCK_EX | LOCK_NB);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  char byte = 0;
  EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  const std::string message = failure(pty_.near());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  for (const int fd : ready) ::close(fd);
  EXPECT_THAT(message, ::testing::ContainsRegex("port is busy, held by .*pid"));
}

TEST_F(Transport, NamesNoProgramThatHoldsATerminalOfTheSameNameInAContainer) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root makes a terminal of a container; run it as root";
  const test::ContainerTerminal other(pty_.near());
  ASSERT_TRUE(other.is_held());
  EXPECT_EQ(port_holder(pty_.near()).name, "");
}

TEST_F(Transport, RefusesWhatIsNoSerialPort) {
  std::ofstream(folder_.path() / "file") << "x";
  EXPECT_THAT(failure(folder_.file("file")), HasSubstr("not a serial port"));
  EXPECT_THAT(failure(folder_.path().string()), HasSubstr("not a serial port"));
  EXPECT_THAT(failure("/dev/null"), HasSubstr("not a serial port"));
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
