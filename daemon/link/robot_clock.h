#pragma once
// The robot's clock as a session sees it: its times extended to 64 bit, the exchange of clock
// requests and replies, and the relation to the host's clock that comes of them. No allocation;
// safe in the real-time thread.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/link_state.h"
#include "link/clock_sync.h"
#include "link/output_queue.h"
#include "wire/messages.h"

namespace tp100::link {

/// Device time extended to 64 bit within one boot, across sessions.
class DeviceClock {
 public:
  /// A new boot: no relation to earlier times.
  void forget() { known_ = false; }
  /// The extended time of a value read at host time `now`.
  DeviceUs extend(std::uint32_t device_us, HostNs now);

 private:
  DeviceUs newest_us_ = 0;
  HostNs newest_ns_ = 0;
  bool known_ = false;
};

class RobotClock {
 public:
  /// `baud`: for wire times; 0: bytes take no time. `output` and `counters` must outlive the clock.
  /// Clock answers later than `answer_ns` are not used.
  RobotClock(std::uint32_t baud, HostNs answer_ns, OutputQueue<kMaxOut>& output,
             LinkCounters& counters)
      : baud_(baud), output_(output), counters_(counters), sync_(answer_ns) {}

  /// A new boot: no relation to earlier times.
  void forget_boot() { device_clock_.forget(); }
  /// A session begins: the relation is unknown.
  void begin_session(HostNs now);
  void end_session() { state_ = {}; }
  /// A device time, read at host time `now`, extended to 64 bit.
  DeviceUs extend(std::uint32_t device_us, HostNs now) {
    return device_clock_.extend(device_us, now);
  }

  /// Queues a clock request if one is due, or at once if `keep_alive`. True if it was queued.
  bool request(bool keep_alive, HostNs now);
  /// A reply of this session, read at `now`; `bytes` of it were on the wire.
  void on_reply(const wire::SyncReply& reply, std::size_t bytes, HostNs now);
  /// Time passes: the relation becomes less certain.
  void age(HostNs now);

  /// The relation as of the last reply or age(); invalid outside a session.
  const ClockState& state() const { return state_; }
  /// Answers of this session that came too late, and what is too late.
  std::uint32_t late() const { return sync_.late(); }
  HostNs answer_ns() const { return sync_.answer_ns(); }
  /// The relation as of the last reply.
  const ClockState& fitted() const { return sync_.state(); }
  /// True while a reply may arrive at any moment; its time of arrival matters.
  bool expects_reply(HostNs now) const { return sync_.expects_reply(now); }

 private:
  void count_robots_own(const wire::SyncReply& reply);
  HostNs wire_ns(std::size_t bytes) const;

  std::uint32_t baud_;
  OutputQueue<kMaxOut>& output_;
  LinkCounters& counters_;
  DeviceClock device_clock_;
  ClockSync sync_;
  ClockState state_{};
  std::optional<wire::SyncReply> last_reply_{};  // of this session
};

}  // namespace tp100::link
