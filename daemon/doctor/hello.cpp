#include "doctor/hello.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>

#include "core/board.h"
#include "core/clock.h"
#include "core/faults.h"
#include "core/time.h"
#include "link/session.h"
#include "link/transport.h"
#include "text/format.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::doctor {

namespace {

using Clock = std::chrono::steady_clock;

/// The first hello before `deadline`.
std::optional<wire::Hello> listen(const link::Port& port, Clock::time_point deadline) {
  wire::FrameDecoder decoder;
  std::array<std::uint8_t, 256> buffer{};
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return {};
    pollfd descriptor{port.fd(), POLLIN, 0};
    const int ready = ::poll(&descriptor, 1, static_cast<int>(left.count()));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t n = ::read(port.fd(), buffer.data(), buffer.size());
    if (n <= 0 && (n == 0 || (errno != EAGAIN && errno != EINTR))) return {};
    for (ssize_t i = 0; i < n; ++i) {
      if (decoder.push(buffer[static_cast<std::size_t>(i)]) != wire::DecodeResult::kFrame) continue;
      if (decoder.type() != static_cast<std::uint8_t>(wire::Type::kHello)) continue;
      const auto hello = link::read_hello(decoder.payload(), decoder.size());
      if (hello) return hello;
    }
  }
}

}  // namespace

HelloReply reply_of(const wire::Hello& hello) {
  const std::string firmware = "firmware " + firmware_text(hello) + ", protocol ";
  if (link::is_ours(hello))
    return {true, board_name(hello.board) + (", " + firmware) + std::to_string(hello.protocol)};
  return {false, firmware + text::format("%u schema %08x, but tp100d uses protocol %u schema %08x; "
                                         "flash the board with %s",
                                         hello.protocol, hello.schema, wire::kProtocolVersion,
                                         wire::kSchemaHash, flash_command().c_str())};
}

int run_hello(const HelloOptions& options) {
  const link::Port port = link::open_port(options.port, {});
  const auto patience = std::chrono::duration<double>(options.timeout_s);
  const auto hello =
      listen(port, Clock::now() + std::chrono::duration_cast<Clock::duration>(patience));
  const HelloReply reply =
      hello ? reply_of(*hello)
            : HelloReply{false, "no hello of a TP100; flash the board with " + flash_command() +
                                    ", or choose another port (see `tp100d ports`)"};
  std::fprintf(reply.ours ? stdout : stderr, "%s: %s\n", options.port.c_str(), reply.text.c_str());
  return reply.ours ? 0 : 1;
}

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
  std::string received;
  for (HostNs now = monotonic_now(); now < end; now = monotonic_now()) {
    if (now >= next_ns) {
      next_ns = now + kAskEveryNs;
      if (::write(port.fd(), kSignOn.data(), kSignOn.size()) < 0) continue;
    }
    pollfd descriptor{port.fd(), POLLIN, 0};
    ::poll(&descriptor, 1, 20);
    std::array<char, 256> buffer;
    const ssize_t n = ::read(port.fd(), buffer.data(), buffer.size());
    if (n > 0) received.append(buffer.data(), static_cast<std::size_t>(n));
    if (received.find(kSignature) != std::string::npos) return true;
    if (n == 0) return false;
  }
  return false;
}

}  // namespace tp100::doctor
