#include "firmware.h"

#include <string.h>

#include "parameters.h"
#include "shared/number.h"
#include "version.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::wrapped_difference;
using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

const uint16_t kLongestStepUs = 50000;
const uint16_t kShortestStepUs = 1000;
const int32_t kArmFurthestUs = 500000;
const uint16_t kArmExpiryField = 2;

const char* const kResetNames[] = {"unknown", "power-on", "external", "brown-out", "watchdog"};

const char* name_of(Fault fault) {
  switch (fault) {
#define TP100_FAULT_NAME(bit, name, cause, fix) \
  case Fault::name:                             \
    return #name;
    TP100_ROBOT_FAULTS(TP100_FAULT_NAME)
#undef TP100_FAULT_NAME
    default:
      return "";
  }
}

}  // namespace

Firmware::Firmware(Hal& hal)
    : hal_(hal), fail_safe_(hal), link_(hal), imu_(hal), tracks_(hal, fail_safe_, parameters_) {}

void Firmware::setup() {
  fail_safe_.disable();
  boot_nonce_ = hal_.boot_nonce();
  if (boot_nonce_ == 0) boot_nonce_ = 1;
  gate_.open(boot_nonce_);
  const uint32_t now_us = hal_.micros();
  const wire::ResetCause cause = hal_.reset_cause();
  // A restart may have cut off a frame on the line: a delimiter keeps it apart from the first
  // report.
  hal_.uart_write(&wire::kDelimiter, 1);
  if (cause == wire::ResetCause::kWatchdog) latch(Fault::watchdog_reset, 0, now_us);
  if (cause == wire::ResetCause::kBrownOut) latch(Fault::brown_out, 0, now_us);
  send_hello(now_us);
  link_.log(0, "boot, reset: ", kResetNames[static_cast<uint8_t>(cause)], now_us);
  hal_.kick_watchdog();
  imu_.start();
}

void Firmware::loop() {
  fail_safe_.beat();
  hal_.kick_watchdog();
  check_trip();
  receive();
  if (sample_due()) {
    const uint8_t ticks = fail_safe_.ticks();
    const uint8_t late = static_cast<uint8_t>(ticks - sampled_ticks_);
    const uint8_t dt_ms = late >= 2 * kSampleTicks ? late : kSampleTicks;
    sampled_ticks_ = static_cast<uint8_t>(sampled_ticks_ + dt_ms);
    take_sample(dt_ms);
  }
  check_host(hal_.micros());
  link_.flush();
  hal_.idle();
}

void Firmware::receive() {
  uint8_t budget = HostLink::kMostReceived;
  while (link_.receive(budget)) dispatch();
}

void Firmware::dispatch() {
  switch (static_cast<Type>(link_.type())) {
    case Type::kHelloRequest:
      return on_hello_request();
    case Type::kParameters:
      return take<wire::Parameters>();
    case Type::kCommand:
      return take<wire::Command>();
    case Type::kArm:
      return take<wire::Arm>();
    case Type::kDisarm:
      return take<wire::Disarm>();
    case Type::kStop:
      return take<wire::Stop>();
    case Type::kSyncRequest:
      return take<wire::SyncRequest>();
    default:
      link_.count_unknown();
  }
}

template <class Message>
void Firmware::take() {
  Message message;
  if (link_.read(message)) on(message);
}

void Firmware::on_hello_request() {
  const uint32_t now_us = link_.received_us();
  // Accepted with any payload size: a host of another version still gets the hello, so that it can
  // report both versions.
  disarm("hello request", now_us);
  fail_safe_.unwatch();
  state_ = State::kParameters;
  host_frame_us_ = now_us;
  send_hello(now_us);
}

void Firmware::on(const wire::Parameters& parameters) {
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
  tracks_.restart();
  state_ = faults_ != 0 ? State::kFaulted : State::kDisarmed;
  fail_safe_.watch(hal_.micros());
}

void Firmware::on(const wire::Command& command) {
  if (command.boot_nonce == boot_nonce_) host_frame_us_ = link_.received_us();
  if (!in_session()) return;
  const uint32_t now_us = hal_.micros();
  last_verdict_ = gate_.judge(command, now_us, history_, parameters_);
  if (last_verdict_ == Verdict::kAccepted) fail_safe_.fresh(now_us, gate_.life_us());
}

void Firmware::on(const wire::Arm& arm) {
  uint16_t detail = 0;
  const Result result = try_to_arm(arm, detail);
  acknowledge(Type::kArm, arm.token, result, detail);
}

// Judges each new token once, stores the result and repeats it for copies of the frame: a delayed
// or repeated copy must not get a different answer from the one that the host acted upon.
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
  const int32_t ahead_us = wrapped_difference(expiry_us, hal_.micros());
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
  tracks_.begin();
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

void Firmware::on(const wire::Disarm& request) {
  host_frame_us_ = link_.received_us();
  disarm("disarm", host_frame_us_);
  acknowledge(Type::kDisarm, request.token, Result::kAccepted, 0);
}

void Firmware::on(const wire::Stop& stop) {
  host_frame_us_ = link_.received_us();
  latch(Fault::stop_requested, 0, host_frame_us_);
  acknowledge(Type::kStop, stop.token, Result::kAccepted, 0);
}

void Firmware::on(const wire::SyncRequest& request) {
  host_frame_us_ = link_.received_us();
  const wire::SyncReply reply = {request.id, host_frame_us_, 0, link_.counts().corrupted(),
                                 hal_.missed_edges()};
  link_.post(reply);
}

void Firmware::acknowledge(Type request, uint32_t token, Result result, uint16_t detail) {
  const wire::Acknowledge message = {static_cast<uint8_t>(request), token,
                                     static_cast<uint8_t>(result), detail};
  link_.post(message);
}

void Firmware::take_sample(uint8_t dt_ms) {
  const uint32_t now_us = tracks_.read();
  const uint32_t measured_us = now_us - sampled_us_;
  const bool usable = measured_us >= kShortestStepUs && measured_us <= kLongestStepUs;
  const uint16_t dt_us = usable ? static_cast<uint16_t>(measured_us) : kLongestStepUs;
  sampled_us_ = now_us;
  imu_.update();
  battery_.update(hal_.battery_mv(), parameters_.battery_cutoff_mv);
  if (!in_session()) return;
  ++sequence_;
  history_.add(sequence_, now_us, imu_.values().gyro[2], tracks_.left().counts,
               tracks_.right().counts);
  check_sensors(now_us);
  if (state_ != State::kRunning && imu_.fresh()) tracks_.rest(imu_.values().accel[0]);
  send_sample(now_us);
  drive(now_us, dt_us, dt_ms);
}

void Firmware::check_sensors(uint32_t now_us) {
  if (uses_gyro(parameters_)) {
    if (imu_.missing()) latch(Fault::imu_missing, imu_.errors(), now_us);
    if (imu_.stale()) latch(Fault::imu_stale, imu_.errors(), now_us);
  }
  if (battery_.low()) latch(Fault::battery_low, battery_.millivolts(), now_us);
}

void Firmware::send_sample(uint32_t now_us) {
  const ImuValues& imu = imu_.values();
  wire::Sample sample = {};
  sample.sequence = sequence_;
  sample.device_us = now_us;
  sample.left_counts = tracks_.left().counts;
  sample.right_counts = tracks_.right().counts;
  memcpy(sample.gyro, imu.gyro, sizeof sample.gyro);
  memcpy(sample.accel, imu.accel, sizeof sample.accel);
  sample.temperature = imu.temperature;
  sample.battery_mv = battery_.millivolts();
  sample.left_duty = tracks_.left().duty;
  sample.right_duty = tracks_.right().duty;
  sample.state = static_cast<uint8_t>(state_);
  sample.faults = faults_;
  sample.last_command = gate_.last_sequence();
  sample.imu_age = imu_.age();
  link_.post(sample);
}

void Firmware::drive(uint32_t now_us, uint16_t dt_us, uint8_t dt_ms) {
  tracks_.measure(history_);
  if (!may_drive()) return;
  latch(tracks_.check(dt_ms), now_us);
  check_turn(now_us);
  if (may_drive()) follow(now_us, dt_us);
}

void Firmware::check_turn(uint32_t now_us) {
  if (state_ != State::kRunning || !uses_gyro(parameters_) || !imu_.fresh()) {
    return tracks_.forget_turn();
  }
  latch(tracks_.check_turn(history_.newest(), imu_.values().accel[0],
                           gate_.current().gyro_bias_radps),
        now_us);
}

void Firmware::latch(const Tracks::Verdicts& found, uint32_t at_us) {
  if (found.left == TrackMonitor::kStalled) latch(Fault::stalled_left, tracks_.left().duty, at_us);
  if (found.left == TrackMonitor::kReversed)
    latch(Fault::reversed_left, tracks_.left().duty, at_us);
  if (found.right == TrackMonitor::kStalled)
    latch(Fault::stalled_right, tracks_.right().duty, at_us);
  if (found.right == TrackMonitor::kReversed)
    latch(Fault::reversed_right, tracks_.right().duty, at_us);
}

void Firmware::follow(uint32_t now_us, uint16_t dt_us) {
  const wire::Command& command = gate_.current();
  const bool standstill = command.speed_mps == 0.0f && command.yaw_rate_radps == 0.0f &&
                          command.desired_yaw_rad == command.yaw_rad;
  if (standstill || !gate_.fresh(now_us)) {
    if (state_ != State::kArmed) tracks_.drive(0.0f, 0.0f, dt_us);
    return;
  }
  state_ = State::kRunning;
  const bool use_gyro = uses_gyro(parameters_) && imu_.fresh();
  const float turned_rad =
      turned(gate_.answered(), history_.newest(), use_gyro, command.gyro_bias_radps, parameters_);
  const float error_rad = command.desired_yaw_rad - command.yaw_rad - turned_rad;
  const float rate_radps = turn_rate(error_rad, command.yaw_rate_radps, parameters_);
  tracks_.drive(command.speed_mps, rate_radps, dt_us);
}

void Firmware::disarm(const char* reason, uint32_t at_us) {
  tracks_.stop();
  if (!may_drive()) return;
  state_ = State::kDisarmed;
  link_.log(0, "motors off: ", reason, at_us);
}

void Firmware::latch(Fault fault, int32_t detail, uint32_t at_us) {
  disarm(name_of(fault), at_us);
  if (in_session()) state_ = State::kFaulted;
  if ((faults_ & bit(fault)) != 0) return;
  faults_ = static_cast<uint16_t>(faults_ | bit(fault));
  const wire::FaultReport report = {at_us, static_cast<uint8_t>(fault), faults_, detail};
  link_.post(report);
}

void Firmware::check_trip() {
  const Trip trip = fail_safe_.take_trip();
  if ((trip.faults & bit(Fault::loop_hung)) != 0) latch(Fault::loop_hung, kLoopLimitMs, trip.at_us);
  if ((trip.faults & bit(Fault::command_timeout)) != 0) {
    latch(Fault::command_timeout, trip.silence_ms, trip.at_us);
  }
}

void Firmware::check_host(uint32_t now_us) {
  if (state_ == State::kHello) {
    if (now_us - hello_us_ >= wire::kHelloPeriodMs * 1000UL) send_hello(now_us);
    return;
  }
  if (wrapped_difference(now_us, host_frame_us_) < wire::kHostSilenceMs * 1000L) return;
  disarm("host silent", now_us);
  fail_safe_.unwatch();
  state_ = State::kHello;
  send_hello(now_us);
}

void Firmware::send_hello(uint32_t now_us) {
  hello_us_ = now_us;
  const wire::Hello hello = {wire::kProtocolVersion,
                             {kVersionMajor, kVersionMinor, kVersionPatch},
                             wire::kSchemaHash,
                             static_cast<uint8_t>(hal_.board()),
                             boot_nonce_,
                             static_cast<uint8_t>(hal_.reset_cause()),
                             static_cast<uint8_t>(state_),
                             faults_};
  link_.post(hello);
}

}  // namespace firmware
}  // namespace tp100
