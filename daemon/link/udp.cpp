#include "link/udp.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "text/format.h"

namespace tp100::link {
namespace {

constexpr std::size_t kMaxHost = 253;

}  // namespace

UdpAddress parse_udp(std::string_view text, const std::string& where) {
  constexpr std::string_view kScheme = "udp:";
  const auto wrong = [&] {
    return UserError(where + " " + one_line(text, 100) +
                     ": not an address; use udp:PORT or udp:HOST:PORT, as in udp:47100");
  };
  if (!text.starts_with(kScheme)) throw wrong();
  std::string_view rest = text.substr(kScheme.size());
  UdpAddress address;
  if (const std::size_t colon = rest.rfind(':'); colon != std::string_view::npos) {
    const std::string_view host = rest.substr(0, colon);
    const bool plain = host.find_first_of(" :\t/") == std::string_view::npos;
    if (host.empty() || host.size() > kMaxHost || !plain) throw wrong();
    address.host = host;
    rest.remove_prefix(colon + 1);
  }
  address.port = tp100::text::number_in<std::uint16_t>(rest).value_or(0);
  if (address.port == 0) throw wrong();
  return address;
}

std::string to_string(const UdpAddress& address) {
  return address.host + ":" + std::to_string(address.port);
}

sockaddr_in resolve(const UdpAddress& address) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(address.host.c_str(), nullptr, &hints, &found);
  if (error != 0 || found == nullptr) {
    throw UserError("udp:" + one_line(to_string(address), 100) + ": no such host (" +
                    ::gai_strerror(error) + "); use its IPv4 address");
  }
  sockaddr_in out{};
  std::memcpy(&out, found->ai_addr, sizeof out);
  ::freeaddrinfo(found);
  out.sin_port = htons(address.port);
  return out;
}

UdpSender::UdpSender(const UdpAddress& to)
    : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const sockaddr_in address = resolve(to);
  sockaddr generic{};
  static_assert(sizeof generic == sizeof address);
  std::memcpy(&generic, &address, sizeof generic);
  if (!socket_ || ::connect(socket_.get(), &generic, sizeof generic) != 0)
    throw UserError("udp:" + to_string(to) + ": cannot send there (" + std::strerror(errno) +
                    "); choose another address");
}

bool UdpSender::send(std::string_view datagram) {
  // ECONNREFUSED belongs to the previous datagram; the second attempt sends this one.
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (::send(socket_.get(), datagram.data(), datagram.size(), MSG_NOSIGNAL) >= 0) return true;
    if (errno != ECONNREFUSED && errno != EINTR) return false;
  }
  return false;
}

std::string monotonic_clock_name() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  if (file >> id && id.size() <= 64) return id;
  return "unknown-clock-" + std::to_string(::getpid());
}

}  // namespace tp100::link
