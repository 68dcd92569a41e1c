#include "sim/robot/emulated_robot.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "core/time.h"
#include "sim/board/avr_board.h"
#include "sim/board/native_board.h"
#include "sim/body/seed.h"
#include "sim/body/uneven_floor.h"

namespace tp100::sim {
namespace {

using Clock = std::chrono::steady_clock;

// Independent streams from one seed.
std::uint64_t stream(std::uint64_t seed, std::uint64_t number) {
  return mix((seed - 1) * kSeedStep + number * 0xBF58476D1CE4E5B9U);
}

constexpr std::uint32_t kTickUs = 1024;

// Streams of errors that belong to the robot and not to a run.
constexpr std::uint64_t kLeftEncoder = 11;
constexpr std::uint64_t kRightEncoder = 12;

// Position of the tracks after the last run.
double track_phase_m(const course::EmulatedBody& body, std::uint64_t random) {
  const double length_m = 2.0 * (body.axle_spacing_m + kPi * body.wheel_radius_m);
  return length_m * static_cast<double>(random >> 11) * 0x1p-53;
}

struct BoardClock {
  double ppm;
  std::uint32_t start_us;
};

/// At least one tick before the wrap: from 0 on, the wrap would be 71 minutes away.
std::uint32_t start_before_wrap_us(HostNs wrap_ns) {
  const std::int64_t ahead_us = std::max<std::int64_t>(wrap_ns / kNsPerUs, kTickUs);
  return static_cast<std::uint32_t>(-ahead_us) / kTickUs * kTickUs;
}

/// Clock faults take effect from power-on: the resonator's error and the counter's start.
BoardClock clock_of(const EmulatedRobotSettings& settings) {
  BoardClock clock{settings.values.clock_ppm, settings.start_us};
  for (const PlannedFault& fault : settings.faults) {
    if (fault.kind == fault_kind("drift")) clock.ppm += fault.number;
    if (fault.kind == fault_kind("wrap")) clock.start_us = start_before_wrap_us(fault.begin_ns);
    if (fault.kind == fault_kind("hang") && settings.board != BoardKind::kAvr)
      throw UserError("--fault hang: only an emulated chip can hang; add --board avr");
  }
  return clock;
}

std::unique_ptr<Board> make_board(const EmulatedRobotSettings& settings, I2cSlave& imu) {
  const auto phase_ns = static_cast<std::int64_t>(stream(settings.seed, 2) % 5'000'000);
  const auto [clock_ppm, start_us] = clock_of(settings);
  const std::uint64_t seed = stream(settings.seed, 1);
  switch (settings.board) {
    case BoardKind::kNative:
      break;
    case BoardKind::kAvr:
      return std::make_unique<AvrBoard>(AvrBoardSettings{.bootloader = settings.bootloader,
                                                         .blank = settings.blank,
                                                         .seed = seed,
                                                         .clock_ppm = clock_ppm,
                                                         .start_us = start_us,
                                                         .reset_hold_ns = phase_ns},
                                        &imu);
  }
  return std::make_unique<NativeBoard>(NativeBoardSettings{.seed = seed,
                                                           .clock_ppm = clock_ppm,
                                                           .start_us = start_us,
                                                           .boot_delay_ns = 4'000'000 + phase_ns},
                                       &imu);
}

}  // namespace

void UartLine::send(std::span<const std::uint8_t> bytes, HostNs now_ns) {
  for (const std::uint8_t value : bytes) {
    free_ns_ = std::max(free_ns_, now_ns) + byte_ns_;
    bytes_.push_back({free_ns_, value});
  }
}

const std::vector<TimedByte>& UartLine::take(HostNs until_ns) {
  taken_.clear();
  while (!bytes_.empty() && bytes_.front().at_ns <= until_ns) {
    taken_.push_back(bytes_.front());
    bytes_.pop_front();
  }
  return taken_;
}

EmulatedRobot::EmulatedRobot(const EmulatedRobotSettings& settings)
    : EmulatedRobot(settings, sampled(settings.values, stream(settings.seed, 7))) {}

EmulatedRobot::EmulatedRobot(const EmulatedRobotSettings& settings, const course::Emulated& values)
    : body_(make_body(values, placed(settings.start, values, stream(settings.seed, 7)),
                      settings.on_stand, settings.terrain, stream(settings.seed, 8))),
      left_motor_(values.motor, values.motor.left_gain),
      right_motor_(values.motor, values.motor.right_gain),
      left_encoder_(values.encoder, 0, kLeftEncoder),
      right_encoder_(values.encoder, 2, kRightEncoder),
      imu_(values.imu, stream(settings.seed, 3)),
      battery_(values.battery),
      faults_(settings.faults, 10'000'000'000LL / settings.baud, stream(settings.seed, 6)),
      bus_(imu_),
      board_(make_board(settings, bus_)),
      to_board_(settings.baud) {
  body_->turn_tracks(track_phase_m(values.body, stream(settings.seed, 4)),
                     track_phase_m(values.body, stream(settings.seed, 5)));
}

EmulatedRobot::~EmulatedRobot() = default;

void EmulatedRobot::reset(PowerUp cause) {
  if (cause == PowerUp::kPowerOn) imu_.power_on();
  board_->reset(cause, now_ns_);
}

void EmulatedRobot::receive(std::span<const std::uint8_t> bytes, HostNs now_ns) {
  to_board_.send(bytes, now_ns);
}

void EmulatedRobot::disturbance(double sideways_m, double yaw_rad, double duration_s) {
  body_->disturbance(sideways_m, yaw_rad, duration_s);
}

void EmulatedRobot::inject() {
  imu_.freeze(faults_.active(fault_kind("imu-frozen"), now_ns_));
  bus_.set_missing(faults_.active(fault_kind("imu-missing"), now_ns_));
  bus_.set_saturated(faults_.active(fault_kind("imu-saturated"), now_ns_));
  if (faults_.take(fault_kind("reboot"), now_ns_) ||
      faults_.take(fault_kind("reboot-loop"), now_ns_))
    board_->reset(PowerUp::kBrownOut, now_ns_);
  if (faults_.take(fault_kind("hang"), now_ns_)) dynamic_cast<AvrBoard&>(*board_).hang_main_loop();
}

std::vector<TimedByte> EmulatedRobot::advance() {
  constexpr double kStepS = static_cast<double>(kPhysicsStepNs) * 1e-9;
  const HostNs until_ns = now_ns_ + kPhysicsStepNs;
  const MotorDuty duty = board_->motor_duty();
  const double volts = battery_.volts();
  const Clock::time_point physics = Clock::now();
  left_motor_.step(duty.left, volts, body_->state().left_load_n);
  right_motor_.step(duty.right, volts, body_->state().right_load_n);
  battery_.step(std::abs(left_motor_.force_n()) + std::abs(right_motor_.force_n()));
  body_->step(left_motor_.track_mps(), right_motor_.track_mps());
  spent_.physics += Clock::now() - physics;
  inject();
  imu_.measure(body_->state(), now_ns_);

  edges_.clear();
  left_encoder_.move(left_motor_.track_mps() * kStepS, now_ns_, until_ns, edges_);
  const auto left_edges = static_cast<std::ptrdiff_t>(edges_.size());
  right_encoder_.move(right_motor_.track_mps() * kStepS, now_ns_, until_ns, edges_);
  std::inplace_merge(edges_.begin(), edges_.begin() + left_edges, edges_.end(),
                     [](const EncoderEdge& a, const EncoderEdge& b) { return a.at_ns < b.at_ns; });

  faults_.edges(edges_, now_ns_);

  board_->set_battery(faults_.battery(volts, now_ns_));
  const std::vector<TimedByte>& received = faults_.to_robot(to_board_.take(until_ns), until_ns);
  const Clock::time_point board = Clock::now();
  board_->advance(until_ns, edges_, received);
  spent_.board += Clock::now() - board;
  now_ns_ = until_ns;
  return faults_.to_host(board_->take_sent(), until_ns);
}

const course::Disturbance* DisturbanceInjector::update(EmulatedRobot& robot) {
  if (next_ >= disturbances_.size()) return nullptr;
  const Pose& pose = robot.truth().pose;
  // The disturbance's own motion is not part of the distance.
  if (started_ && !robot.disturbed()) driven_m_ += magnitude(pose.x_m - x_m_, pose.y_m - y_m_);
  started_ = true;
  x_m_ = pose.x_m;
  y_m_ = pose.y_m;
  if (driven_m_ < disturbances_[next_].at_m || robot.disturbed()) return nullptr;
  const course::Disturbance& disturbance = disturbances_[next_++];
  robot.disturbance(disturbance.sideways_m, disturbance.yaw_rad, disturbance.duration_s);
  return &disturbance;
}

}  // namespace tp100::sim
