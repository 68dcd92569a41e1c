#include "sim/faults/byte_faults.h"

#include <algorithm>

#include "core/time.h"
#include "wire/frame.h"

namespace tp100::sim {
namespace {

// Bytes that remain of a truncated frame.
constexpr std::size_t kStump = 8;
constexpr std::string_view kChatterText = "AT\r\nATE0Q0V1\r\n~~ Mega 2560 ready ~~\r\n";

HostNs ns_of_ms(double ms) { return from_s(ms * 1e-3); }

}  // namespace

ByteFaults::ByteFaults(const std::vector<PlannedFault>& faults, HostNs spacing_ns,
                       std::uint64_t seed)
    : spacing_ns_(spacing_ns), random_(seed) {
  for (const PlannedFault& fault : faults) faults_.push_back({fault, fault.begin_ns});
}

std::vector<TimedByte> ByteFaults::pass(std::span<const TimedByte> bytes, HostNs until_ns) {
  for (const TimedByte& byte : bytes) carry(byte);
  speak(until_ns);
  std::vector<TimedByte> arrived;
  while (!on_the_way_.empty() && on_the_way_.front().at_ns <= until_ns) {
    arrived.push_back(on_the_way_.front());
    on_the_way_.pop_front();
  }
  return arrived;
}

void ByteFaults::carry(TimedByte byte) {
  const bool ends = byte.value == wire::kDelimiter;
  if (in_frame_++ == 0) {
    frame_late_ns_ = 0;
    for (Planned& planned : faults_) {
      planned.hits_frame =
          planned.fault.active(byte.at_ns) && random_share() < planned.fault.number;
      if (planned.fault.kind == fault_kind("jitter") && planned.fault.active(byte.at_ns))
        frame_late_ns_ = ns_of_ms(random_share() * planned.fault.number);
    }
  }
  bool lost = false;
  int copies = 1;
  HostNs at_ns = byte.at_ns + frame_late_ns_;
  for (Planned& planned : faults_) {
    const FaultKind kind = planned.fault.kind;
    at_ns = late(planned, at_ns);
    if (!planned.fault.active(byte.at_ns)) continue;
    lost = !corruption(planned, byte) || lost;
    if (kind == fault_kind("duplicate") && random_share() < planned.fault.number) ++copies;
    if (kind == fault_kind("insert") && random_share() < planned.fault.number)
      put({at_ns, random_byte()});
  }
  for (int i = 0; i < copies && !lost; ++i) put({at_ns, byte.value});
  if (ends) in_frame_ = 0;
}

bool ByteFaults::corruption(Planned& planned, TimedByte& byte) {
  switch (planned.fault.kind) {
    case fault_kind("flip"):
      if (random_share() < planned.fault.number)
        byte.value = static_cast<std::uint8_t>(byte.value ^ (1U << (random_byte() & 7U)));
      return true;
    case fault_kind("delimiter"):
      if (random_share() < planned.fault.number) byte.value = wire::kDelimiter;
      return true;
    case fault_kind("drop"):
      return random_share() >= planned.fault.number;
    case fault_kind("truncate"):
      return !planned.hits_frame || in_frame_ <= kStump || byte.value == wire::kDelimiter;
    case fault_kind("fuse"):
      return !planned.hits_frame || byte.value != wire::kDelimiter;
    case fault_kind("cut"):
      return false;
    default:
      return true;
  }
}

HostNs ByteFaults::late(const Planned& planned, HostNs at_ns) const {
  const PlannedFault& fault = planned.fault;
  if (!fault.active(at_ns)) return at_ns;
  switch (fault.kind) {
    case fault_kind("delay"):
      return at_ns + ns_of_ms(fault.number);
    case fault_kind("batch"): {
      const HostNs period_ns = ns_of_ms(fault.number);
      return (at_ns + period_ns - 1) / period_ns * period_ns;
    }
    case fault_kind("stall"):
      return std::max(at_ns, fault.begin_ns + ns_of_ms(fault.number));
    default:
      return at_ns;
  }
}

void ByteFaults::speak(HostNs until_ns) {
  for (Planned& planned : faults_) {
    const PlannedFault& fault = planned.fault;
    if (planned.next_ns > until_ns || !fault.active(planned.next_ns)) continue;
    if (fault.kind == fault_kind("noise")) {
      const auto count = static_cast<std::int64_t>(fault.number);
      for (std::int64_t i = 0; i < count; ++i) put({planned.next_ns, random_byte()});
      planned.next_ns = fault.end_ns;
    } else if (fault.kind == fault_kind("chatter")) {
      for (const char letter : kChatterText)
        put({planned.next_ns, static_cast<std::uint8_t>(letter)});
      planned.next_ns += ns_of_ms(fault.number);
    }
  }
}

void ByteFaults::put(TimedByte byte) {
  byte.at_ns = std::max(byte.at_ns, last_ns_ + spacing_ns_);
  last_ns_ = byte.at_ns;
  on_the_way_.push_back(byte);
}

double ByteFaults::random_share() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

}  // namespace tp100::sim
