// What a session sends, and when.
#include <algorithm>

#include "link/session.h"

namespace tp100::link {
namespace {

using wire::Type;

constexpr HostNs kHelloRequestPeriodNs = 200 * kNsPerMs;
constexpr HostNs kParametersPeriodNs = 100 * kNsPerMs;
// The robot takes a host that is silent for kHostSilenceMs as lost.
constexpr HostNs kKeepAliveNs = 400 * kNsPerMs;
constexpr HostNs kArmLifeNs = kRequestLimitNs;

// A millisecond on the wire at the usual speed.
constexpr std::uint32_t kMostPadding = 50;

/// How many bytes a request waits: spread evenly over successive ids, by the golden section.
std::size_t spread(std::uint16_t id) { return ((id * 40503U & 0xFFFFU) * kMostPadding) >> 16U; }

std::int32_t number(SessionState state) { return static_cast<std::int32_t>(state); }
std::int32_t number(Type type) { return static_cast<std::int32_t>(type); }

}  // namespace

void Session::poll(HostNs now) {
  poll_timeout(now);
  poll_unanswered(now);
  poll_requests(now);
  poll_handshake(now);
  poll_sync(now);
  if (clock_.valid) clock_ = sync_.state_at(now);
}

void Session::poll_timeout(HostNs now) {
  if (state_ == SessionState::kClosed) return;
  const bool listening = state_ == SessionState::kListening;
  const HostNs limit = listening ? settings_.first_frame_timeout_ns : settings_.timeout_ns;
  if (now - last_good_ns_ < limit) return;
  ++counters_.silences;
  note(SessionEvent::Kind::kTimeout, now, number(state_));
  last_good_ns_ = now;
  if (listening) return;
  back_off(now);
  end_session(now);
  output_.reset();
  enter(SessionState::kListening, now);
}

// Where nothing of ours arrives, the robot's own frames still do.
void Session::poll_unanswered(HostNs now) {
  const HostNs since = std::max(handshake_ns_, not_before_ns_);
  if (!in_handshake() || now - since < settings_.first_frame_timeout_ns) return;
  ++counters_.unanswered;
  note(SessionEvent::Kind::kUnanswered, now, number(state_));
  handshake_ns_ = now;
}

void Session::poll_requests(HostNs now) {
  if (stop_.take_overdue(now)) note(SessionEvent::Kind::kNotAcknowledged, now, number(Type::kStop));
  if (motion_.take_overdue(now)) {
    if (motion_type_ == Type::kArm) {
      fail_arm(now);
    } else {
      motion_.cancel();
      answer_ = RequestAnswer::kFailed;
      note(SessionEvent::Kind::kNotAcknowledged, now, number(motion_type_));
    }
  }
  if (!connected()) return;
  if (stop_.due(now)) {
    output_.push(wire::Stop{stop_.token()});
    stop_.sent(now);
    last_sent_ns_ = now;
  }
  if (!motion_.due(now)) return;
  if (motion_type_ == Type::kArm) {
    if (stop_.pending()) return;
    output_.push(arm_);
  } else {
    output_.push(wire::Disarm{motion_.token()});
  }
  motion_.sent(now);
  last_sent_ns_ = now;
}

void Session::poll_handshake(HostNs now) {
  if (now < not_before_ns_) return;
  if (state_ == SessionState::kHello && now >= next_hello_ns_) {
    output_.push(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    next_hello_ns_ = now + kHelloRequestPeriodNs;
    last_sent_ns_ = now;
  }
  if (state_ == SessionState::kParameters && now >= next_parameters_ns_) {
    output_.push(settings_.parameters);
    next_parameters_ns_ = now + kParametersPeriodNs;
    last_sent_ns_ = now;
  }
}

void Session::poll_sync(HostNs now) {
  if (!in_session()) return;
  const auto id = sync_.due(now - last_sent_ns_ >= kKeepAliveNs ? sync_.next_ns() : now);
  if (!id) return;
  // Turns of the loop and frames of a USB bus are whole milliseconds: without this, each reply
  // would wait for the bus as long as the last one did.
  output_.pad(spread(*id));
  const std::size_t ahead = output_.bytes().size();
  const std::size_t size = output_.push(wire::SyncRequest{*id});
  if (size == 0) return;
  sync_.asked(*id, now, wire_ns(ahead + size));
  last_sent_ns_ = now;
}

void Session::send(const Command& command, HostNs now) {
  if (!in_session()) return;
  wire::Command out{};
  out.boot_nonce = hello_.boot_nonce;
  out.sequence = ++command_sequence_;
  out.answers = command.answers;
  out.x_m = static_cast<float>(command.pose.x_m);
  out.y_m = static_cast<float>(command.pose.y_m);
  out.yaw_rad = static_cast<float>(command.pose.yaw_rad);
  out.desired_yaw_rad = static_cast<float>(command.desired_yaw_rad);
  out.yaw_rate_radps = static_cast<float>(command.yaw_rate_radps);
  out.speed_mps = static_cast<float>(command.speed_mps);
  out.expiry_us = static_cast<std::uint32_t>(command.expiry_us);
  out.gyro_bias_radps = static_cast<float>(command.gyro_bias_radps);
  if (output_.push(out) > 0) last_sent_ns_ = now;
}

void Session::request(RobotRequest request, HostNs now) {
  switch (request) {
    case RobotRequest::kNone:
      return;
    case RobotRequest::kStop:
      fail_arm(now);
      // One that is under way is the same to the robot, and goes on being repeated.
      if (!stop_.pending()) stop_.start(next_token(now), now);
      return;
    case RobotRequest::kDisarm:
      fail_arm(now);
      answer_ = RequestAnswer::kNone;
      if (!connected()) {
        answer_ = RequestAnswer::kFailed;
        note(SessionEvent::Kind::kNotAcknowledged, now, number(Type::kDisarm));
        return;
      }
      motion_type_ = Type::kDisarm;
      motion_.start(next_token(now), now);
      return;
    case RobotRequest::kArm:
      fail_arm(now);
      answer_ = RequestAnswer::kNone;
      if (state_ != SessionState::kReady) {
        answer_ = RequestAnswer::kFailed;
        note(SessionEvent::Kind::kNotAcknowledged, now, number(Type::kArm));
        return;
      }
      motion_type_ = Type::kArm;
      motion_.start(next_token(now), now);
      arm_ = {hello_.boot_nonce, motion_.token(),
              static_cast<std::uint32_t>(clock_.to_device(now + kArmLifeNs))};
      return;
  }
}

}  // namespace tp100::link
