#pragma once
// A service manager's end of $NOTIFY_SOCKET.

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

namespace tp100::test {

class NotifySocket {
 public:
  /// `name`: a path, or @name of an abstract socket.
  explicit NotifySocket(const std::string& name)
      : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(name.begin(), name.end(), address.sun_path);
    if (name.front() == '@') address.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0) << name;
  }
  ~NotifySocket() { ::close(socket_); }
  NotifySocket(const NotifySocket&) = delete;
  NotifySocket& operator=(const NotifySocket&) = delete;

  /// What came since the last call.
  std::vector<std::string> heard() const {
    std::vector<std::string> out;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::recv(socket_, buffer.data(), buffer.size(), 0)) >= 0;)
      out.emplace_back(buffer.data(), static_cast<std::size_t>(n));
    return out;
  }
  /// Whether `text` comes within `patience`; what comes besides is lost.
  bool hears(const std::string& text, std::chrono::milliseconds patience) const {
    const auto until = std::chrono::steady_clock::now() + patience;
    do {
      const std::vector<std::string> all = heard();
      if (std::find(all.begin(), all.end(), text) != all.end()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (std::chrono::steady_clock::now() < until);
    return false;
  }

 private:
  int socket_;
};

}  // namespace tp100::test
