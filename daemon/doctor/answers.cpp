#include "doctor/answers.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace tp100::doctor {

std::optional<std::string> Answers::take() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (!ended_ && ::poll(&input, 1, 0) > 0) {
    std::array<char, 256> buffer;
    const ssize_t n = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (n > 0) pending_.append(buffer.data(), static_cast<std::size_t>(n));
    if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN)) ended_ = true;
  }
  const std::size_t end = pending_.find('\n');
  if (end == std::string::npos) {
    if (ended_) pending_.clear();
    return std::nullopt;
  }
  std::string line = pending_.substr(0, end);
  pending_.erase(0, end + 1);
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

void Answers::drop_typed_ahead() {
  if (::isatty(STDIN_FILENO) == 0) return;
  ::tcflush(STDIN_FILENO, TCIFLUSH);
  pending_.clear();
}

}  // namespace tp100::doctor
