#include "firmware.h"

#include <string.h>

#include "number.h"
#include "parameters.h"
#include "version.h"

namespace tp100 {
namespace firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;

const uint8_t kSampleTicks = wire::kSamplePeriodUs / 1000;

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

uint16_t bit(Fault fault) { return static_cast<uint16_t>(wire::fault_bit(fault)); }

}  // namespace

Firmware::Firmware(Hal& hal)
    : hal_(hal),
      fail_safe_(hal),
      link_(hal),
      imu_(hal),
      left_(),
      right_(),
      target_(),
      parameters_(),
      state_(State::kHello),
      faults_(0),
      boot_nonce_(0),
      last_verdict_(Verdict::kAccepted),
      any_token_(false),
      last_token_(0),
      last_result_(Result::kAccepted),
      last_detail_(0),
      sequence_(0),
      sampled_ticks_(0),
      sampled_us_(0),
      host_frame_us_(0),
      hello_us_(0) {}

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
  log(0, "boot, reset: ", kResetNames[static_cast<uint8_t>(cause)], now_us);
  hal_.kick_watchdog();
  imu_.start();
}

void Firmware::loop() {
  fail_safe_.beat();
  hal_.kick_watchdog();
  check_trip();
  receive();
  const uint8_t ticks = fail_safe_.ticks();
  const uint8_t late = static_cast<uint8_t>(ticks - sampled_ticks_);
  if (late >= kSampleTicks) {
    const bool skipped = late >= 2 * kSampleTicks;
    sampled_ticks_ = skipped ? ticks : static_cast<uint8_t>(sampled_ticks_ + kSampleTicks);
    take_sample();
  }
  check_host(hal_.micros());
  link_.flush();
  hal_.idle();
}

void Firmware::disarm(const char* reason, uint32_t at_us) {
  fail_safe_.disable();
  left_.loop.reset();
  right_.loop.reset();
  left_.duty = 0;
  right_.duty = 0;
  if (!may_drive()) return;
  state_ = State::kDisarmed;
  log(0, "motors off: ", reason, at_us);
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
  if (distance(now_us, host_frame_us_) < wire::kHostSilenceMs * 1000L) return;
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

void Firmware::log(uint8_t level, const char* text, const char* more, uint32_t at_us) {
  wire::Log message = {};
  message.device_us = at_us;
  message.level = level;
  uint8_t at = 0;
  for (; *text != 0 && at < wire::Log::kTextSize; ++text)
    message.text[at++] = static_cast<uint8_t>(*text);
  for (; *more != 0 && at < wire::Log::kTextSize; ++more)
    message.text[at++] = static_cast<uint8_t>(*more);
  link_.post(message);
}

}  // namespace firmware
}  // namespace tp100
