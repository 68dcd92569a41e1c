#pragma once
// An emulated robot driven by hand in virtual time: the daemon, and the robot at the other end of a
// cable.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../live/daemon_rig.h"
#include "messages/sink.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"

namespace tp100::sim {

struct HandDrivenSettings {
  Loaded loaded{};
  std::shared_ptr<const course::Course> course{};  ///< null: no course
  std::uint64_t seed = 1;
  messages::Sink* sink = nullptr;
  /// A world that owns the pose: its answer to a step.
  std::function<WorldSample(const StepRecord&)> world{};
};

class HandDriven : public live::DaemonRig {
 public:
  static constexpr HostNs kPeriodNs = 5 * kNsPerMs;

  explicit HandDriven(const HandDrivenSettings& settings)
      : DaemonRig(settings.loaded.files, setup_of(settings)),
        robot_({.values = settings.loaded.robot.emulated,
                .start = run_.course == nullptr ? Pose{} : run_.course->start,
                .on_stand = settings.loaded.setup == bridge::Setup::kStand,
                .terrain = run_.course == nullptr ? course::Terrain{} : run_.course->terrain,
                .seed = settings.seed}),
        sink_(settings.sink),
        world_(settings.world) {
    robot_.reset(PowerUp::kPowerOn);
    while (robot_.now_ns() < 20 * kNsPerMs) robot_.advance();
    robot_.opened();
    cycle_.opened(robot_.now_ns());
  }

  /// Called after each physics step.
  std::function<void()> after_physics;

  EmulatedRobot& robot() { return robot_; }
  HostNs now() const override { return robot_.now_ns(); }
  void see(const CameraSample& seen) { cycle_.camera(seen); }

  void step() {
    for (const HostNs end = now() + kPeriodNs; now() < end;) {
      for (const TimedByte& byte : robot_.advance()) {
        arriving_.push_back(byte.value);
        if (byte.value != wire::kDelimiter) continue;
        cycle_.received(arriving_, byte.at_ns);
        arriving_.clear();
      }
      if (after_physics) after_physics();
    }
    if (before_step) before_step(now());
    cycle_.step(now());
    robot_.receive(cycle_.output(), now());
    cycle_.written(cycle_.output().size());
    cycle_.after_write(now());
    take_results();
    if (sink_ != nullptr) sink_->take(record());
    if (world_) cycle_.world(world_(record()));
  }
  template <class Condition>
  bool step_until(Condition condition, double within_s) {
    for (const HostNs end = now() + from_s(within_s); now() < end;) {
      step();
      if (condition()) return true;
    }
    return false;
  }
  void step_for(double duration_s) {
    step_until([] { return false; }, duration_s);
  }
  bool wait_until_ready() {
    return step_until([&] { return record().snapshot.drive_refusal == StartRefusal::kNone; }, 10.0);
  }

  /// Viewer `id` takes the lease, gives a first input and waits until the robot is armed. Returns
  /// the token or the refusal.
  std::string take(std::uint32_t id) {
    const nlohmann::json answer = call(id, "drive_take");
    if (!answer.contains("token")) return answer.value("refused", "");
    drive(id, answer["token"], 0.0, 0.0);
    step_until([&] { return state() == RunState::kDriving; }, 1.0);
    return answer["token"];
  }
  /// ROS 2 takes the lease and the robot is armed; returns the messages if that fails.
  std::string take_by_ros2() {
    receive_drive(false);
    take_messages();
    receive_drive(true);
    step_until([&] { return state() == RunState::kDriving; }, 1.0);
    return take_messages();
  }

 private:
  static config::RunSetup setup_of(const HandDrivenSettings& settings) {
    config::RunSetup run{.configuration = settings.loaded.configuration,
                         .robot = settings.loaded.robot,
                         .course = settings.course,
                         .parameters = config::bridge_parameters(settings.loaded.configuration,
                                                                 settings.loaded.robot)};
    run.parameters.setup = settings.loaded.setup;
    run.parameters.world.kind =
        settings.world ? bridge::WorldKind::kUdp : bridge::WorldKind::kInternal;
    run.parameters.world.owns_pose = static_cast<bool>(settings.world);
    return run;
  }

  EmulatedRobot robot_;
  messages::Sink* sink_;
  std::function<WorldSample(const StepRecord&)> world_;
  std::vector<std::uint8_t> arriving_;
};

}  // namespace tp100::sim
