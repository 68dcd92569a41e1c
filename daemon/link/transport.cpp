#include "link/transport.h"

#include <fcntl.h>
#include <grp.h>
#include <libserialport.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "core/descriptor.h"
#include "core/error.h"
#include "link/port_holder.h"

namespace tp100::link {
namespace {

namespace fs = std::filesystem;

// UNIX98_PTY_SLAVE_MAJOR of the kernel, and the number of its majors.
constexpr unsigned kFirstPtyMajor = 136;
constexpr unsigned kPtyMajors = 8;

std::string resolved(const std::string& path) {
  char real[PATH_MAX];
  return ::realpath(path.c_str(), real) == nullptr ? path : std::string(real);
}

/// What lets this account use the port: its group, unless that may not, or is root's.
std::string way_to_permission(const std::string& path) {
  struct stat status {};
  const bool known = ::stat(path.c_str(), &status) == 0;
  const group* entry = known ? ::getgrgid(status.st_gid) : nullptr;
  const std::string name = !known             ? "dialout"
                           : entry == nullptr ? std::to_string(status.st_gid)
                                              : entry->gr_name;
  constexpr mode_t kUse = S_IRGRP | S_IWGRP;
  if (known && (name == "root" || (status.st_mode & kUse) != kUse))
    return "its group " + name +
           " is not meant for users; unplug the robot and plug it in again, " +
           "or run `sudo chgrp dialout " + path + " && sudo chmod 660 " + path + "`";
  return "run `sudo adduser $USER " + name + "` and log in again";
}

[[noreturn]] void fail_busy(const std::string& path) {
  const PortHolder holder = port_holder(resolved(path));
  if (holder.name.empty() && holder.others_hidden)
    throw UserError(path +
                    ": port is busy, held by a program of another account or container; end it (a "
                    "service with `sudo systemctl stop 'tp100d@*'`; `sudo tp100d doctor` names "
                    "it) or choose another port with --port");
  throw UserError(path + ": port is busy" +
                  (holder.name.empty() ? "" : ", held by " + holder.name) +
                  "; end that program or choose another port with --port");
}

[[noreturn]] void fail_open(const std::string& path, int error) {
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      throw UserError(path + ": no such port; plug the robot in, or see `tp100d ports`");
    case EACCES:
    case EPERM:
      throw UserError(path + ": no permission; " + way_to_permission(path) +
                      "; `tp100d doctor` says why");
    case EBUSY:
      fail_busy(path);
    default:
      throw UserError(path + ": cannot be opened (" + std::strerror(error) +
                      "); see `tp100d ports`");
  }
}

/// The standard speed of that baud rate; B0: there is none.
speed_t standard_speed(int baud) {
  static constexpr std::pair<int, speed_t> kSpeeds[] = {
      {9600, B9600},     {19200, B19200},     {38400, B38400},    {57600, B57600},
      {115200, B115200}, {230400, B230400},   {460800, B460800},  {500000, B500000},
      {921600, B921600}, {1000000, B1000000}, {2000000, B2000000}};
  for (const auto& [rate, speed] : kSpeeds)
    if (rate == baud) return speed;
  return B0;
}

int open_raw(const std::string& real, int& error) {
  const int fd = ::open(real.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  error = errno;
  return fd;
}

/// True if the library can open it: it needs a name in /dev that /sys has too, unlike a node of
/// another name as in a container.
bool known_by_name(const fs::path& real) {
  std::error_code error;
  return real.parent_path() == "/dev" && fs::exists("/sys/class/tty" / real.filename(), error);
}

/// `speed`: B0 leaves the current speed.
void set_raw(int fd, const std::string& path, speed_t speed, const PortOptions& options) {
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) {
    throw UserError(path + ": is not a serial port; see `tp100d ports`");
  }
  ::cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  settings.c_cflag |= CLOCAL | CREAD;
  if (options.hang_up) {
    settings.c_cflag |= HUPCL;
  } else {
    settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  }
  if (speed != B0) ::cfsetspeed(&settings, speed);
  // With 0 an empty read returns 0, which looks like the end of the file.
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (::tcsetattr(fd, TCSANOW, &settings) != 0) {
    throw UserError(path + ": cannot be configured (" + std::strerror(errno) +
                    "); unplug the port and plug it in again");
  }
}

void ask_low_latency(int fd) {
  serial_struct serial{};
  if (::ioctl(fd, TIOCGSERIAL, &serial) != 0) return;
  serial.flags |= static_cast<int>(ASYNC_LOW_LATENCY);
  ::ioctl(fd, TIOCSSERIAL, &serial);
}

/// Opens and configures `real_path` (8N1, no flow control) by libserialport, which supports any
/// baud rate. Returns a close-on-exec descriptor, or -1 with `error` set to an errno value.
int open_serial_port(const std::string& real_path, int baud, int& error) {
  sp_port* raw = nullptr;
  if (sp_get_port_by_name(real_path.c_str(), &raw) != SP_OK) {
    error = ENOENT;
    return -1;
  }
  const std::unique_ptr<sp_port, decltype(&sp_free_port)> port(raw, &sp_free_port);
  if (sp_open(port.get(), SP_MODE_READ_WRITE) != SP_OK) {
    error = sp_last_error_code();
    return -1;
  }
  int fd = -1;
  if (sp_set_baudrate(port.get(), baud) != SP_OK || sp_set_bits(port.get(), 8) != SP_OK ||
      sp_set_parity(port.get(), SP_PARITY_NONE) != SP_OK ||
      sp_set_stopbits(port.get(), 1) != SP_OK ||
      sp_set_flowcontrol(port.get(), SP_FLOWCONTROL_NONE) != SP_OK ||
      sp_get_port_handle(port.get(), &fd) != SP_OK) {
    error = sp_last_error_code();
    sp_close(port.get());
    return -1;
  }
  // The library closes its own descriptor; the duplicate keeps DTR up.
  const int own = ::fcntl(fd, F_DUPFD_CLOEXEC, 3);
  error = errno;
  sp_close(port.get());
  return own;
}

}  // namespace

Port::Port(Port&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      path_(std::move(other.path_)),
      pseudo_terminal_(other.pseudo_terminal_) {}

Port& Port::operator=(Port&& other) noexcept {
  if (this != &other) {
    close();
    fd_ = std::exchange(other.fd_, -1);
    path_ = std::move(other.path_);
    pseudo_terminal_ = other.pseudo_terminal_;
  }
  return *this;
}

Port::~Port() { close(); }

void Port::close() {
  if (fd_ < 0) return;
  ::tcflush(fd_, TCOFLUSH);
  ::ioctl(fd_, TIOCNXCL);
  ::close(std::exchange(fd_, -1));
}

bool is_pseudo_terminal(mode_t mode, dev_t number) {
  return S_ISCHR(mode) && ::major(number) >= kFirstPtyMajor &&
         ::major(number) < kFirstPtyMajor + kPtyMajors;
}

Port open_port(const std::string& path, const PortOptions& options) {
  const std::string real = resolved(path);
  // A named pipe or a disk file must not be opened.
  struct stat status {};
  if (::stat(real.c_str(), &status) != 0) fail_open(path, errno);
  if (!S_ISCHR(status.st_mode)) {
    throw UserError(path + ": is not a serial port; see `tp100d ports`");
  }
  int error = 0;
  // A process that may open the port in spite of TIOCEXCL (root) must not change the settings of
  // its holder: the lock is taken before libserialport configures the port. It is closed last, so
  // that DTR stays up.
  const Descriptor first(open_raw(real, error));
  if (!first) fail_open(path, error);
  if (::flock(first.get(), LOCK_EX | LOCK_NB) != 0) fail_busy(path);
  ::flock(first.get(), LOCK_UN);
  const bool by_library = known_by_name(real);
  const int fd = by_library ? open_serial_port(real, options.baud, error) : open_raw(real, error);
  if (fd < 0) fail_open(path, error);
  Descriptor owner(fd);
  if (::fstat(fd, &status) != 0) fail_open(path, errno);
  const bool pseudo_terminal = is_pseudo_terminal(status.st_mode, status.st_rdev);
  if (::isatty(fd) == 0) throw UserError(path + ": is not a serial port; see `tp100d ports`");
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) fail_busy(path);
  ::ioctl(fd, TIOCEXCL);
  const speed_t speed = by_library ? B0 : standard_speed(options.baud);
  // A pty moves bytes at once whatever its speed is; an emulator may read that speed.
  if (speed == B0 && !by_library && !pseudo_terminal)
    throw UserError(path + ": cannot be set to " + std::to_string(options.baud) +
                    " baud under this name; use the name that `tp100d ports` prints");
  set_raw(fd, path, speed, options);
  if (!pseudo_terminal) ask_low_latency(fd);
  ::tcflush(fd, TCIFLUSH);
  return {owner.release(), path, pseudo_terminal};
}

}  // namespace tp100::link
