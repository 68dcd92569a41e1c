#include "live/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

// Asio 1.74 uses std::exchange without including it.
#include <array>
#include <boost/algorithm/string/trim.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/signal_set.hpp>
#include <cerrno>
#include <csignal>
#include <functional>
#include <utility>

#include "core/clock.h"

namespace tp100::live {
namespace {

// Longest line kept; a longer one is no valid input.
constexpr std::size_t kMaxKept = 4096;

/// False: what is typed is for the shell that has sent this job to the background, or for another
/// job.
bool is_ours(int input) { return ::isatty(input) == 0 || ::tcgetpgrp(input) == ::getpgrp(); }

bool worth_reading() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) != 0) return false;
  if (::isatty(STDIN_FILENO) != 0) return is_ours(STDIN_FILENO);
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
}

}  // namespace

/// Lines typed on standard input, and signals.
class Terminal::Input {
 public:
  /// Calls `line` in the context's thread for each line on standard input, without surrounding
  /// white space. Lines that arrive together, typed ahead, come as one call. Does nothing unless
  /// standard input is our own terminal or a pipe (not a file, /dev/null or the terminal of a job
  /// that was started in the background). While a shell has this job in the background, nothing is
  /// read, and using the terminal does not stop the process.
  Input(boost::asio::io_context& context, std::function<void(const std::string& line)> line,
        std::function<void(const char* signal)> end)
      : signals_(context, SIGINT, SIGTERM), input_(context), line_(std::move(line)) {
    await_signal(std::move(end));
    // Otherwise a job in the background is stopped, and its page with it, when it uses its
    // terminal.
    std::signal(SIGTTIN, SIG_IGN);
    std::signal(SIGTTOU, SIG_IGN);
    if (!worth_reading()) return;
    flags_ = ::fcntl(STDIN_FILENO, F_GETFL);
    const int copy = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
    boost::system::error_code error;
    input_.assign(copy, error);
    if (error) {
      ::close(copy);
    } else {
      wait();
    }
  }

  /// Discards what was typed before now, including an unfinished line. True if it contained a whole
  /// line.
  bool drop_typed_ahead() {
    if (!input_.is_open()) return false;
    read();
    const bool any = pending_.find('\n') != std::string::npos;
    pending_.clear();
    // An unfinished line, which the terminal still buffers.
    const int terminal = input_.native_handle();
    if (::isatty(terminal) != 0 && is_ours(terminal)) ::tcflush(terminal, TCIFLUSH);
    return any;
  }

  /// Stops reading, and ignores signals.
  void stop() {
    boost::system::error_code ignored;
    signals_.cancel(ignored);
    if (!input_.is_open()) return;
    input_.close(ignored);
    // Asio made the copy non-blocking, and with it the original, which other processes read.
    if (flags_ >= 0) ::fcntl(STDIN_FILENO, F_SETFL, flags_);
  }

 private:
  void await_signal(std::function<void(const char* signal)> end) {
    // The terminal was closed; under nohup the signal is already ignored.
    struct sigaction hang_up {};
    if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_DFL)
      signals_.add(SIGHUP);
    signals_.async_wait([end = std::move(end)](const boost::system::error_code& error, int signal) {
      if (!error) end(signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
    });
  }

  void wait() {
    input_.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                      [this](const boost::system::error_code& error) {
                        if (!error && input_.is_open()) take();
                      });
  }

  /// Reads everything available and typed for this program. False: end of input.
  bool read() {
    std::array<char, 256> buffer;
    pollfd ready{input_.native_handle(), POLLIN, 0};
    while (is_ours(ready.fd) && ::poll(&ready, 1, 0) > 0) {
      const ssize_t n = ::read(ready.fd, buffer.data(), buffer.size());
      // EIO: the shell has just sent this job to the background.
      if (n <= 0) return n < 0 && (errno == EAGAIN || errno == EINTR || errno == EIO);
      if (pending_.size() > kMaxKept) pending_ = "...";
      pending_.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return true;
  }

  void take() {
    const bool more = read();
    const std::size_t end = pending_.rfind('\n');
    if (end != std::string::npos) {
      const std::string lines = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      // Several lines are never an answer: trimmed, two Enters would look like one.
      line_(lines.find('\n') == std::string::npos ? boost::algorithm::trim_copy(lines) : lines);
    }
    if (more && input_.is_open()) wait();
  }

  boost::asio::signal_set signals_;
  boost::asio::posix::stream_descriptor input_;
  const std::function<void(const std::string&)> line_;
  std::string pending_;
  int flags_ = -1;  // of standard input, before
};

Terminal::Terminal(boost::asio::io_context* context, Reach reach,
                   std::function<void(const char* signal)> end)
    : reach_(std::move(reach)) {
  if (context == nullptr) return;
  input_ = std::make_unique<Input>(
      *context, [this](const std::string& line) { take(line, monotonic_now()); }, std::move(end));
}

Terminal::~Terminal() { stop(); }
void Terminal::stop() {
  if (input_) input_->stop();
}

void Terminal::ask(HostNs now) {
  if (session_ != SessionState::kReady || under_way() || reach_.course().empty()) return;
  const bool word = reach_.controls.start_consent() == StartConsent::kWord;
  const bool typed_ahead = input_ && input_->drop_typed_ahead();
  seen_ns_ = now;
  stops_seen_ = reach_.controls.stop_count();
  const std::string what = "to start course " + reach_.course();
  const bool asks = reach_.controls.start_places().asks();
  reach_.say(asks ? "ready; type " + std::string(kStartPlacedWords) + " and press Enter " + what +
                        " once the robot is put back at its start, or " +
                        std::string(kStartHereWords) +
                        " to continue from the pose that is shown; Enter alone is STOP"
             : word ? "ready; type go and press Enter " + what + "; Enter alone is STOP"
                    : "ready; press Enter " + what,
             false);
  if (typed_ahead && word) press_stop("Enter was pressed before the question: STOP", now);
}

void Terminal::take(const std::string& line, HostNs now) {
  const bool can_start = !reach_.course().empty();
  const LineMeaning meaning = meaning_of(line, reach_.controls.start_consent(), under_way());
  if (meaning == LineMeaning::kStop) {
    press_stop(under_way() || !can_start ? "Enter: STOP"
                                         : "Enter: STOP; to start again type go and press Enter",
               now);
  } else if (!can_start) {
    reach_.say("there is no course; nothing is started", false);
  } else if (meaning == LineMeaning::kNothing) {
    reach_.say("nothing is started; press Enter alone to start course " + reach_.course(), false);
  } else if (session_ != SessionState::kReady) {
    reach_.say("no robot is connected yet; nothing is started", false);
  } else {
    start(meaning, line.empty(), now);
  }
}

void Terminal::start(LineMeaning meaning, bool first_only, HostNs now) {
  const auto what = meaning == LineMeaning::kStartPlaced ? OperatorRequest::kStartPlaced
                    : meaning == LineMeaning::kStartHere ? OperatorRequest::kContinue
                                                         : OperatorRequest::kStart;
  const Result<> started = reach_.controls.move(what,
                                                {.by = {Door::kTerminal},
                                                 .acted_ns = now,
                                                 .seen_ns = seen_ns_,
                                                 .stops_seen = stops_seen_,
                                                 .first_only = first_only},
                                                now);
  if (started) return;
  reach_.say("nothing is started: " + started.why(), true);
  ask(now);
}

void Terminal::press_stop(const std::string& message, HostNs now) {
  reach_.controls.stop();
  reach_.stop_pressed();
  reach_.say(message, true);
  stops_seen_ = reach_.controls.stop_count();
  seen_ns_ = now;
}

}  // namespace tp100::live
