#include "sim/faults/sensor_faults.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/time.h"
#include "sim/body/body.h"

namespace tp100::sim {
namespace {

// Shortest edge spacing that a Mega can count.
constexpr HostNs kEdgeNs = 40'000;

// ACCEL_XOUT_H to GYRO_ZOUT_L (MPU-6000/6050 register map rev 4.2, 4.17 to 4.19), without the
// temperature in between.
bool is_value(int reg) { return (reg >= 0x3B && reg <= 0x40) || (reg >= 0x43 && reg <= 0x48); }

bool of_side(const PlannedFault& fault, std::uint8_t channel) {
  return channel < 2 ? fault.left : fault.right;
}

// Phase that changes next (0: A). Forward: A if both levels are equal, else B; backward: vice
// versa.
std::size_t next_phase(const std::array<bool, 2>& levels, bool forward) {
  return (levels[0] == levels[1]) == forward ? 0 : 1;
}

}  // namespace

EncoderFaults::EncoderFaults(const std::vector<PlannedFault>& faults) {
  for (const PlannedFault& fault : faults) {
    const int cycles = fault.kind == fault_kind("encoder-jump")
                           ? static_cast<int>(std::lround(fault.number / 4.0))
                           : 0;
    faults_.push_back({fault, {fault.left ? cycles : 0, fault.right ? cycles : 0}});
  }
}

void EncoderFaults::pass(std::vector<EncoderEdge>& edges, HostNs from_ns, HostNs shift_ns) {
  std::array<bool, 4> after = levels_;
  for (const EncoderEdge& edge : edges) after[edge.channel] = edge.level;
  for (Planned& planned : faults_) {
    const PlannedFault& fault = planned.fault;
    const auto hit = [&](const EncoderEdge& edge) {
      return fault.active(edge.at_ns + shift_ns) && of_side(fault, edge.channel);
    };
    if (fault.kind == fault_kind("encoder-stuck")) std::erase_if(edges, hit);
    if (fault.kind == fault_kind("encoder-silent"))
      std::erase_if(edges,
                    [&](const EncoderEdge& edge) { return hit(edge) && edge.channel % 2 == 1; });
    if (fault.kind == fault_kind("encoder-lose")) lose(edges, shift_ns, planned);
    if (fault.kind == fault_kind("encoder-flip"))
      for (EncoderEdge& edge : edges)
        if (hit(edge)) edge.channel ^= 1U;
    if (fault.kind == fault_kind("encoder-jump") && fault.active(from_ns + shift_ns))
      for (std::uint8_t side = 0; side < 2; ++side)
        jump(edges, from_ns, static_cast<std::uint8_t>(2 * side), planned.cycles[side]);
  }
  levels_ = after;
}

void EncoderFaults::lose(std::vector<EncoderEdge>& edges, HostNs shift_ns, Planned& planned) const {
  const PlannedFault& fault = planned.fault;
  std::array<bool, 4> levels = levels_;
  std::vector<EncoderEdge> passed;
  for (const EncoderEdge& edge : edges) {
    const std::size_t side = edge.channel / 2U;
    Slipping& slipping = planned.slipping[side];
    const std::array<bool, 2> before{levels[2 * side], levels[2 * side + 1]};
    levels[edge.channel] = edge.level;
    const bool active = fault.active(edge.at_ns + shift_ns) && of_side(fault, edge.channel);
    if (!slipping.began && !active) {
      passed.push_back(edge);
      continue;
    }
    // The disk has slipped on the axle, so that the phases stay shifted once the fault is over.
    if (!slipping.began) slipping = {.began = true, .levels = before};
    const bool forward = next_phase(before, true) == edge.channel % 2U;
    slipping.kept += (forward ? 1.0 : -1.0) * (active ? 1.0 - fault.number : 1.0);
    if (std::abs(slipping.kept) < 1.0) continue;
    const std::size_t phase = next_phase(slipping.levels, slipping.kept > 0.0);
    slipping.kept -= slipping.kept > 0.0 ? 1.0 : -1.0;
    slipping.levels[phase] = !slipping.levels[phase];
    passed.push_back(
        {edge.at_ns, static_cast<std::uint8_t>(2 * side + phase), slipping.levels[phase]});
  }
  edges = std::move(passed);
}

void EncoderFaults::jump(std::vector<EncoderEdge>& edges, HostNs from_ns,
                         std::uint8_t first_channel, int& cycles) {
  // The edges are inserted before the track's own first edge of this quantum. They form whole
  // cycles, which leave the phases unchanged.
  const auto first = std::find_if(edges.begin(), edges.end(), [&](const EncoderEdge& edge) {
    return edge.channel / 2 == first_channel / 2;
  });
  const HostNs room_ns = first == edges.end() ? kPhysicsStepNs : first->at_ns - from_ns - kEdgeNs;
  if (room_ns <= 0 || cycles == 0) return;
  const int now = std::clamp(cycles, -static_cast<int>(room_ns / (4 * kEdgeNs)),
                             static_cast<int>(room_ns / (4 * kEdgeNs)));
  const bool forward = cycles > 0;
  std::array<bool, 2> level{levels_[first_channel], levels_[first_channel + 1U]};
  for (int i = 0; i < 4 * std::abs(now); ++i) {
    const std::size_t phase = next_phase(level, forward);
    level[phase] = !level[phase];
    edges.push_back({from_ns + (i + 1) * kEdgeNs, static_cast<std::uint8_t>(first_channel + phase),
                     level[phase]});
  }
  cycles -= now;
  std::stable_sort(edges.begin(), edges.end(),
                   [](const EncoderEdge& a, const EncoderEdge& b) { return a.at_ns < b.at_ns; });
}

bool ImuFaults::write(std::span<const std::uint8_t> bytes) {
  if (missing_) return false;
  if (!bytes.empty()) pointer_ = bytes[0];
  return imu_.write(bytes);
}

bool ImuFaults::read(std::span<std::uint8_t> bytes) {
  if (missing_ || !imu_.read(bytes)) return false;
  if (!saturated_) return true;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const int reg = pointer_ + static_cast<int>(i);
    if (is_value(reg)) bytes[i] = (reg % 2 == 1) ? 0x7F : 0xFF;
  }
  return true;
}

}  // namespace tp100::sim
