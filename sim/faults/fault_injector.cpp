#include "sim/faults/fault_injector.h"

#include <algorithm>
#include <array>

#include "core/time.h"

namespace tp100::sim {
namespace {

using Faults = std::vector<PlannedFault>;

constexpr std::array kOfFrames = {
    fault_kind("clock-step"),      fault_kind("sync-late"), fault_kind("sync-twice"),
    fault_kind("version"),         fault_kind("schema"),    fault_kind("board"),
    fault_kind("unknown-message"), fault_kind("replay"),    fault_kind("sequence")};

bool of_frames(FaultKind kind) {
  return std::find(kOfFrames.begin(), kOfFrames.end(), kind) != kOfFrames.end();
}

Faults of_direction(const Faults& faults, bool to_host, bool frames) {
  Faults out;
  for (const PlannedFault& fault : faults)
    if ((to_host ? fault.to_host : fault.to_robot) && of_frames(fault.kind) == frames)
      out.push_back(fault);
  return out;
}

}  // namespace

FaultInjector::FaultInjector(const Faults& faults, HostNs byte_ns, std::uint64_t seed)
    : frames_to_robot_(of_direction(faults, false, true)),
      frames_to_host_(of_direction(faults, true, true)),
      bytes_to_robot_(of_direction(faults, false, false), byte_ns, seed),
      bytes_to_host_(of_direction(faults, true, false), 0, seed + 1),
      encoders_(faults) {
  for (const PlannedFault& fault : faults) faults_.push_back({fault, fault.begin_ns});
}

void FaultInjector::begin(HostNs now_ns) {
  if (!faults_.empty() && !begin_ns_) begin_ns_ = now_ns;
}

std::vector<TimedByte> FaultInjector::pass(std::span<const TimedByte> bytes, HostNs until_ns,
                                           FrameFaults& frames, ByteFaults& corruption) const {
  std::vector<TimedByte> moved(bytes.begin(), bytes.end());
  if (!begin_ns_) return moved;
  for (TimedByte& byte : moved) byte.at_ns -= *begin_ns_;
  moved = corruption.pass(frames.pass(moved, until_ns - *begin_ns_), until_ns - *begin_ns_);
  for (TimedByte& byte : moved) byte.at_ns += *begin_ns_;
  return moved;
}

std::vector<TimedByte> FaultInjector::to_robot(std::span<const TimedByte> bytes, HostNs until_ns) {
  return pass(bytes, until_ns, frames_to_robot_, bytes_to_robot_);
}

std::vector<TimedByte> FaultInjector::to_host(std::span<const TimedByte> bytes, HostNs until_ns) {
  return pass(bytes, until_ns, frames_to_host_, bytes_to_host_);
}

void FaultInjector::edges(std::vector<EncoderEdge>& edges, HostNs from_ns) {
  if (begin_ns_) encoders_.pass(edges, from_ns, -*begin_ns_);
}

double FaultInjector::battery(double volts, HostNs now_ns) const {
  for (const Planned& planned : faults_)
    if (begin_ns_ && planned.fault.kind == fault_kind("battery") &&
        planned.fault.active(now_ns - *begin_ns_))
      return planned.fault.number;
  return volts;
}

bool FaultInjector::active(FaultKind kind, HostNs now_ns) const {
  for (const Planned& planned : faults_)
    if (begin_ns_ && planned.fault.kind == kind && planned.fault.active(now_ns - *begin_ns_))
      return true;
  return false;
}

std::optional<double> FaultInjector::take(FaultKind kind, HostNs now_ns) {
  for (Planned& planned : faults_) {
    const HostNs at_ns = begin_ns_ ? now_ns - *begin_ns_ : -1;
    if (!begin_ns_ || planned.fault.kind != kind || !planned.fault.active(at_ns) ||
        at_ns < planned.next_ns)
      continue;
    planned.next_ns = kInjectableFaults[kind].at_once
                          ? planned.fault.end_ns
                          : planned.next_ns + from_s(planned.fault.number);
    return planned.fault.number;
  }
  return std::nullopt;
}

}  // namespace tp100::sim
