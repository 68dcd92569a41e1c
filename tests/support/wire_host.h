#pragma once
// The host's side of the wire protocol, for tests of boards and of the firmware.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::test {

/// `message` as a frame, with its delimiter.
template <class Message>
std::vector<std::uint8_t> frame_of(const Message& message) {
  std::uint8_t payload[Message::kSize];
  wire::write_payload(message, payload);
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  frame.resize(wire::encode_frame(static_cast<std::uint8_t>(Message::kType), payload,
                                  Message::kSize, frame.data()));
  return frame;
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

/// Decodes and keeps what a robot sends.
class ReceivedFrames {
 public:
  std::vector<wire::Hello> hellos;
  std::vector<wire::Sample> samples;
  std::vector<wire::Acknowledge> acknowledges;
  std::vector<wire::SyncReply> sync_replies;
  std::vector<wire::FaultReport> reports;
  std::vector<std::string> logs;
  std::vector<wire::Log> log_messages;
  int bad_frames = 0;

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
      case wire::Type::kLog: {
        std::vector<wire::Log> one;
        if (!keep(one)) return false;
        std::string text;
        for (const std::uint8_t c : one.at(0).text) {
          if (c != 0) text.push_back(static_cast<char>(c));
        }
        logs.push_back(text);
        log_messages.push_back(one[0]);
        return true;
      }
      default:
        return false;
    }
  }

  wire::FrameDecoder decoder_;
};

}  // namespace tp100::test
