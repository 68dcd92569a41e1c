#pragma once
// The host's side of the wire protocol, for tests of boards and of the firmware.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::test {

/// A frame of any type with any payload, with its delimiter.
inline std::vector<std::uint8_t> frame_of(std::uint8_t type,
                                          std::span<const std::uint8_t> payload) {
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  frame.resize(wire::encode_frame(type, payload.data(), payload.size(), frame.data()));
  return frame;
}

/// `message` as a frame.
template <class Message>
std::vector<std::uint8_t> frame_of(const Message& message) {
  std::uint8_t payload[Message::kSize];
  wire::write_payload(message, payload);
  return frame_of(static_cast<std::uint8_t>(Message::kType), payload);
}

inline const float kGyroRadpsPerLsb = 0.0174532925f / wire::kGyroLsbPerDegps;

/// Parameters that every robot accepts. The caller sets `boot_nonce` and `token`.
inline wire::Parameters good_parameters() {
  wire::Parameters p{};
  p.boot_nonce = 0xB007;
  p.token = 1;
  p.counts_per_metre = 11140.0f;
  p.wheelbase_m = p.wheelbase_tight_m = p.wheelbase_spin_m = 0.274f;
  p.turn_slip_share = 1.0f;
  p.slip_left = 0.16f;
  p.slip_right = 0.10f;
  p.max_track_mps = 0.2f;
  p.max_track_mps2 = 0.6f;
  p.feed_forward = 4.0f;
  p.dead_band = 0.15f;
  p.speed_kp = 4.0f;
  p.speed_ki = 30.0f;
  p.yaw_kp = 4.0f;
  p.max_yaw_radps = 1.2f;
  p.gyro_z_radps_per_lsb = kGyroRadpsPerLsb;
  p.battery_cutoff_mv = 6000;
  p.stall_duty = 600;
  p.stall_ms = 1000;
  p.command_life_ms = 200;
  p.yaw_window_ms = 200;
  p.flags = wire::kUseGyro;
  return p;
}

inline std::string text_of(const wire::Log& log) {
  return {log.text, std::find(log.text, std::end(log.text), 0)};
}

/// Decodes and keeps what a robot sends.
class ReceivedFrames {
 public:
  std::vector<wire::Hello> hellos;
  std::vector<wire::Sample> samples;
  std::vector<wire::Acknowledge> acknowledges;
  std::vector<wire::SyncReply> sync_replies;
  std::vector<wire::FaultReport> reports;
  std::vector<wire::Log> logs;
  int bad_frames = 0;

  /// Number of texts that begin with `start`.
  auto count_logs(std::string_view start) const {
    return std::ranges::count_if(
        logs, [&](const wire::Log& log) { return text_of(log).starts_with(start); });
  }

 protected:
  /// Type of the message that ends with this byte and was kept.
  std::optional<wire::Type> receive(std::uint8_t byte) {
    const wire::DecodeResult received = decoder_.push(byte);
    if (received == wire::DecodeResult::kNothing) return std::nullopt;
    if (received == wire::DecodeResult::kFrame && keep()) return wire::Type{decoder_.type()};
    ++bad_frames;
    return std::nullopt;
  }
  /// Forgets the bytes of an unfinished frame.
  void restart() { decoder_.reset(); }

 private:
  template <class Message>
  bool keep(std::vector<Message>& list) {
    Message message{};
    if (!wire::read_payload(decoder_.payload(), decoder_.size(), message)) return false;
    list.push_back(message);
    return true;
  }
  bool keep() {
    switch (wire::Type{decoder_.type()}) {
      case wire::Type::kHello:
        return keep(hellos);
      case wire::Type::kSample:
        return keep(samples);
      case wire::Type::kAcknowledge:
        return keep(acknowledges);
      case wire::Type::kSyncReply:
        return keep(sync_replies);
      case wire::Type::kFaultReport:
        return keep(reports);
      case wire::Type::kLog:
        return keep(logs);
      default:
        return false;
    }
  }

  wire::FrameDecoder decoder_;
};

/// A host that follows the protocol; a derived class has the robot.
class WireHost : public ReceivedFrames {
 public:
  WireHost(const WireHost&) = delete;
  WireHost& operator=(const WireHost&) = delete;
  virtual ~WireHost() = default;
  virtual void send_bytes(const std::vector<std::uint8_t>& bytes) = 0;
  virtual void run(int ms) = 0;
  /// Present time of the robot's clock.
  virtual std::uint32_t device_us() const = 0;

  template <class Message>
  void send(const Message& message) {
    send_bytes(frame_of(message));
  }
  wire::Command command() {
    wire::Command c{};
    c.boot_nonce = nonce;
    c.sequence = ++sequence;
    c.answers = samples.empty() ? std::uint16_t{0} : samples.back().sequence;
    c.yaw_rad = yaw_rad;
    c.desired_yaw_rad = desired_yaw_rad;
    c.yaw_rate_radps = yaw_rate_radps;
    c.speed_mps = speed_mps;
    c.expiry_us = device_us() + 195'000;
    return c;
  }
  wire::Arm arm_message() { return {nonce, ++token, device_us() + 200'000}; }
  /// Begins a session: parameters are accepted and samples arrive.
  void connect() {
    send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    run(answer_ms_);
    parameters.boot_nonce = nonce;
    parameters.token = ++token;
    send(parameters);
    run(settle_ms_);
  }
  wire::Acknowledge arm() {
    send(arm_message());
    run(answer_ms_);
    return acknowledges.empty() ? wire::Acknowledge{} : acknowledges.back();
  }
  /// Connects and streams commands, so that the robot may be armed.
  void be_ready() {
    connect();
    streams = true;
    run(settle_ms_);
  }
  /// Also arms; the commands request `speed`.
  void drive(float speed = 0.1f) {
    be_ready();
    arm();
    speed_mps = speed;
    run(drive_ms_);
  }

  wire::Parameters parameters = good_parameters();
  std::uint32_t nonce = 0;  ///< of the robot's boot
  bool streams = false;     ///< sends commands
  float speed_mps = 0.0f;
  float yaw_rate_radps = 0.0f;
  float yaw_rad = 0.0f;  ///< as the host estimates it
  float desired_yaw_rad = 0.0f;
  std::uint16_t sequence = 100;
  std::uint32_t token = 10;

 protected:
  /// How long the robot takes to answer, for a few samples, and to move.
  WireHost(int answer_ms, int settle_ms, int drive_ms)
      : answer_ms_(answer_ms), settle_ms_(settle_ms), drive_ms_(drive_ms) {}

 private:
  int answer_ms_, settle_ms_, drive_ms_;
};

}  // namespace tp100::test
