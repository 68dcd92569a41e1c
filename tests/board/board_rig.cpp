#include "board_rig.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tp100::sim {
namespace {

constexpr double kTopMps = 0.25;  // track speed at full duty

BodyState standstill() {
  BodyState body{};
  body.specific_force_mps2 = {0.0, 0.0, 9.80665};
  return body;
}

}  // namespace

BoardRig::BoardRig(std::uint64_t seed)
    : WireHost(5, 50, 300), imu({}, seed), left({}, 0, 11), right({}, 2, 12) {
  parameters.dead_band = 0.05f;
}

void BoardRig::send_bytes(const std::vector<std::uint8_t>& sent) {
  for (const std::uint8_t value : sent) {
    wire_free_ns_ = std::max(wire_free_ns_, now_ns) + kByteNs;
    to_board_.push_back({wire_free_ns_, value});
  }
}

void BoardRig::run(int ms) {
  for (int i = 0; i < ms; ++i) {
    if (streams && ++since_command_ >= 10) {
      since_command_ = 0;
      send(command());
    }
    step();
  }
}

void BoardRig::step() {
  const std::int64_t until = now_ns + kStepNs;
  const MotorDuty duty = hardware().motor_duty();
  const auto travel = [&](double share) {
    return (forced_mps != 0.0 ? forced_mps : share * kTopMps) * 1e-3;
  };
  edges_.clear();
  left.move(travel(duty.left), now_ns, until, edges_);
  const auto middle = static_cast<std::ptrdiff_t>(edges_.size());
  right.move(travel(duty.right), now_ns, until, edges_);
  std::inplace_merge(edges_.begin(), edges_.begin() + middle, edges_.end(),
                     [](const EncoderEdge& a, const EncoderEdge& b) { return a.at_ns < b.at_ns; });
  for (const EncoderEdge& edge : edges_) levels_[edge.channel] = edge.level;
  for (const std::uint8_t a : std::exchange(glitches_, {})) {
    for (const std::uint8_t channel : {a, static_cast<std::uint8_t>(a + 1)}) {
      levels_[channel] = !levels_[channel];
      edges_.push_back({until, channel, levels_[channel]});
    }
  }
  imu.measure(standstill(), now_ns);
  hardware().set_battery(battery_v);
  const auto due = std::find_if(to_board_.begin(), to_board_.end(),
                                [&](const TimedByte& byte) { return byte.at_ns > until; });
  const std::vector<TimedByte> received(to_board_.begin(), due);
  to_board_.erase(to_board_.begin(), due);
  hardware().advance(until, edges_, received);
  now_ns = until;
  for (const TimedByte& byte : hardware().take_sent()) {
    bytes.push_back(byte);
    const std::optional<wire::Type> type = receive(byte.value);
    if (type == wire::Type::kHello) nonce = hellos.back().boot_nonce;
    if (type == wire::Type::kSample) sample_ns.push_back(byte.at_ns);
  }
}

bool BoardRig::moves() {
  const MotorDuty duty = hardware().motor_duty();
  return duty.left != 0.0 || duty.right != 0.0;
}

bool BoardRig::boot(PowerUp cause) {
  const std::size_t before = hellos.size();
  if (cause == PowerUp::kPowerOn) imu.power_on();
  hardware().reset(cause, now_ns);
  restart();
  for (int ms = 0; ms < 1500 && hellos.size() == before; ++ms) run(1);
  return hellos.size() > before;
}

std::uint32_t BoardRig::device_us() const {
  if (samples.empty()) return 0;
  return last().device_us + static_cast<std::uint32_t>((now_ns - sample_ns.back()) / 1000) + 1000;
}

int BoardRig::ms_until_off(int limit_ms) {
  for (int ms = 0; ms <= limit_ms; ++ms) {
    if (!moves()) return ms;
    run(1);
  }
  return -1;
}

}  // namespace tp100::sim
