#include "link/request_sender.h"

#include <algorithm>

namespace tp100::link {
namespace {

using wire::Result;
using wire::Type;

// Tokens grow with time, so that those of an earlier daemon in the same boot of the robot are
// lower; they wrap after 497 days.
constexpr HostNs kTokenTickNs = 10 * kNsPerMs;
constexpr std::uint32_t kTokenLeap = 1U << 24U;

}  // namespace

void OneShotRequest::start(std::uint32_t token, HostNs now) {
  token_ = token;
  started_ns_ = now;
  next_ns_ = now;
  pending_ = true;
  overdue_ = false;
}

bool OneShotRequest::take_overdue(HostNs now) {
  if (!pending_ || overdue_ || now - started_ns_ < kAnswerNs) return false;
  overdue_ = true;
  return true;
}

bool OneShotRequest::acknowledge(std::uint32_t token) {
  if (!pending_ || token != token_) return false;
  pending_ = false;
  return true;
}

std::uint32_t Tokens::next(HostNs now) {
  const auto tick = static_cast<std::uint32_t>(now / kTokenTickNs);
  token_ = std::max(token_, tick) + 1;
  return token_;
}

void Tokens::leap() { token_ += kTokenLeap; }

void RequestSender::stop(HostNs now) {
  fail_arm(now);
  // For the robot a STOP under way is the same one; it is repeated with the same token.
  if (!stop_.pending()) stop_.start(tokens_.next(now), now);
}

void RequestSender::disarm(HostNs now) { start_motion(Type::kDisarm, now); }

void RequestSender::arm(std::uint32_t boot_nonce, std::uint32_t expiry_us, HostNs now) {
  start_motion(Type::kArm, now);
  arm_ = {boot_nonce, motion_.token(), expiry_us};
}

void RequestSender::start_motion(Type type, HostNs now) {
  fail_arm(now);
  answer_ = RequestAnswer::kNone;
  motion_type_ = type;
  motion_.start(tokens_.next(now), now);
}

void RequestSender::refuse(Type type, HostNs now) {
  fail_arm(now);
  fail_motion(type, now);
}

void RequestSender::fail_motion(Type type, HostNs now) {
  answer_ = RequestAnswer::kFailed;
  events_.note(NotAcknowledged{type}, now);
}

void RequestSender::fail_arm(HostNs now) {
  if (!motion_.pending() || motion_type_ != Type::kArm) return;
  overdue_arm_token_ = motion_.token();
  motion_.cancel();
  fail_motion(Type::kArm, now);
}

void RequestSender::restart_stop(HostNs now) {
  if (stop_.pending()) stop_.start(tokens_.next(now), now);
}

void RequestSender::end_session(HostNs now) {
  fail_arm(now);
  motion_.cancel();
}

bool RequestSender::poll(bool connected, HostNs now) {
  if (stop_.take_overdue(now)) events_.note(NotAcknowledged{Type::kStop}, now);
  if (motion_.take_overdue(now)) {
    if (motion_type_ == Type::kArm) {
      fail_arm(now);
    } else {
      motion_.cancel();
      fail_motion(motion_type_, now);
    }
  }
  if (!connected) return false;
  const bool stop_due = stop_.due(now);
  if (stop_due) {
    output_.push(wire::Stop{stop_.token()});
    stop_.sent(now);
  }
  if (!motion_.due(now)) return stop_due;
  if (motion_type_ == Type::kArm) {
    if (stop_.pending()) return stop_due;
    output_.push(arm_);
  } else {
    output_.push(wire::Disarm{motion_.token()});
  }
  motion_.sent(now);
  return true;
}

bool RequestSender::on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now) {
  const Type type{acknowledge.request};
  const Result result{acknowledge.result};
  if (type == Type::kStop) {
    if (!stop_.acknowledge(acknowledge.token)) return false;
  } else if (type == motion_type_ && motion_.acknowledge(acknowledge.token)) {
    answer_ = result == Result::kAccepted ? RequestAnswer::kAcknowledged : RequestAnswer::kFailed;
    if (result == Result::kStaleToken) tokens_.leap();
  } else if (type == Type::kArm && result == Result::kAccepted &&
             acknowledge.token == overdue_arm_token_) {
    overdue_arm_token_ = 0;
    return !motion_.pending();
  } else {
    return false;
  }
  events_.note(Acknowledged{type, result, acknowledge.detail}, now);
  return false;
}

}  // namespace tp100::link
