#pragma once
// A proxy between the bridge and an external world that falsifies the world's answers.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tp100::test {

/// A UDP socket of this machine that receives from anybody.
class LocalUdp {
 public:
  LocalUdp() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in any{};
    any.sin_family = AF_INET;
    any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(socket_, generic(any), sizeof any) != 0) throw std::runtime_error("bind");
  }
  ~LocalUdp() { ::close(socket_); }
  LocalUdp(const LocalUdp&) = delete;
  LocalUdp& operator=(const LocalUdp&) = delete;

  int descriptor() const { return socket_; }
  std::uint16_t port() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(socket_, generic(own), &size);
    return ntohs(own.sin_port);
  }
  void send(const std::string& datagram, std::uint16_t to) const {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(to);
    (void)::sendto(socket_, datagram.data(), datagram.size(), 0, generic(address), sizeof address);
  }
  /// The next datagram, and the port that it came from.
  std::pair<std::string, std::uint16_t> receive() const {
    std::array<char, 4096> buffer{};
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t n = ::recvfrom(socket_, buffer.data(), buffer.size(), 0, generic(from), &size);
    return {std::string(buffer.data(), n > 0 ? static_cast<std::size_t>(n) : 0),
            ntohs(from.sin_port)};
  }

 private:
  // The socket interface uses one type for all addresses.
  static sockaddr* generic(sockaddr_in& address) {
    return static_cast<sockaddr*>(static_cast<void*>(&address));
  }
  int socket_;
};

class Liar {
 public:
  /// Returns the datagrams that the bridge gets instead of an answer to a pose, in order.
  using Lie = std::function<std::vector<std::string>(const nlohmann::json& answer)>;

  /// Falsifies answers from a second after the run's beginning to its end, and forwards all else.
  Liar(const std::string& world_address, Lie lie)
      : lie_(std::move(lie)),
        world_port_(static_cast<std::uint16_t>(
            std::stoi(world_address.substr(world_address.find(':') + 1)))) {}
  ~Liar() {
    ends_ = true;
    front_.send("", front_.port());
    thread_.join();
  }
  Liar(const Liar&) = delete;
  Liar& operator=(const Liar&) = delete;

  /// Where the bridge finds this world.
  std::string address() const { return "udp:127.0.0.1:" + std::to_string(front_.port()); }
  /// Number of falsified answers.
  int lies() const { return lies_; }
  /// Sends a datagram to the bridge from another port.
  void send_from_elsewhere(const std::string& datagram) const {
    stranger_.send(datagram, bridge_port_);
  }

 private:
  void run() {
    std::array<pollfd, 2> both = {
        {{front_.descriptor(), POLLIN, 0}, {back_.descriptor(), POLLIN, 0}}};
    while (!ends_) {
      ::poll(both.data(), both.size(), -1);
      if (both[0].revents != 0) from_bridge();
      if (both[1].revents != 0) from_world();
    }
  }
  void from_bridge() {
    const auto [datagram, port] = front_.receive();
    if (ends_) return;
    bridge_port_ = port;
    const auto pose = nlohmann::json::parse(datagram, nullptr, false);
    if (pose.is_object() && pose.contains("mode")) {
      const double now_s = pose.value("timestamp", 0.0);
      const bool running = pose["mode"] == "running";
      if (running && began_s_ < 0.0) began_s_ = now_s;
      lying_ = running && now_s - began_s_ >= 1.0;
    }
    back_.send(datagram, world_port_);
  }
  void from_world() {
    const std::string datagram = back_.receive().first;
    const auto answer = nlohmann::json::parse(datagram, nullptr, false);
    if (!lying_ || !answer.is_object() || answer.value("type", "") != "world")
      return front_.send(datagram, bridge_port_);
    ++lies_;
    for (const std::string& one : lie_(answer)) front_.send(one, bridge_port_);
  }

  Lie lie_;
  std::uint16_t world_port_;
  LocalUdp front_, back_, stranger_;
  std::atomic<std::uint16_t> bridge_port_{0};
  std::atomic<bool> ends_{false};
  std::atomic<int> lies_{0};
  double began_s_ = -1.0;
  bool lying_ = false;
  std::thread thread_{[this] { run(); }};
};

}  // namespace tp100::test
