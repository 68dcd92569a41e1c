#include "link/robot_clock.h"

namespace tp100::link {
namespace {

// One millisecond on the wire at the usual baud rate.
constexpr std::uint32_t kMaxPadding = 50;

/// Number of bytes by which a request is delayed: spread evenly over successive ids, by the golden
/// section.
std::size_t spread(std::uint16_t id) { return ((id * 40503U & 0xFFFFU) * kMaxPadding) >> 16U; }

}  // namespace

DeviceUs DeviceClock::extend(std::uint32_t device_us, HostNs now) {
  if (!known_) {
    known_ = true;
    newest_us_ = device_us;
    newest_ns_ = now;
    return newest_us_;
  }
  // The host's clock gives the number of wraps, so that a long silence does not matter.
  const DeviceUs expected = newest_us_ + (now - newest_ns_) / kNsPerUs;
  const DeviceUs result =
      expected + wrapped_difference(device_us, static_cast<std::uint32_t>(expected));
  if (result > newest_us_) {
    newest_us_ = result;
    newest_ns_ = now;
  }
  return result;
}

void RobotClock::begin_session(HostNs now) {
  sync_.reset(now);
  state_ = {};
  last_reply_.reset();
}

bool RobotClock::request(bool keep_alive, HostNs now) {
  const auto id = sync_.due(keep_alive ? sync_.next_ns() : now);
  if (!id) return false;
  // Cycles of the loop and frames of a USB bus are whole milliseconds: without padding, each reply
  // would wait for the bus as long as the last one did.
  output_.pad(spread(*id));
  const std::size_t ahead = output_.bytes().size();
  const std::size_t size = output_.push(wire::SyncRequest{*id});
  if (size == 0) return false;
  sync_.asked(*id, now, wire_ns(ahead + size));
  return true;
}

void RobotClock::on_reply(const wire::SyncReply& reply, std::size_t bytes, HostNs now) {
  count_robots_own(reply);
  const DeviceUs received_us = extend(reply.received_us, now);
  const DeviceUs sent_us = extend(reply.sent_us, now);
  const auto verdict = sync_.answered(reply.id, received_us, sent_us, now, wire_ns(bytes));
  if (verdict == ClockSync::Verdict::kAccepted || verdict == ClockSync::Verdict::kRestarted) {
    ++counters_.sync_replies;
  } else {
    ++counters_.sync_rejected;
  }
  state_ = sync_.state_at(now);
}

void RobotClock::age(HostNs now) {
  if (state_.valid) state_ = sync_.state_at(now);
}

// Counts from before the session belong to another session or to the bootloader; an old reply may
// arrive late.
void RobotClock::count_robots_own(const wire::SyncReply& reply) {
  const wire::SyncReply before = last_reply_.value_or(reply);
  const auto corrupted = wrapped_difference(reply.corrupted, before.corrupted);
  const auto missed = wrapped_difference(reply.missed_edges, before.missed_edges);
  if (corrupted < 0 || missed < 0) return;
  counters_.robot_corrupted += static_cast<std::uint64_t>(corrupted);
  counters_.missed_edges += static_cast<std::uint64_t>(missed);
  last_reply_ = reply;
}

HostNs RobotClock::wire_ns(std::size_t bytes) const {
  constexpr HostNs kBitsPerByte = 10;
  if (baud_ == 0) return 0;
  return static_cast<HostNs>(bytes) * kBitsPerByte * kNsPerS / baud_;
}

}  // namespace tp100::link
