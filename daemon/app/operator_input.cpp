#include "app/operator_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// Asio 1.74 uses std::exchange without including it.
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <utility>

namespace tp100::app {
namespace {

bool worth_reading() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) != 0) return false;
  // Reading the terminal from the background would stop the process.
  if (::isatty(STDIN_FILENO) != 0) return ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
}

}  // namespace

struct OperatorInput::State : std::enable_shared_from_this<State> {
  State(boost::asio::io_context& context, std::function<void()> action)
      : input(context), enter(std::move(action)) {}

  void read() {
    input.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                     [self = shared_from_this()](const boost::system::error_code& error) {
                       if (!error && self->input.is_open()) self->take();
                     });
  }
  void take() {
    std::array<char, 256> buffer;
    const ssize_t n = ::read(input.native_handle(), buffer.data(), buffer.size());
    if (n <= 0) return;
    for (ssize_t i = 0; i < n; ++i) {
      if (buffer[static_cast<std::size_t>(i)] == '\n') enter();
    }
    read();
  }

  boost::asio::posix::stream_descriptor input;
  std::function<void()> enter;
  int flags = -1;  // of standard input before
};

OperatorInput::OperatorInput(boost::asio::io_context& context, std::function<void()> enter)
    : state_(std::make_shared<State>(context, std::move(enter))) {
  if (!worth_reading()) return;
  state_->flags = ::fcntl(STDIN_FILENO, F_GETFL);
  const int copy = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
  boost::system::error_code error;
  state_->input.assign(copy, error);
  if (error) {
    ::close(copy);
  } else {
    state_->read();
  }
}

OperatorInput::~OperatorInput() { stop(); }

void OperatorInput::stop() {
  if (!state_->input.is_open()) return;
  boost::system::error_code ignored;
  state_->input.close(ignored);
  // Asio made it non-blocking, the copy and with it the original, which others still read.
  if (state_->flags >= 0) ::fcntl(STDIN_FILENO, F_SETFL, state_->flags);
}

bool OperatorInput::listening() const { return state_->input.is_open(); }

}  // namespace tp100::app
