#include "server/lease.h"

#include <algorithm>

#include "server/access.h"
#include "text/format.h"

namespace tp100::server {
namespace {

// Clocks of two machines drift apart by less than this.
constexpr HostNs kDriftDivisor = 1000;

}  // namespace

std::optional<std::string> Lease::take(const std::string& driver, HostNs now) {
  if (fresh(now) && driver != driver_) {
    asking_ = driver;
    asked_ns_ = now;
    return std::nullopt;
  }
  *this = Lease{};
  token_ = random_name();
  driver_ = driver;
  taken_ns_ = input_ns_ = received_ns_ = now;
  return token_;
}

std::optional<VelocityInput> Lease::drive(const DriveRequest& request, HostNs now,
                                          std::string& why) {
  if (!holds(request.token)) return std::nullopt;
  if (request.at_ns) {
    const HostNs at_ns = std::min(*request.at_ns, now);
    input_ns_ = std::max(input_ns_, at_ns);
    return VelocityInput{at_ns, request.speed_mps, request.yaw_rate_radps};
  }
  if (!clock_offset_ns_) {
    const HostNs round_trip_ns = now - taken_ns_;
    if (round_trip_ns >= kMaxRoundTripNs) {
      why = text::format(
          "the first input came %.2f s after the token: driving by hand needs a path to the daemon "
          "with a round trip of less than %.1f s, and a first input (zero speed will do) at once "
          "after the token",
          to_s(round_trip_ns), to_s(kMaxRoundTripNs));
      clear();
      return std::nullopt;
    }
    // What is left unknown of the delay is at most kFreshInputNs.
    path_age_ns_ = std::max<HostNs>(0, round_trip_ns - kFreshInputNs);
  }
  // The least delayed message gives the clocks' offset; the extra delay of another is its age.
  const HostNs offset_ns = now - path_age_ns_ - from_s(request.input_ms * 1e-3);
  clock_offset_ns_ =
      clock_offset_ns_
          ? std::min(offset_ns, *clock_offset_ns_ + (now - received_ns_) / kDriftDivisor)
          : offset_ns;
  received_ns_ = now;
  const HostNs at_ns = from_s(request.input_ms * 1e-3) + *clock_offset_ns_;
  input_ns_ = std::max(input_ns_, at_ns);
  return VelocityInput{at_ns, request.speed_mps, request.yaw_rate_radps};
}

bool Lease::release(std::string_view token) {
  if (!holds(token)) return false;
  clear();
  return true;
}

bool Lease::lose(std::string_view driver) {
  if (asking_ == driver) asking_.clear();
  if (token_.empty() || driver_ != driver) return false;
  clear();
  return true;
}

messages::DriverFigures Lease::figures(HostNs now) const {
  messages::DriverFigures out;
  if (token_.empty()) return out;
  out.by = driver_;
  out.fresh = fresh(now);
  if (now - asked_ns_ <= kAskNs) out.asked_by = asking_;
  return out;
}

}  // namespace tp100::server
