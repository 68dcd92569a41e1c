#include "doctor/robot_talk.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "core/clock.h"
#include "core/faults.h"

namespace tp100::doctor {
namespace {

// As often as a run does at its default rate, and as long-lived.
constexpr HostNs kCommandPeriodNs = 5 * kNsPerMs;
constexpr DeviceUs kCommandLifeUs = 150'000;
constexpr double kArmLimitS = 1.0;
constexpr double kDisarmLimitS = 0.5;
constexpr HostNs kUnaskedNs = 100 * kNsPerMs;
constexpr HostNs kStopAgainNs = 200 * kNsPerMs;

}  // namespace

RobotTalk::RobotTalk(link::Port port, const link::SessionSettings& settings,
                     const std::atomic<bool>& stop)
    : port_(std::move(port)), session_(settings), stop_(stop) {
  session_.open(monotonic_now());
}

bool RobotTalk::turn(double limit_s, const std::function<bool()>& enough) {
  const HostNs end = monotonic_now() + from_s(limit_s);
  while (!enough()) {
    if (gone_ || stop_ || monotonic_now() >= end) return false;
    turn_once();
  }
  return true;
}

void RobotTalk::command(double speed_mps, double yaw_rate_radps) {
  speed_mps_ = speed_mps;
  yaw_rate_radps_ = yaw_rate_radps;
}

bool RobotTalk::arm() {
  acknowledged_ = false;
  asked_ = true;
  why_ = "not acknowledged";
  remedy_ = "check the cable and run it again";
  session_.request(RobotRequest::kArm, monotonic_now());
  turn(kArmLimitS, [this] { return !session_.request_pending(); });
  return acknowledged_ && !stop_;
}

void RobotTalk::disarm() {
  command(0.0, 0.0);
  session_.request(RobotRequest::kDisarm, monotonic_now());
  const HostNs end = monotonic_now() + from_s(kDisarmLimitS);
  while (session_.request_pending() && !gone_ && monotonic_now() < end) turn_once();
  asked_ = false;
}

void RobotTalk::turn_once() {
  pollfd descriptor{port_.fd(), POLLIN, 0};
  ::poll(&descriptor, 1, 1);
  const HostNs now = monotonic_now();
  read(now);
  take(now);
  session_.poll(now);
  send(now);
  write();
}

void RobotTalk::read(HostNs now) {
  std::array<std::uint8_t, 4096> buffer;
  const ssize_t n = ::read(port_.fd(), buffer.data(), buffer.size());
  if (n > 0) {
    session_.receive(std::span(buffer.data(), static_cast<std::size_t>(n)), now);
  } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
    gone_ = true;
  }
}

void RobotTalk::take(HostNs now) {
  for (const link::SessionEvent& event : session_.take_events()) note(event);
  for (const Sample& sample : session_.take_samples()) {
    newest_ = sample;
    if (session_.session_number() != session_number_) {
      // Nothing was sent in this session yet, and the session goes on counting from here.
      session_number_ = session_.session_number();
      sequence_ = sample.last_command;
      awaiting_ = false;
    }
    if (awaiting_ && wrapped_difference(sample.last_command, awaited_) >= 0) {
      awaiting_ = false;
      on_confirmed(now - awaited_since_ns_);
    }
    watch(sample, now);
    on_sample(sample, now);
  }
}

void RobotTalk::watch(const Sample& sample, HostNs now) {
  if (asked_ || !motors_on(sample)) {
    on_since_ns_.reset();
    return;
  }
  if (!on_since_ns_) on_since_ns_ = sample.measured_ns;
  if (sample.measured_ns - *on_since_ns_ < kUnaskedNs) return;
  moved_unasked_ = true;
  if (now < next_stop_ns_) return;
  next_stop_ns_ = now + kStopAgainNs;
  session_.request(RobotRequest::kStop, now);
}

void RobotTalk::note(const link::SessionEvent& event) {
  using Kind = link::SessionEvent::Kind;
  if (event.kind == Kind::kHello || event.kind == Kind::kVersionMismatch) greeted_ = true;
  if (event.kind != Kind::kAcknowledged) return;
  const bool accepted = event.b == static_cast<std::int32_t>(wire::Result::kAccepted);
  if (event.a == static_cast<std::int32_t>(wire::Type::kParameters)) {
    if (event.b == static_cast<std::int32_t>(wire::Result::kOutOfRange))
      refused_parameter_ = static_cast<int>(event.detail);
    return;
  }
  if (event.a != static_cast<std::int32_t>(wire::Type::kArm)) return;
  acknowledged_ = accepted;
  if (accepted) return;
  why_ = "refused";
  if (event.b == static_cast<std::int32_t>(wire::Result::kFaultPersists)) {
    if (const auto fault = first_fault(event.detail)) {
      why_ = describe(*fault).cause;
      remedy_ = describe(*fault).remedy;
    }
  }
}

void RobotTalk::send(HostNs now) {
  const bool ready =
      session_.state() == SessionState::kReady && session_.session_number() == session_number_;
  if (!ready || now < next_command_ns_) return;
  next_command_ns_ = now + kCommandPeriodNs;
  Command command;
  command.answers = newest_.sequence;
  command.answered_us = newest_.device_us;
  command.speed_mps = speed_mps_;
  command.yaw_rate_radps = yaw_rate_radps_;
  command.expiry_us = session_.clock().to_device(now) + kCommandLifeUs;
  session_.send(command, now);
  ++sequence_;
  if (awaiting_) return;
  awaiting_ = true;
  awaited_ = sequence_;
  awaited_since_ns_ = now;
}

void RobotTalk::write() {
  while (!session_.output().empty()) {
    const ssize_t n = ::write(port_.fd(), session_.output().data(), session_.output().size());
    if (n < 0) {
      if (errno != EAGAIN && errno != EINTR) gone_ = true;
      return;
    }
    session_.written(static_cast<std::size_t>(n));
  }
}

}  // namespace tp100::doctor
