#include "server/wheel.h"

#include <algorithm>
#include <cmath>

#include "server/access.h"
#include "text/format.h"

namespace tp100::server {
namespace {

constexpr std::size_t kMaxName = 64;
// Faster than any robot; the step limits it to what this one can do.
constexpr double kMaxVelocity = 100.0;
constexpr double kMaxInputMs = 1e15;
// Clocks of two machines drift apart by less than this.
constexpr HostNs kDriftDivisor = 1000;

std::string slow(HostNs round_trip_ns) {
  return text::format(
      "the first input came %.2f s after the token: driving by hand needs a path to the daemon "
      "with "
      "a round trip of less than %.1f s, and a first input (zero speed will do) at once after the "
      "token",
      to_s(round_trip_ns), to_s(Wheel::kMaxRoundTripNs));
}

}  // namespace

std::optional<DriveRequest> drive_request(const std::vector<RequestField>& fields,
                                          std::string& why) {
  DriveRequest out;
  bool has_token = false, has_speed = false, has_rate = false, has_input = false;
  const auto number = [&](const RequestField& field, double most, double& value, bool& has) {
    const double* given = std::get_if<double>(&field.value);
    has = given != nullptr && std::abs(*given) <= most;
    if (has) value = *given;
    return has;
  };
  for (const RequestField& field : fields) {
    bool good = true;
    if (field.name == "token") {
      const std::string* token = std::get_if<std::string>(&field.value);
      good = has_token = token != nullptr;
      if (good) out.token = *token;
    } else if (field.name == "speed_mps") {
      good = number(field, kMaxVelocity, out.speed_mps, has_speed);
    } else if (field.name == "yaw_rate_radps") {
      good = number(field, kMaxVelocity, out.yaw_rate_radps, has_rate);
    } else if (field.name == "input_ms") {
      good = number(field, kMaxInputMs, out.input_ms, has_input);
    } else {
      why = "there is no argument '" + text::one_line(field.name, kMaxName) + "'";
      return std::nullopt;
    }
    if (good) continue;
    why = field.name +
          (field.name == "token" ? " must be a string" : " must be a number within its range");
    return std::nullopt;
  }
  if (has_token && has_speed && has_rate && has_input) return out;
  why = "token, speed_mps, yaw_rate_radps and input_ms are needed";
  return std::nullopt;
}

std::optional<std::string> Wheel::take(const Driver& driver, HostNs now) {
  if (fresh(now) && driver.id != driver_.id) {
    asking_ = driver;
    asked_ns_ = now;
    return std::nullopt;
  }
  *this = Wheel{};
  token_ = random_name();
  driver_ = driver;
  taken_ns_ = input_ns_ = received_ns_ = now;
  return token_;
}

std::optional<VelocityInput> Wheel::drive(const DriveRequest& request, HostNs now,
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
      why = slow(round_trip_ns);
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

bool Wheel::release(std::string_view token) {
  if (!holds(token)) return false;
  clear();
  return true;
}

bool Wheel::lose(std::string_view id) {
  if (asking_.id == id) asking_ = {};
  if (token_.empty() || driver_.id != id) return false;
  clear();
  return true;
}

messages::DriverFigures Wheel::figures(HostNs now) const {
  messages::DriverFigures out;
  if (token_.empty()) return out;
  out.by = driver_.name;
  out.fresh = fresh(now);
  if (!asking_.id.empty() && now - asked_ns_ <= kAskNs) out.asked_by = asking_.name;
  return out;
}

}  // namespace tp100::server
