#include "sim/robot/world_client.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "link/udp.h"

namespace tp100::sim {
namespace {

using namespace std::chrono_literals;

constexpr auto kTimeout = 5s;
constexpr auto kGreetEvery = 250ms;

// The socket interface uses one type for all addresses.
sockaddr* generic(sockaddr_in* address) {
  return static_cast<sockaddr*>(static_cast<void*>(address));
}

}  // namespace

WorldClient::WorldClient(const config::WorldRun& run, std::uint32_t session)
    : peer_(config::peer_settings(run, session, true)),
      world_(link::resolve(link::parse_udp(run.settings.address, "world"))),
      socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  if (!socket_) throw UserError(std::string("world: no socket (") + std::strerror(errno) + ")");
  if (!run.settings.listen.empty()) {
    sockaddr_in local = link::resolve(link::parse_udp(run.settings.listen, "world.listen"));
    if (::bind(socket_.get(), generic(&local), sizeof local) != 0)
      throw UserError("world: cannot listen at " + run.settings.listen + " (" +
                      std::strerror(errno) + "); choose another world.listen");
  }
  greet();
}

void WorldClient::greet() {
  const auto record = std::make_unique<StepRecord>();
  const auto nothing = [](const WorldSample&) {};
  const int rounds = kTimeout / kGreetEvery;
  // Negative times: virtual time has not begun.
  for (int i = -rounds; i < 0 && !peer_.welcomed(); ++i) {
    const HostNs now = i * (std::chrono::nanoseconds(kGreetEvery).count() + 1);
    if (const auto hello = peer_.step(*record, now)) send(*hello);
    const auto deadline = Clock::now() + kGreetEvery;
    while (!peer_.welcomed() && receive(-1, deadline, nothing)) {
    }
  }
  if (peer_.welcomed()) return;
  const std::string why = peer_.take_note();
  throw UserError("world: " + (why.empty() ? "no welcome within 5 s; start it, for example "
                                             "scripts/world, or check --world"
                                           : why));
}

void WorldClient::send(const std::string& datagram) {
  // Errors are ignored: a missing receiver is noticed by its silence.
  (void)::sendto(socket_.get(), datagram.data(), datagram.size(), MSG_NOSIGNAL, generic(&world_),
                 sizeof world_);
}

bool WorldClient::receive(HostNs now, Clock::time_point deadline, const Take& take) {
  while (true) {
    sockaddr_in sender{};
    socklen_t length = sizeof sender;
    const ssize_t n =
        ::recvfrom(socket_.get(), buffer_.data(), buffer_.size(), 0, generic(&sender), &length);
    if (n >= 0) {
      if (sender.sin_addr.s_addr != world_.sin_addr.s_addr) continue;
      const auto sample =
          peer_.receive({buffer_.data(), static_cast<std::size_t>(n)}, ntohs(sender.sin_port), now);
      if (sample) take(*sample);
      if (const auto reply = peer_.take_reply()) send(*reply);
      return true;
    }
    if (errno != EAGAIN && errno != EINTR) return false;
    const auto left = deadline - Clock::now();
    if (left.count() <= 0) return false;
    pollfd waiting{socket_.get(), POLLIN, 0};
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();
    ::poll(&waiting, 1, static_cast<int>(ms) + 1);
  }
}

void WorldClient::exchange(const StepRecord& record, HostNs now, const Take& take) {
  const auto datagram = peer_.step(record, now);
  if (!datagram) return;
  send(*datagram);
  if (!waits_ || !peer_.welcomed()) return;
  const auto deadline = Clock::now() + kTimeout;
  while (peer_.answered() != peer_.sent()) {
    if (receive(now, deadline, take)) continue;
    waits_ = false;
    return;
  }
}

}  // namespace tp100::sim
