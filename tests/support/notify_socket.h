#pragma once
// The service manager's end of $NOTIFY_SOCKET.

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
  /// `name` is a path, or @name for an abstract socket.
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

  /// Messages received since the last call.
  std::vector<std::string> received() const {
    std::vector<std::string> out;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::recv(socket_, buffer.data(), buffer.size(), 0)) >= 0;)
      out.emplace_back(buffer.data(), static_cast<std::size_t>(n));
    return out;
  }
  /// True if `text` arrives within `patience`; other messages are discarded.
  bool hears(const std::string& text, std::chrono::milliseconds patience) const {
    const auto until = std::chrono::steady_clock::now() + patience;
    do {
      const std::vector<std::string> all = received();
      if (std::find(all.begin(), all.end(), text) != all.end()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (std::chrono::steady_clock::now() < until);
    return false;
  }

 private:
  int socket_;
};

}  // namespace tp100::test
