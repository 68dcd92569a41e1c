#include "sim/faults/frame_faults.h"

#include <array>
#include <cmath>

#include "core/time.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

constexpr std::size_t kKept = 200;

/// Changes a message of one type; others stay as they are.
template <class Message, class Change>
void change(std::uint8_t type, std::vector<std::uint8_t>& payload, const Change& how) {
  Message message{};
  if (type != static_cast<std::uint8_t>(Message::kType) ||
      !wire::read_payload(payload.data(), payload.size(), message))
    return;
  how(message);
  wire::write_payload(message, payload.data());
}

}  // namespace

FrameFaults::FrameFaults(const std::vector<PlannedFault>& faults) {
  for (const PlannedFault& fault : faults) faults_.push_back({.fault = fault});
}

std::vector<TimedByte> FrameFaults::pass(std::span<const TimedByte> bytes, HostNs until_ns) {
  if (faults_.empty()) return {bytes.begin(), bytes.end()};
  std::vector<TimedByte> out;
  for (const TimedByte& byte : bytes) {
    frame_.push_back(byte);
    const wire::DecodeResult received = decoder_.push(byte.value);
    if (byte.value != wire::kDelimiter && received != wire::DecodeResult::kOversize) continue;
    finish(received, out);
    frame_.clear();
  }
  for (const Held& held : held_)
    if (held.due_ns <= until_ns) out.insert(out.end(), held.frame.begin(), held.frame.end());
  std::erase_if(held_, [&](const Held& held) { return held.due_ns <= until_ns; });
  return out;
}

void FrameFaults::finish(wire::DecodeResult received, std::vector<TimedByte>& out) {
  const auto give = [&](const std::vector<TimedByte>& frame) {
    out.insert(out.end(), frame.begin(), frame.end());
  };
  if (received != wire::DecodeResult::kFrame) return give(frame_);
  const HostNs at_ns = frame_.back().at_ns;
  const std::uint8_t type = decoder_.type();
  std::vector<std::uint8_t> payload(decoder_.payload(), decoder_.payload() + decoder_.size());
  const bool sync = type == static_cast<std::uint8_t>(wire::Type::kSyncReply);
  double late_ms = 0.0;
  int copies = 1;
  for (Planned& planned : faults_) {
    if (!planned.fault.active(at_ns)) continue;
    edit(planned, type, payload);
    if (sync && planned.fault.kind == fault_kind("sync-late")) late_ms = planned.fault.number;
    if (sync && planned.fault.kind == fault_kind("sync-twice")) copies = 2;
  }
  const std::vector<TimedByte> frame = coded(type, payload, at_ns);
  if (late_ms > 0.0) {
    held_.push_back({at_ns + from_s(late_ms * 1e-3), frame});
  } else {
    for (int i = 0; i < copies; ++i) give(frame);
  }
  for (const Planned& planned : faults_) {
    if (!planned.fault.active(at_ns)) continue;
    const auto number = static_cast<std::size_t>(planned.fault.number);
    if (planned.fault.kind == fault_kind("unknown-message"))
      give(coded(static_cast<std::uint8_t>(number), payload, at_ns));
    if (planned.fault.kind == fault_kind("replay") && sent_.size() >= number) {
      std::vector<TimedByte> old = sent_[sent_.size() - number];
      for (TimedByte& byte : old) byte.at_ns = at_ns;
      give(old);
    }
  }
  sent_.push_back(frame);
  if (sent_.size() > kKept) sent_.pop_front();
}

void FrameFaults::edit(Planned& planned, std::uint8_t type, std::vector<std::uint8_t>& payload) {
  const double number = planned.fault.number;
  switch (planned.fault.kind) {
    case fault_kind("version"):
      return change<wire::Hello>(type, payload, [&](wire::Hello& hello) {
        hello.protocol = static_cast<std::uint16_t>(number);
      });
    case fault_kind("schema"):
      return change<wire::Hello>(type, payload, [](wire::Hello& hello) { hello.schema ^= 1; });
    case fault_kind("board"):
      return change<wire::Hello>(type, payload, [&](wire::Hello& hello) {
        hello.board = static_cast<std::uint8_t>(number);
      });
    case fault_kind("clock-step"): {
      const auto by_us = static_cast<std::uint32_t>(std::llround(number * 1e3));
      change<wire::Sample>(type, payload, [&](wire::Sample& sample) { sample.device_us += by_us; });
      return change<wire::SyncReply>(type, payload, [&](wire::SyncReply& reply) {
        reply.received_us += by_us;
        reply.sent_us += by_us;
      });
    }
    case fault_kind("sequence"):
      return change<wire::Sample>(type, payload, [&](wire::Sample& sample) {
        if (!planned.began) planned.first_sequence = sample.sequence;
        planned.began = true;
        sample.sequence = static_cast<std::uint16_t>(sample.sequence - planned.first_sequence);
      });
    default:
      return;
  }
}

std::vector<TimedByte> FrameFaults::coded(std::uint8_t type, std::span<const std::uint8_t> payload,
                                          HostNs at_ns) {
  std::array<std::uint8_t, wire::kMaxFrame> bytes{};
  const std::size_t size = wire::encode_frame(type, payload.data(), payload.size(), bytes.data());
  std::vector<TimedByte> frame;
  for (std::size_t i = 0; i < size; ++i) frame.push_back({at_ns, bytes[i]});
  return frame;
}

}  // namespace tp100::sim
