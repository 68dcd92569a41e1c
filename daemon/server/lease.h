#pragma once
// The lease: the right to drive by hand, which one client at a time holds, of whatever kind. Pure:
// times are passed in; the caller locks.

#include <optional>
#include <string>
#include <string_view>

#include "core/command.h"
#include "messages/figures.h"

namespace tp100::server {

/// One input of a driver, as the client sent it.
struct DriveRequest {
  std::string token;            ///< of Lease::take
  double speed_mps = 0.0;       ///< backwards negative
  double yaw_rate_radps = 0.0;  ///< counter-clockwise positive
  double input_ms = 0.0;        ///< when the person gave it, by the client's own clock
  /// The same as host time, if the client's clock is this machine's; then input_ms does not count.
  std::optional<HostNs> at_ns{};
};

/// A driver holds the lease until it releases it, is lost, or gives no fresh input while another
/// client asks for the lease.
class Lease {
 public:
  /// A client that was refused counts as asking for this long.
  static constexpr HostNs kAskNs = 5 * kNsPerS;
  /// A driver whose first input does not arrive within this time after take() cannot drive. Then,
  /// over any path and however its delay grows, an input counts as zero speed at most this long
  /// after the person gave it. (A delay that grows by less than 1 ms a second looks like a clock
  /// that drifts, and is not counted.)
  static constexpr HostNs kMaxRoundTripNs = 2 * kFreshInputNs;

  /// Gives the lease to `driver`, a name that no other client has, and returns the token; the
  /// previous token is ignored from now on. Returns nothing while another driver's input is fresh;
  /// that driver is then shown who asks.
  std::optional<std::string> take(const std::string& driver, HostNs now);
  /// The input with the host time at which the person gave it; nothing if the token does not hold
  /// the lease. A message that was delayed on its way, or that repeats an input, has the age of the
  /// person's input. The first input was given after take(): the time since then, a round trip at
  /// most, bounds the delay of the path. If that is kMaxRoundTripNs or more, the lease is released,
  /// and `why` says so in one line.
  std::optional<VelocityInput> drive(const DriveRequest& request, HostNs now, std::string& why);
  /// False: the token does not hold the lease.
  bool release(std::string_view token);
  /// The client is gone. True: it held the lease.
  bool lose(std::string_view driver);
  void clear() { *this = Lease{}; }

  HostNs taken_ns() const { return taken_ns_; }
  messages::DriverFigures figures(HostNs now) const;

 private:
  bool holds(std::string_view token) const { return !token_.empty() && token == token_; }
  bool fresh(HostNs now) const { return !token_.empty() && now - input_ns_ <= kFreshInputNs; }

  std::string token_;  // empty: nobody drives
  std::string driver_, asking_;
  HostNs taken_ns_ = 0;
  HostNs asked_ns_ = 0;
  HostNs input_ns_ = 0;                    // of the newest input
  HostNs received_ns_ = 0;                 // when the newest message arrived
  HostNs path_age_ns_ = 0;                 // that every input has at least
  std::optional<HostNs> clock_offset_ns_;  // host time - the client's clock
};

}  // namespace tp100::server
