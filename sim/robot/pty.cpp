#include "sim/robot/pty.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "core/error.h"

namespace tp100::sim {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

[[noreturn]] void fail(const std::string& what) {
  throw UserError(what + ": " + std::strerror(errno));
}

/// True if no process serves `link` any more. If a robot was killed, its client keeps the old
/// device alive for a moment, until it notices.
bool dangling(const std::string& device, const std::string& link) {
  std::error_code error;
  for (int i = 0; i < 20; ++i) {
    // A newly created pty cannot belong to another process, even under a number used before.
    if (fs::read_symlink(link, error) == device || !fs::exists(link, error)) return true;
    std::this_thread::sleep_for(50ms);
  }
  return false;
}

void make_link(const std::string& device, const std::string& link) {
  std::error_code error;
  const fs::file_status own = fs::symlink_status(link, error);
  if (fs::is_symlink(own) && dangling(device, link)) {
    fs::remove(link, error);
  } else if (fs::exists(own)) {
    throw UserError(link + ": exists already; give another --link or remove it");
  }
  fs::create_symlink(device, link, error);
  if (error)
    throw UserError(link + ": cannot create the link (" + error.message() +
                    "); give another --link");
}

}  // namespace

Pty::Pty(const std::string& link) {
  master_ = Descriptor(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!master_) fail("cannot create a pseudo-terminal");
  std::array<char, 128> name{};
  if (grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0 ||
      ptsname_r(master_.get(), name.data(), name.size()) != 0) {
    fail("cannot set up the pseudo-terminal");
  }
  device_ = name.data();
  // Opened and closed once, because only then the master reports that no client is connected.
  const int slave = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave < 0) fail(device_);
  termios settings{};
  if (tcgetattr(slave, &settings) == 0) {
    cfmakeraw(&settings);
    tcsetattr(slave, TCSANOW, &settings);
  }
  ::close(slave);
  if (!link.empty()) {
    make_link(device_, link);
    link_ = link;
  }
}

Pty::~Pty() {
  std::error_code error;
  if (!link_.empty() && fs::read_symlink(link_, error) == device_) fs::remove(link_, error);
}

bool Pty::open() {
  pollfd descriptor{master_.get(), 0, 0};
  return poll(&descriptor, 1, 0) == 0 || (descriptor.revents & POLLHUP) == 0;
}

std::size_t Pty::read(std::span<std::uint8_t> buffer) {
  const ssize_t n = ::read(master_.get(), buffer.data(), buffer.size());
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

std::size_t Pty::write(std::span<const std::uint8_t> bytes) {
  const ssize_t n = ::write(master_.get(), bytes.data(), bytes.size());
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

void Pty::flush() { tcflush(master_.get(), TCIOFLUSH); }

}  // namespace tp100::sim
