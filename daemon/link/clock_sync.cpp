#include "link/clock_sync.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/number.h"

namespace tp100::link {
namespace {

// An exchange bounds the offset of the clocks by half its round trip. The bound widens with the age
// of the exchange by this share, because the drift itself changes.
constexpr double kAgeing = 3e-6;
// Resonators of cheap boards are off by up to 0.5 %, usually far less.
constexpr double kDriftPrior = 500e-6;
// Reading the clock, scheduling and the device's 4 us tick.
constexpr double kFloorNs = 4'000.0;
constexpr double kGateNs = 500'000.0;
constexpr double kGateFactor = 5.0;
constexpr double kMisfitNs = 2'000'000.0;
constexpr int kMisfitsBeforeRestart = 4;
// Clocks are read a little before or after the bytes move.
constexpr HostNs kEarliestNs = -200 * kNsPerUs;
constexpr int kFitRounds = 3;
// An answer to one of this many last requests counts as late, not as unmatched.
constexpr std::uint16_t kLateIds = 16;

/// Weighted straight line.
class Fit {
 public:
  void add(double x, double y, double sd) {
    const double w = 1.0 / (sd * sd);
    w_ += w;
    x_ += w * x;
    y_ += w * y;
    xx_ += w * x * x;
    xy_ += w * x * y;
  }
  double variance() const { return xx_ - x_ * x_ / w_; }
  double covariance() const { return xy_ - x_ * y_ / w_; }
  double at_newest(double slope) const { return (y_ - slope * x_) / w_; }

 private:
  double w_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

// One millisecond on the wire at the usual baud rate.
constexpr std::uint32_t kMaxPadding = 50;

/// Number of bytes by which a request is delayed: spread evenly over successive ids, by the golden
/// section.
std::size_t spread(std::uint16_t id) { return ((id * 40503U & 0xFFFFU) * kMaxPadding) >> 16U; }

}  // namespace

void ClockSync::reset(HostNs now) {
  count_ = next_ = 0;
  origin_ns_ = now;
  state_ = {};
  next_ask_ns_ = now;
  outstanding_ = false;
  late_ = 0;
  quick_left_ = kQuickExchanges;
  usual_excess_ns_ = 0.0;
  misfits_ = 0;
}

std::optional<std::uint16_t> ClockSync::due(HostNs now) const {
  if (now < next_ask_ns_) return std::nullopt;
  return static_cast<std::uint16_t>(id_ + 1);
}

void ClockSync::asked(std::uint16_t id, HostNs now, HostNs wire_ns) {
  id_ = id;
  asked_ns_ = now;
  request_wire_ns_ = wire_ns;
  outstanding_ = true;
  next_ask_ns_ = now + (quick_left_ > 0 ? answer_ns_ : std::max(answer_ns_, kPeriodNs));
}

ClockSync::Verdict ClockSync::answered(std::uint16_t id, DeviceUs received_us, DeviceUs sent_us,
                                       HostNs now, HostNs wire_ns) {
  const auto requests_ago = static_cast<std::uint16_t>(id_ - id);
  if (requests_ago > 0 && requests_ago <= kLateIds) {
    ++late_;
    return Verdict::kLate;
  }
  if (!outstanding_ || id != id_) return Verdict::kUnmatched;
  outstanding_ = false;
  next_ask_ns_ = asked_ns_ + (quick_left_ > 0 ? kQuickPeriodNs : kPeriodNs);

  const HostNs start = asked_ns_ + request_wire_ns_;
  const HostNs end = now - wire_ns;
  const HostNs trip = (end - start) - (sent_us - received_us) * kNsPerUs;
  // Wire times are nominal (an emulator may skip part of them), so that a good exchange can come
  // out below zero; but no reply is older than its request.
  const HostNs whole_trip = trip + request_wire_ns_ + wire_ns;
  if (sent_us < received_us || whole_trip < kEarliestNs) return Verdict::kOutlier;

  const DeviceUs device_us = received_us + (sent_us - received_us) / 2;
  const double half_us_ns = (sent_us - received_us) % 2 == 0 ? 0.0 : 500.0;
  const Exchange exchange{
      device_us,
      (static_cast<double>(start - origin_ns_) + static_cast<double>(end - origin_ns_)) / 2.0 -
          half_us_ns,
      std::max(0.0, static_cast<double>(trip) / 2.0),
      trip < 0 ? static_cast<double>(whole_trip) / 2.0 : 0.0};

  const double best = open_ns(now);
  const double excess = count_ == 0 ? 0.0 : std::max(0.0, exchange.half_trip_ns - best);
  Verdict verdict = Verdict::kAccepted;
  const double gate = kGateNs + kGateFactor * usual_excess_ns_;
  usual_excess_ns_ += (std::min(excess, gate) - usual_excess_ns_) / 8.0;
  if (state_.valid) {
    if (excess > gate) return Verdict::kOutlier;
    const double predicted = static_cast<double>(state_.to_host(device_us) - origin_ns_);
    const double misfit = std::abs(exchange.host_ns - predicted) - exchange.half_trip_ns -
                          state_.uncertainty_us * 1e3;
    if (misfit > kMisfitNs) {
      if (++misfits_ < kMisfitsBeforeRestart) return Verdict::kOutlier;
      count_ = next_ = 0;
      usual_excess_ns_ = 0.0;
      quick_left_ = kQuickExchanges;
      verdict = Verdict::kRestarted;
    }
  }
  misfits_ = 0;
  if (quick_left_ > 0) --quick_left_;
  store(exchange);
  fit(now);
  return verdict;
}

ClockState ClockSync::state_at(HostNs now) const {
  ClockState state = state_;
  state.uncertainty_us = uncertainty_us(now);
  return state;
}

void ClockSync::store(const Exchange& exchange) {
  window_[next_] = exchange;
  next_ = (next_ + 1) % kWindow;
  count_ = std::min(count_ + 1, kWindow);
}

// A message can be late but not early: in each direction the earliest messages bound the relation,
// however late the other half of their exchange was.
ClockSync::Bounds ClockSync::bounds(HostNs now, double drift) const {
  const Exchange& newest = window_[(next_ + kWindow - 1) % kWindow];
  Bounds open{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  for (std::size_t i = 0; i < count_; ++i) {
    const Exchange& exchange = window_[i];
    const double off_ns = exchange.off_ns(newest, drift);
    const double age_ns = std::max(0.0, static_cast<double>(now - origin_ns_) - exchange.host_ns);
    const double blur_ns = exchange.half_trip_ns + kAgeing * age_ns;
    open.lowest_ns = std::max(open.lowest_ns, off_ns - blur_ns);
    open.highest_ns = std::min(open.highest_ns, off_ns + blur_ns);
  }
  return open;
}

double ClockSync::open_ns(HostNs now) const {
  if (count_ == 0) return 0.0;
  const Bounds open = bounds(now, state_.drift);
  return std::max(0.0, (open.highest_ns - open.lowest_ns) / 2.0);
}

double ClockSync::uncertainty_us(HostNs now) const {
  if (count_ == 0) return 0.0;
  const Exchange& newest = window_[(next_ + kWindow - 1) % kWindow];
  double open_ns = this->open_ns(now);
  if (open_ns == 0.0) {
    open_ns = window_[0].half_trip_ns;
    for (std::size_t i = 1; i < count_; ++i) open_ns = std::min(open_ns, window_[i].half_trip_ns);
  }
  return std::max({open_ns, newest.unknown_wire_ns, kFloorNs}) * 1e-3;
}

// Weighted least squares of (host - device) over device time about the newest exchange, where the
// line is used: parallel lines through what the requests and what the replies allow, with a prior
// on their slope. The relation lies in the middle. What counts as late depends on the slope.
void ClockSync::fit(HostNs now) {
  const Exchange& newest = window_[(next_ + kWindow - 1) % kWindow];
  double drift = state_.drift;
  double offset_ns = 0.0;
  for (int round = 0; round < kFitRounds; ++round) {
    const Bounds open = bounds(now, drift);
    Fit requests, replies;
    for (std::size_t i = 0; i < count_; ++i) {
      const Exchange& exchange = window_[i];
      const double x = static_cast<double>(exchange.device_us - newest.device_us) * 1e3;
      const double y = exchange.off_ns(newest, 0.0);
      const double off_ns = exchange.off_ns(newest, drift);
      const double half = exchange.half_trip_ns;
      const double sd = kFloorNs + kAgeing * -x;
      requests.add(x, y - half, sd + std::max(0.0, open.lowest_ns - (off_ns - half)));
      replies.add(x, y + half, sd + std::max(0.0, off_ns + half - open.highest_ns));
    }
    drift = (requests.covariance() + replies.covariance()) /
            (requests.variance() + replies.variance() + 1.0 / (kDriftPrior * kDriftPrior));
    offset_ns = (requests.at_newest(drift) + replies.at_newest(drift)) / 2.0;
  }

  state_.reference_us = newest.device_us;
  state_.reference_host_ns =
      origin_ns_ + static_cast<HostNs>(std::llround(newest.host_ns + offset_ns));
  state_.drift = drift;
  state_.uncertainty_us = uncertainty_us(now);
  state_.valid = state_.valid || count_ >= kValidAfter;
}

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
      expected + shared::wrapped_difference(device_us, static_cast<std::uint32_t>(expected));
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
  const auto corrupted = shared::wrapped_difference(reply.corrupted, before.corrupted);
  const auto missed = shared::wrapped_difference(reply.missed_edges, before.missed_edges);
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
