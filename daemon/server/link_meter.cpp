#include "server/link_meter.h"

namespace tp100::server {
namespace {

constexpr HostNs kMarkNs = 100 * kNsPerMs;
constexpr HostNs kWindowNs = kNsPerS;

std::uint64_t bad(const LinkCounters& link) {
  return link.damaged() + link.unknown_type + link.wrong_size + link.implausible;
}

}  // namespace

void LinkMeter::take(const StepRecord& record) {
  last_ = record.link;
  last_ns_ = record.now_ns;
  session_ = record.session;
  clock_ = record.clock;
  if (!marks_.empty() && last_ns_ - marks_.back().at_ns < kMarkNs) return;
  marks_.push_back({last_ns_, last_});
  while (marks_.size() > 1 && last_ns_ - marks_.front().at_ns > kWindowNs) marks_.pop_front();
}

messages::LinkFigures LinkMeter::figures() const {
  messages::LinkFigures out;
  out.session = session_;
  out.counters = last_;
  out.clock = clock_;
  if (marks_.empty() || last_ns_ <= marks_.front().at_ns) return out;
  const LinkCounters& then = marks_.front().counters;
  const double window_s = to_s(last_ns_ - marks_.front().at_ns);
  const auto rate = [&](std::uint64_t from, std::uint64_t to) {
    return to < from ? 0.0 : static_cast<double>(to - from) / window_s;
  };
  out.samples_hz = rate(then.samples, last_.samples);
  out.lost_hz = rate(then.lost, last_.lost);
  out.bad_hz = rate(bad(then), bad(last_));
  out.in_bytes_ps = rate(then.bytes_in, last_.bytes_in);
  out.out_bytes_ps = rate(then.bytes_out, last_.bytes_out);
  return out;
}

}  // namespace tp100::server
