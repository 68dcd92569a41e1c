#pragma once
// The session with one robot: bytes and time in, samples and bytes out. A state machine without clock or
// port; no allocation after construction; safe in the real-time thread.

#include <array>
#include <cstdint>
#include <span>

#include "core/command.h"
#include "core/link_state.h"
#include "core/sample.h"
#include "wire/messages.h"

namespace tp100::link {

/// Settings of a session.
struct SessionSettings {
  wire::Parameters parameters{};     ///< nonce and token are filled in by the session
  std::uint32_t baud = wire::kBaud;  ///< for wire times; 0: bytes take no time
  HostNs timeout_ns = 500 * kNsPerMs;         ///< no good frame for this long: link lost
  HostNs first_frame_timeout_ns = 5 * kNsPerS;  ///< nothing heard for this long: warn
};

/// Something to tell the operator; the session never logs itself.
struct SessionEvent {
  enum class Kind : std::uint8_t {
    kState,            ///< a -> b: SessionState values
    kHello,            ///< hello received: see session.hello()
    kVersionMismatch,  ///< hello() shows the robot's versions
    kReboot,           ///< new boot nonce during a session
    kRobotFault,       ///< a: Fault bit, b: detail
    kRobotLog,         ///< text
    kAcknowledged,     ///< a: request wire::Type, b: wire::Result, detail
    kNotAcknowledged,  ///< a: request wire::Type
    kTimeout,          ///< no good frame within the time-out
  };
  Kind kind = Kind::kState;
  HostNs at_ns = 0;
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::uint32_t detail = 0;
  std::array<char, wire::Log::kTextSize + 1> text{};
};

class Session {
 public:
  static constexpr std::size_t kMaxSamples = 64;  ///< kept between two takes; older ones count as lost
  static constexpr std::size_t kMaxEvents = 32;
  static constexpr std::size_t kMaxOut = 1024;    ///< bytes waiting for the port

  explicit Session(const SessionSettings& settings);

  /// A port was opened: forget the peer, stay silent, listen.
  void open(HostNs now);
  /// The port is gone.
  void close(HostNs now);

  /// Bytes that arrived; `now` is the time at which the last of them was read.
  void receive(std::span<const std::uint8_t> bytes, HostNs now);
  /// Time passes: time-outs, retransmissions, sync requests. Call once a step.
  void poll(HostNs now);

  /// Queues one command frame. Ignored unless the state is kSyncing or kReady.
  void send(const Command& command, HostNs now);
  /// Starts a one-shot request, repeated until acknowledged or 200 ms have passed. STOP waits for the next
  /// session if there is none.
  void request(RobotRequest request, HostNs now);

  /// Samples since the last take, oldest first; valid until the next receive().
  std::span<const Sample> take_samples();
  std::span<const SessionEvent> take_events();
  /// Bytes to write. After writing `n` of them call written(n).
  std::span<const std::uint8_t> output() const;
  void written(std::size_t n);
  /// Drops bytes that the port did not take in time; counts them.
  void drop_output();

  SessionState state() const;
  const LinkCounters& counters() const;
  const ClockState& clock() const;
  const wire::Hello& hello() const;
  std::uint32_t session_number() const;  ///< +1 each time the state becomes kReady
  /// True once after a new boot nonce / a refused or unacknowledged arm.
  bool take_rebooted();
  bool take_refused();
  // private members are up to the implementation
};

}  // namespace tp100::link
