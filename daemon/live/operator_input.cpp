#include "live/operator_input.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

// Asio 1.74 uses std::exchange without including it.
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <cerrno>
#include <utility>

namespace tp100::live {
namespace {

// Of a line; a longer one is no answer to anything.
constexpr std::size_t kMostKept = 4096;

bool worth_reading() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) != 0) return false;
  // Reading the terminal from the background would stop the process.
  if (::isatty(STDIN_FILENO) != 0) return ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
}

std::string trimmed(const std::string& text) {
  constexpr const char* kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

}  // namespace

struct OperatorInput::State : std::enable_shared_from_this<State> {
  State(boost::asio::io_context& context, std::function<void(const std::string&)> action)
      : input(context), line(std::move(action)) {}

  void wait() {
    input.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                     [self = shared_from_this()](const boost::system::error_code& error) {
                       if (!error && self->input.is_open()) self->take();
                     });
  }
  /// Reads all that is there. False: there will never be more.
  bool read() {
    std::array<char, 256> buffer;
    pollfd ready{input.native_handle(), POLLIN, 0};
    while (::poll(&ready, 1, 0) > 0) {
      const ssize_t n = ::read(ready.fd, buffer.data(), buffer.size());
      if (n <= 0) return n < 0 && (errno == EAGAIN || errno == EINTR);
      if (pending.size() > kMostKept) pending = "...";
      pending.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return true;
  }
  void take() {
    const bool more = read();
    const std::size_t end = pending.rfind('\n');
    if (end != std::string::npos) {
      const std::string lines = pending.substr(0, end);
      pending.erase(0, end + 1);
      // Several are never taken for an answer: trimmed, two Enters would look like one.
      line(lines.find('\n') == std::string::npos ? trimmed(lines) : lines);
    }
    if (more && input.is_open()) wait();
  }
  bool drop() {
    if (!input.is_open()) return false;
    read();
    const bool any = pending.find('\n') != std::string::npos;
    pending.clear();
    // The beginning of a line, which a terminal keeps to itself.
    if (::isatty(input.native_handle()) != 0) ::tcflush(input.native_handle(), TCIFLUSH);
    return any;
  }

  boost::asio::posix::stream_descriptor input;
  std::function<void(const std::string&)> line;
  std::string pending;
  int flags = -1;  // of standard input before
};

OperatorInput::OperatorInput(boost::asio::io_context& context,
                             std::function<void(const std::string&)> line)
    : state_(std::make_shared<State>(context, std::move(line))) {
  if (!worth_reading()) return;
  state_->flags = ::fcntl(STDIN_FILENO, F_GETFL);
  const int copy = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
  boost::system::error_code error;
  state_->input.assign(copy, error);
  if (error) {
    ::close(copy);
  } else {
    state_->wait();
  }
}

OperatorInput::~OperatorInput() { stop(); }

bool OperatorInput::drop_typed_ahead() { return state_->drop(); }

void OperatorInput::stop() {
  if (!state_->input.is_open()) return;
  boost::system::error_code ignored;
  state_->input.close(ignored);
  // Asio made it non-blocking, the copy and with it the original, which others still read.
  if (state_->flags >= 0) ::fcntl(STDIN_FILENO, F_SETFL, state_->flags);
}

bool OperatorInput::listening() const { return state_->input.is_open(); }

}  // namespace tp100::live
