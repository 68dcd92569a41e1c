#include "doctor/bootloader.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "core/clock.h"
#include "core/time.h"
#include "link/transport.h"

namespace tp100::doctor {
namespace {

constexpr int kBootloaderBaud = 115200;
constexpr HostNs kAskEveryNs = 200 * kNsPerMs;

// Start, sequence, size (high, low), token, CMD_SIGN_ON, exclusive or of all before.
constexpr std::array<std::uint8_t, 7> kSignOn = {0x1B, 0x01, 0x00, 0x01, 0x0E, 0x01, 0x14};
constexpr std::string_view kSignature = "AVRISP_2";

}  // namespace

bool bootloader_answers(const std::string& path, double limit_s) {
  const link::Port port = link::open_port(path, {.baud = kBootloaderBaud});
  const HostNs end = monotonic_now() + from_s(limit_s);
  HostNs next_ns = 0;
  std::string heard;
  for (HostNs now = monotonic_now(); now < end; now = monotonic_now()) {
    if (now >= next_ns) {
      next_ns = now + kAskEveryNs;
      if (::write(port.fd(), kSignOn.data(), kSignOn.size()) < 0) continue;
    }
    pollfd descriptor{port.fd(), POLLIN, 0};
    ::poll(&descriptor, 1, 20);
    std::array<char, 256> buffer;
    const ssize_t n = ::read(port.fd(), buffer.data(), buffer.size());
    if (n > 0) heard.append(buffer.data(), static_cast<std::size_t>(n));
    if (heard.find(kSignature) != std::string::npos) return true;
    if (n == 0) return false;
  }
  return false;
}

}  // namespace tp100::doctor
