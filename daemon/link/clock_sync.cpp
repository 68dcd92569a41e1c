#include "link/clock_sync.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp100::link {
namespace {

// An exchange of age t bounds the relation by half its trip plus this much drift of the drift.
constexpr double kAgeing = 10e-6;
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

}  // namespace

void ClockSync::reset(HostNs now) {
  count_ = next_ = 0;
  origin_ns_ = now;
  state_ = {};
  next_ask_ns_ = now;
  outstanding_ = false;
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
  next_ask_ns_ = now + (quick_left_ > 0 ? kQuickPeriodNs : kPeriodNs);
}

ClockSync::Verdict ClockSync::answered(std::uint16_t id, DeviceUs received_us, DeviceUs sent_us,
                                       HostNs now, HostNs wire_ns) {
  if (!outstanding_ || id != id_) return Verdict::kUnmatched;
  outstanding_ = false;

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
      std::max(0.0, static_cast<double>(trip) / 2.0)};

  const double best = best_half_trip_ns(now);
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
  state.uncertainty_us = best_half_trip_ns(now) * 1e-3;
  return state;
}

void ClockSync::store(const Exchange& exchange) {
  window_[next_] = exchange;
  next_ = (next_ + 1) % kWindow;
  count_ = std::min(count_ + 1, kWindow);
}

double ClockSync::best_half_trip_ns(HostNs now) const {
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < count_; ++i) {
    const double age_ns = std::max(0.0, static_cast<double>(now - origin_ns_) - window_[i].host_ns);
    best = std::min(best, window_[i].half_trip_ns + kAgeing * age_ns);
  }
  return count_ == 0 ? 0.0 : best;
}

// Weighted least squares of (host - device) over device time with a prior on the slope, about the
// newest exchange, where the line is used.
void ClockSync::fit(HostNs now) {
  const double best = best_half_trip_ns(now);
  const Exchange& newest = window_[(next_ + kWindow - 1) % kWindow];
  double w0 = 0.0, w1 = 0.0, w2 = 0.0, y0 = 0.0, y1 = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Exchange& exchange = window_[i];
    const double x = static_cast<double>(exchange.device_us - newest.device_us) * 1e3;
    const double y = exchange.host_ns - newest.host_ns - x;
    const double sd = kFloorNs + std::max(0.0, exchange.half_trip_ns - best) + kAgeing * -x;
    const double w = 1.0 / (sd * sd);
    w0 += w;
    w1 += w * x;
    w2 += w * x * x;
    y0 += w * y;
    y1 += w * x * y;
  }
  w2 += 1.0 / (kDriftPrior * kDriftPrior);
  const double determinant = w0 * w2 - w1 * w1;
  const double drift = (w0 * y1 - w1 * y0) / determinant;
  const double offset = (w2 * y0 - w1 * y1) / determinant;

  state_.reference_us = newest.device_us;
  state_.reference_host_ns =
      origin_ns_ + static_cast<HostNs>(std::llround(newest.host_ns + offset));
  state_.drift = drift;
  state_.uncertainty_us = best * 1e-3;
  state_.valid = state_.valid || count_ >= kValidAfter;
}

}  // namespace tp100::link
