#pragma once
// A robot that follows the protocol unless a test disables parts of it. It uses virtual time and no
// port.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../support/wire_host.h"
#include "core/time.h"

namespace tp100 {

using test::frame_of;

class ScriptedRobot {
 public:
  // Received frames, by kind.
  struct Received {
    std::vector<wire::HelloRequest> hello_requests;
    std::vector<wire::Parameters> parameters;
    std::vector<wire::Command> commands;
    std::vector<wire::Arm> arms;
    std::vector<wire::Disarm> disarms;
    std::vector<wire::Stop> stops;
    std::vector<std::uint8_t> types;  // of all frames, in order
    int sync_requests = 0;
    int bad_frames = 0;
  };

  // Settings of the robot's behaviour.
  std::uint16_t protocol = wire::kProtocolVersion;
  std::uint32_t schema = wire::kSchemaHash;
  std::uint8_t board = static_cast<std::uint8_t>(wire::BoardType::kNative);
  std::uint32_t boot_nonce = 0xB007;
  bool answers_parameters = true;
  bool answers_requests = true;
  bool answers_sync = true;
  bool samples = true;
  bool silent = false;
  wire::Result parameters_result = wire::Result::kAccepted;
  wire::Result arm_result = wire::Result::kAccepted;
  std::uint32_t device_offset_us = 0;
  double metres_per_s = 0.0;
  bool drives = false;  // straight ahead at the commanded speed

  Received received;
  wire::State state = wire::State::kHello;
  std::uint16_t sequence = 0;
  std::uint16_t faults = 0;
  std::uint16_t corrupted = 0;  // number of frames that it reports as corrupted
  std::uint16_t missed_edges = 0;

  explicit ScriptedRobot(HostNs boot_ns = 0) : boot_ns_(boot_ns) {}

  void reboot(HostNs now) {
    ++boot_nonce;
    boot_ns_ = now;
    state = wire::State::kHello;
    sequence = 0;
    next_hello_ns_ = next_sample_ns_ = now;
    out_.clear();
  }

  std::uint32_t device_us(HostNs now) const {
    return device_offset_us + static_cast<std::uint32_t>((now - boot_ns_) / kNsPerUs);
  }

  template <class Message>
  void send(const Message& message) {
    const auto frame = frame_of(message);
    out_.insert(out_.end(), frame.begin(), frame.end());
  }
  void say_hello() {
    const auto now_state = static_cast<std::uint8_t>(state);
    send(wire::Hello{protocol, {0, 1, 0}, schema, board, boot_nonce, 0, now_state, faults});
  }
  wire::Sample sample(HostNs now) const {
    wire::Sample sample{};
    sample.sequence = sequence;
    sample.device_us = device_us(now);
    const double distance_m = driven_m_ + metres_per_s * to_s(now - boot_ns_);
    const auto counts = static_cast<std::int32_t>(distance_m * 11140.0);
    sample.left_counts = sample.right_counts = counts;
    sample.accel[2] = 8192;
    sample.battery_mv = 7900;
    sample.state = static_cast<std::uint8_t>(state);
    sample.faults = faults;
    sample.last_command =
        received.commands.empty() ? std::uint16_t{0} : received.commands.back().sequence;
    return sample;
  }

  /// Advances the robot to `now` and sends its unrequested frames.
  void tick(HostNs now) {
    if (drives && state >= wire::State::kArmed && state <= wire::State::kRunning &&
        !received.commands.empty())
      driven_m_ += static_cast<double>(received.commands.back().speed_mps) * to_s(now - ticked_ns_);
    ticked_ns_ = now;
    if (silent) return;
    if (state == wire::State::kHello && now >= next_hello_ns_) {
      say_hello();
      next_hello_ns_ = now + wire::kHelloPeriodMs * kNsPerMs;
    }
    if (samples && state >= wire::State::kDisarmed && now >= next_sample_ns_) {
      send(sample(now));
      ++sequence;
      next_sample_ns_ = now + wire::kSamplePeriodUs * kNsPerUs;
    }
  }

  void receive(std::span<const std::uint8_t> bytes, HostNs now) {
    for (const std::uint8_t byte : bytes) {
      const wire::DecodeResult result = decoder_.push(byte);
      if (result == wire::DecodeResult::kFrame) {
        on_frame(now);
      } else if (result != wire::DecodeResult::kNothing) {
        ++received.bad_frames;
      }
    }
  }

  std::vector<std::uint8_t> take() {
    std::vector<std::uint8_t> out;
    out.swap(out_);
    return out;
  }

 private:
  template <class Message>
  Message read() const {
    Message message{};
    if (!wire::read_payload(decoder_.payload(), decoder_.size(), message)) std::abort();
    return message;
  }
  void acknowledge(wire::Type type, std::uint32_t token, wire::Result result) {
    if (!silent) {
      send(wire::Acknowledge{static_cast<std::uint8_t>(type), token,
                             static_cast<std::uint8_t>(result), 0});
    }
  }
  /// Takes a request, which leads a robot in a session to the state `next` if it is accepted.
  template <class Message>
  void on_request(std::vector<Message>& list, wire::Result result, wire::State next) {
    list.push_back(read<Message>());
    if (!answers_requests) return;
    if (result == wire::Result::kAccepted && state >= wire::State::kDisarmed) state = next;
    acknowledge(Message::kType, list.back().token, result);
  }
  void on_frame(HostNs now) {
    received.types.push_back(decoder_.type());
    switch (wire::Type{decoder_.type()}) {
      case wire::Type::kHelloRequest:
        received.hello_requests.push_back(read<wire::HelloRequest>());
        state = wire::State::kParameters;
        if (!silent) say_hello();
        return;
      case wire::Type::kParameters:
        received.parameters.push_back(read<wire::Parameters>());
        if (!answers_parameters) return;
        if (parameters_result == wire::Result::kAccepted) {
          state = wire::State::kDisarmed;
          next_sample_ns_ = now;
        }
        return acknowledge(wire::Type::kParameters, received.parameters.back().token,
                           parameters_result);
      case wire::Type::kCommand:
        received.commands.push_back(read<wire::Command>());
        return;
      case wire::Type::kArm:
        return on_request(received.arms, arm_result, wire::State::kArmed);
      case wire::Type::kDisarm:
        return on_request(received.disarms, wire::Result::kAccepted, wire::State::kDisarmed);
      case wire::Type::kStop:
        return on_request(received.stops, wire::Result::kAccepted, wire::State::kFaulted);
      case wire::Type::kSyncRequest: {
        ++received.sync_requests;
        const auto request = read<wire::SyncRequest>();
        if (answers_sync && !silent) {
          send(
              wire::SyncReply{request.id, device_us(now), device_us(now), corrupted, missed_edges});
        }
        return;
      }
      default:
        return;
    }
  }

  HostNs boot_ns_;
  HostNs ticked_ns_ = 0;
  double driven_m_ = 0.0;
  HostNs next_hello_ns_ = 0;
  HostNs next_sample_ns_ = 0;
  wire::FrameDecoder decoder_;
  std::vector<std::uint8_t> out_;
};

}  // namespace tp100
