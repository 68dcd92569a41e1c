#pragma once
// Relation of the robot's clock to the host's from request/reply exchanges. Takes times only; no
// allocation; safe in the real-time thread.
//
// One exchange gives four times. With both frames' wire times removed, the rest of the round trip
// is queueing and USB latency, and the true relation lies within half of it around the middle: the
// request came no earlier than it was sent, the reply left no later than it came. Two parallel
// straight lines are fitted through the last exchanges, one through each of these bounds, each
// weighted by how much later than the earliest its message was; the relation lies half-way. Their
// drift has a prior, because the quick exchanges at the start span too little time to show it.
//
// RobotClock is the interface for a session: device times extended to 64 bit, and the exchange
// itself.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/link_state.h"
#include "link/output_queue.h"
#include "wire/messages.h"

namespace tp100::link {

class ClockSync {
 public:
  static constexpr HostNs kAnswerNs = 200 * kNsPerMs;
  static constexpr HostNs kQuickPeriodNs = 50 * kNsPerMs;
  /// Not a multiple of any other period here, so that exchanges do not keep meeting the same
  /// disturbance.
  static constexpr HostNs kPeriodNs = 246'900'000;
  static constexpr int kQuickExchanges = 8;
  static constexpr std::size_t kValidAfter = 4;  ///< accepted exchanges

  /// Outcome of a reply.
  enum class Verdict : std::uint8_t {
    kAccepted,
    kUnmatched,  ///< duplicated or never requested
    kLate,       ///< the answer to an earlier request, later than the limit
    kOutlier,    ///< a round trip far above the usual one, or impossible times
    kRestarted,  ///< the relation jumped: the fit starts again with this exchange
  };

  /// Answers that take longer than `answer_ns` are not used; until then no other request is sent.
  explicit ClockSync(HostNs answer_ns = kAnswerNs) : answer_ns_(answer_ns) {}

  /// Forgets everything (a new session).
  void reset(HostNs now);

  /// The id of the request to send if an exchange is due at `now`.
  std::optional<std::uint16_t> due(HostNs now) const;
  /// True while a reply may arrive at any moment; its time of arrival matters.
  bool expects_reply(HostNs now) const { return outstanding_ && now - asked_ns_ < 30 * kNsPerMs; }
  /// When the next exchange is due.
  HostNs next_ns() const { return next_ask_ns_; }
  /// The request `id` was passed to the port at `now`; its last byte is on the wire `wire_ns`
  /// later.
  void asked(std::uint16_t id, HostNs now, HostNs wire_ns);
  /// A reply was read at `now`; it took `wire_ns` on the wire. Device times are unwrapped.
  Verdict answered(std::uint16_t id, DeviceUs received_us, DeviceUs sent_us, HostNs now,
                   HostNs wire_ns);

  /// Answers since reset() that came later than the limit.
  std::uint32_t late() const { return late_; }
  HostNs answer_ns() const { return answer_ns_; }

  const ClockState& state() const { return state_; }
  /// The relation and its uncertainty at `now`.
  ClockState state_at(HostNs now) const;

 private:
  struct Exchange {
    DeviceUs device_us;   // middle of the exchange, whole us
    double host_ns;       // host time of device_us, minus origin_ns_
    double half_trip_ns;  // half of the round trip without wire times
    // Half of the whole round trip if the bytes took less than their nominal times; else 0.
    double unknown_wire_ns;
    /// Distance from a line of this drift through `other`.
    double off_ns(const Exchange& other, double drift) const {
      return host_ns - other.host_ns -
             static_cast<double>(device_us - other.device_us) * 1e3 * (1.0 + drift);
    }
  };
  /// Bounds that the exchanges put on the relation, relative to a line through the newest.
  struct Bounds {
    double lowest_ns, highest_ns;
  };
  static constexpr std::size_t kWindow = 64;

  void store(const Exchange& exchange);
  void fit(HostNs now);
  Bounds bounds(HostNs now, double drift) const;
  /// Half of the distance between the bounds.
  double open_ns(HostNs now) const;
  /// The same, or the uncertainty left by nominal wire times that are evidently wrong. If the
  /// exchanges contradict each other (a clock changed its rate), half of the quickest round trip.
  /// Never below what reading the clocks costs.
  double uncertainty_us(HostNs now) const;

  HostNs answer_ns_;
  std::array<Exchange, kWindow> window_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  HostNs origin_ns_ = 0;
  ClockState state_{};

  HostNs next_ask_ns_ = 0;
  HostNs asked_ns_ = 0;
  HostNs request_wire_ns_ = 0;
  std::uint16_t id_ = 0;
  bool outstanding_ = false;
  std::uint32_t late_ = 0;
  int quick_left_ = kQuickExchanges;
  double usual_excess_ns_ = 0.0;
  int misfits_ = 0;  // in a row
};

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
