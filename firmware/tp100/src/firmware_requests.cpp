#include "firmware.h"
#include "number.h"
#include "parameters.h"

namespace tp100 {
namespace firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

// A host that floods the wire must not hold up the loop.
const uint8_t kReceiveBudget = 32;
const int32_t kArmFurthestUs = 500000;
const uint16_t kArmExpiryField = 2;

uint16_t bit(Fault fault) { return static_cast<uint16_t>(wire::fault_bit(fault)); }

}  // namespace

void Firmware::receive() {
  uint8_t budget = kReceiveBudget;
  while (link_.receive(budget)) dispatch();
}

void Firmware::dispatch() {
  const Type type = static_cast<Type>(link_.type());
  switch (type) {
    case Type::kHelloRequest:
      return on_hello_request();
    case Type::kParameters: {
      wire::Parameters message;
      if (link_.read(message)) on_parameters(message);
      return;
    }
    case Type::kCommand: {
      wire::Command message;
      if (link_.read(message)) on_command(message);
      return;
    }
    case Type::kArm: {
      wire::Arm message;
      if (link_.read(message)) on_arm(message);
      return;
    }
    case Type::kDisarm: {
      wire::Disarm message;
      if (link_.read(message)) on_disarm(message);
      return;
    }
    case Type::kStop: {
      wire::Stop message;
      if (link_.read(message)) on_stop(message);
      return;
    }
    case Type::kSyncRequest: {
      wire::SyncRequest message;
      if (!link_.read(message)) return;
      const wire::SyncReply reply = {message.id, link_.received_us(), 0, link_.counts().corrupted(),
                                     hal_.missed_edges()};
      link_.post(reply);
      host_frame_us_ = link_.received_us();
      return;
    }
    default:
      link_.count_unknown();
  }
}

void Firmware::on_hello_request() {
  const uint32_t now_us = link_.received_us();
  // Accepted with any size: a host of another version still gets the hello, so that it can print
  // both.
  disarm("hello request", now_us);
  fail_safe_.unwatch();
  state_ = State::kParameters;
  host_frame_us_ = now_us;
  send_hello(now_us);
}

void Firmware::on_parameters(const wire::Parameters& parameters) {
  if (parameters.boot_nonce != boot_nonce_) {
    return acknowledge(Type::kParameters, parameters.token, Result::kWrongBoot, 0);
  }
  host_frame_us_ = link_.received_us();
  if (may_drive()) {
    return acknowledge(Type::kParameters, parameters.token, Result::kWrongState,
                       static_cast<uint16_t>(state_));
  }
  const uint8_t bad = bad_field(parameters);
  if (bad != 0) return acknowledge(Type::kParameters, parameters.token, Result::kOutOfRange, bad);
  const bool repeated = in_session() && parameters.token == parameters_.token;
  if (!repeated) {
    parameters_ = parameters;
    open_session();
  }
  acknowledge(Type::kParameters, parameters.token, Result::kAccepted, 0);
}

void Firmware::open_session() {
  gate_.open(boot_nonce_);
  history_.clear();
  left_.loop.restart();
  right_.loop.restart();
  state_ = faults_ != 0 ? State::kFaulted : State::kDisarmed;
  fail_safe_.watch(hal_.micros());
}

void Firmware::on_command(const wire::Command& command) {
  if (command.boot_nonce == boot_nonce_) host_frame_us_ = link_.received_us();
  if (!in_session()) return;
  const uint32_t now_us = hal_.micros();
  last_verdict_ = gate_.judge(command, now_us, history_, parameters_);
  if (last_verdict_ == Verdict::kAccepted) fail_safe_.fresh(now_us, gate_.life_us());
}

void Firmware::on_arm(const wire::Arm& arm) {
  uint16_t detail = 0;
  const Result result = try_to_arm(arm, detail);
  acknowledge(Type::kArm, arm.token, result, detail);
}

// An answer counts as the token's answer only once the token is known to be new: a delayed or
// repeated copy of the frame must not get another answer than the one that the host acted upon.
wire::Result Firmware::try_to_arm(const wire::Arm& arm, uint16_t& detail) {
  if (arm.boot_nonce != boot_nonce_) return Result::kWrongBoot;
  host_frame_us_ = link_.received_us();
  if (any_token_ && arm.token < last_token_) return Result::kStaleToken;
  if (!any_token_ || arm.token > last_token_) {
    any_token_ = true;
    last_token_ = arm.token;
    last_detail_ = 0;
    last_result_ = judge_arm(arm.expiry_us, last_detail_);
  }
  detail = last_detail_;
  return last_result_;
}

wire::Result Firmware::judge_arm(uint32_t expiry_us, uint16_t& detail) {
  const int32_t ahead_us = distance(expiry_us, hal_.micros());
  if (ahead_us <= 0 || ahead_us > kArmFurthestUs) {
    detail = kArmExpiryField;
    return Result::kOutOfRange;
  }
  // A trip that the timer has just latched must not be cleared unseen.
  check_trip();
  detail = persisting_causes();
  if (detail == 0 && !may_drive() && !enable()) detail = bit(Fault::command_timeout);
  return detail != 0 ? Result::kFaultPersists : Result::kAccepted;
}

bool Firmware::enable() {
  target_ = TrackSpeeds();
  left_.loop.reset();
  right_.loop.reset();
  left_.watch.reset();
  right_.watch.reset();
  mean_monitor_.reset();
  turn_monitor_.reset();
  if (!fail_safe_.enable()) return false;
  faults_ = 0;
  state_ = State::kArmed;
  return true;
}

uint16_t Firmware::persisting_causes() {
  if (!in_session()) return bit(Fault::parameters_missing);
  uint16_t causes = 0;
  if (!gate_.fresh(hal_.micros())) causes |= bit(Fault::command_timeout);
  if (uses_gyro(parameters_)) {
    if (imu_.missing()) causes |= bit(Fault::imu_missing);
    if (imu_.stale()) causes |= bit(Fault::imu_stale);
  }
  if (battery_.below()) causes |= bit(Fault::battery_low);
  return causes;
}

void Firmware::on_disarm(const wire::Disarm& request) {
  host_frame_us_ = link_.received_us();
  disarm("disarm", host_frame_us_);
  acknowledge(Type::kDisarm, request.token, Result::kAccepted, 0);
}

void Firmware::on_stop(const wire::Stop& stop) {
  host_frame_us_ = link_.received_us();
  latch(Fault::stop_requested, 0, host_frame_us_);
  acknowledge(Type::kStop, stop.token, Result::kAccepted, 0);
}

void Firmware::acknowledge(Type request, uint32_t token, Result result, uint16_t detail) {
  const wire::Acknowledge message = {static_cast<uint8_t>(request), token,
                                     static_cast<uint8_t>(result), detail};
  link_.post(message);
}

}  // namespace firmware
}  // namespace tp100
