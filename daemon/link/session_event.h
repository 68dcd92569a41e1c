#pragma once
// The events that a session reports to the operator; the session itself never logs. Plain data of
// fixed size: it passes through the real-time thread's rings.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include "core/bounded_list.h"
#include "core/link_state.h"
#include "wire/messages.h"

namespace tp100::link {

struct StateChanged {
  SessionState from{}, to{};
};
/// A robot of this version sent its hello: Session::hello().
struct HelloReceived {};
/// The hello names other versions than this program's: Session::hello().
struct VersionMismatch {};
/// An invalid hello: no known board sends one like it.
struct BadHello {
  std::uint32_t boot_nonce = 0;  ///< invalid if 0
  std::uint8_t state = 0;        ///< invalid beyond wire::State
};
/// The hello names a board that this version does not know; the session goes on.
struct UnknownBoard {
  std::uint8_t board = 0;
};
/// The robot's boot nonce changed during a session.
struct Rebooted {};
struct RobotFault {
  std::uint8_t fault = 0;  ///< number of a Fault, as received
  std::int32_t value = 0;  ///< wire::FaultReport::detail
};
struct RobotLog {
  std::uint32_t device_us = 0;
  std::array<char, wire::Log::kTextSize + 1> text{};  ///< printable, ends with 0
};
/// The robot accepted or refused a request.
struct Acknowledged {
  wire::Type request{};
  wire::Result result{};
  std::uint16_t detail = 0;  ///< see wire::Result
};
/// A request got no acknowledgement in time, or could not be sent.
struct NotAcknowledged {
  wire::Type request{};
};
/// No good frame within the time-out.
struct Silence {
  SessionState state{};  ///< in which it passed
};
/// Frames arrive, but not the answer that the handshake waits for.
struct Unanswered {
  SessionState state{};    ///< that waits for it
  HostNs too_late_ns = 0;  ///< clock answers came, but later than this; 0: none came
};

struct SessionEvent {
  HostNs at_ns = 0;
  std::variant<StateChanged, HelloReceived, VersionMismatch, BadHello, UnknownBoard, Rebooted,
               RobotFault, RobotLog, Acknowledged, NotAcknowledged, Silence, Unanswered>
      what{};
};
static_assert(std::is_trivially_copyable_v<SessionEvent>);

/// The event's `What`, or null if it is another one.
template <class What>
const What* as(const SessionEvent& event) {
  return std::get_if<What>(&event.what);
}

/// Events that wait to be taken. When it is full, further events are dropped.
class SessionEvents {
 public:
  static constexpr std::size_t kCapacity = 32;

  template <class What>
  void note(const What& what, HostNs now) {
    events_.push({now, what});
  }
  /// Events that the robot sends fill half of the list at most, so that no flood displaces others.
  template <class What>
  void note_from_robot(const What& what, HostNs now) {
    if (events_.size() < kCapacity / 2) note(what, now);
  }
  /// Events since the last take, oldest first; valid until the next note.
  std::span<const SessionEvent> take() {
    const std::span<const SessionEvent> taken(events_.begin(), events_.size());
    events_.clear();
    return taken;
  }

 private:
  BoundedList<SessionEvent, kCapacity> events_;
};

}  // namespace tp100::link
