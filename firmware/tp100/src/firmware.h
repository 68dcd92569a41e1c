// The firmware: one object, no globals, so that several robots live in one process on the host.
#ifndef TP100_FIRMWARE_FIRMWARE_H
#define TP100_FIRMWARE_FIRMWARE_H

#include "battery.h"
#include "command_gate.h"
#include "fail_safe.h"
#include "host_link.h"
#include "imu.h"
#include "tracks.h"

namespace tp100 {
namespace firmware {

class Firmware {
 public:
  explicit Firmware(Hal& hal);
  /// Call once, before the timer interrupt runs.
  void setup();
  /// Call repeatedly; returns within a few milliseconds whatever happens outside.
  void loop();
  /// Runs in the timer interrupt, every millisecond; other interrupts may interrupt it. True: the
  /// loop has work, because a sample is due, the motors were switched off, or messages wait.
  bool tick_1khz() {
    fail_safe_.tick();
    return sample_due() || fail_safe_.tripped() || link_.waiting();
  }

  wire::State state() const { return state_; }
  uint16_t faults() const { return faults_; }
  const LinkCounts& link_counts() const { return link_.counts(); }
  /// Verdict on the last command.
  Verdict last_verdict() const { return last_verdict_; }

 private:
  static const uint8_t kSampleTicks = wire::kSamplePeriodUs / 1000;

  void receive();
  void dispatch();
  /// Handles the received frame as a Message.
  template <class Message>
  void take();
  void on_hello_request();
  void on(const wire::Parameters& parameters);
  void on(const wire::Command& command);
  void on(const wire::Arm& arm);
  void on(const wire::Disarm& disarm);
  void on(const wire::Stop& stop);
  void on(const wire::SyncRequest& request);
  void acknowledge(wire::Type request, uint32_t token, wire::Result result, uint16_t detail);

  wire::Result try_to_arm(const wire::Arm& arm, uint16_t& detail);
  /// Judges an arm request whose token is new.
  wire::Result judge_arm(uint32_t expiry_us, uint16_t& detail);
  uint16_t persisting_causes();
  bool enable();
  void open_session();
  void disarm(const char* reason, uint32_t at_us);
  void latch(wire::Fault fault, int32_t detail, uint32_t at_us);
  void latch(const Tracks::Verdicts& found, uint32_t at_us);
  void check_trip();
  void check_sensors(uint32_t now_us);
  void check_turn(uint32_t now_us);
  void check_host(uint32_t now_us);

  void take_sample(uint8_t dt_ms);
  void send_sample(uint32_t now_us);
  void drive(uint32_t now_us, uint16_t dt_us, uint8_t dt_ms);
  /// Follows the current command while it is fresh.
  void follow(uint32_t now_us, uint16_t dt_us);

  void send_hello(uint32_t now_us);
  bool sample_due() const {
    return static_cast<uint8_t>(fail_safe_.ticks() - sampled_ticks_) >= kSampleTicks;
  }
  bool in_session() const { return state_ >= wire::State::kDisarmed; }
  bool may_drive() const {
    return state_ == wire::State::kArmed || state_ == wire::State::kRunning;
  }

  Hal& hal_;
  FailSafe fail_safe_;
  HostLink link_;
  Imu imu_;
  Battery battery_;
  TurnHistory history_;
  CommandGate gate_;
  wire::Parameters parameters_ = {};
  Tracks tracks_;

  wire::State state_ = wire::State::kHello;
  uint16_t faults_ = 0;
  uint32_t boot_nonce_ = 0;
  Verdict last_verdict_ = Verdict::kAccepted;

  bool any_token_ = false;
  uint32_t last_token_ = 0;
  wire::Result last_result_ = wire::Result::kAccepted;
  uint16_t last_detail_ = 0;

  uint16_t sequence_ = 0;
  volatile uint8_t sampled_ticks_ = 0;
  uint32_t sampled_us_ = 0;
  uint32_t host_frame_us_ = 0;
  uint32_t hello_us_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
