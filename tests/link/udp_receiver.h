#pragma once
// Receives a UDP stream on a free port of this machine.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace tp100 {

class UdpReceiver {
 public:
  /// Listens on `port`; 0 selects any free port.
  explicit UdpReceiver(std::uint16_t port = 0)
      : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    sockaddr generic{};
    std::memcpy(&generic, &address, sizeof generic);
    if (::bind(socket_, &generic, sizeof generic) != 0) throw std::runtime_error("bind");
    socklen_t size = sizeof generic;
    ::getsockname(socket_, &generic, &size);
    std::memcpy(&address, &generic, sizeof generic);
    port_ = ntohs(address.sin_port);
  }
  ~UdpReceiver() { ::close(socket_); }
  UdpReceiver(const UdpReceiver&) = delete;
  UdpReceiver& operator=(const UdpReceiver&) = delete;

  std::uint16_t port() const { return port_; }
  /// Returns the next datagram, or an empty string if none arrives within `patience_ms`.
  std::string wait(int patience_ms = 20'000) {
    pollfd poll{socket_, POLLIN, 0};
    if (::poll(&poll, 1, patience_ms) <= 0) return {};
    std::vector<char> buffer(65536);
    const ssize_t n = ::recv(socket_, buffer.data(), buffer.size(), 0);
    return n < 0 ? std::string() : std::string(buffer.data(), static_cast<std::size_t>(n));
  }

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

/// A port that was free at the time of the call.
inline std::uint16_t free_udp_port() { return UdpReceiver().port(); }

}  // namespace tp100
