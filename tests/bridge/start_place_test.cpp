// Random sequences of what people and cameras do: where the robot stands is never decided for them.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <sstream>

#include "core/arithmetic.h"
#include "step_rig.h"

namespace tp100::bridge {
namespace {

constexpr int kDeeds = 40;

/// A robot, those who place, drive, start and stop it, and a camera that is switched on and off.
class Sequence : public StepTest {
 public:
  void TestBody() override {}
  /// What went wrong; empty: nothing.
  std::string run(std::uint64_t seed) {
    random_.seed(seed);
    camera_on_ = chance(2);
    step_.emplace(parameters_, course_);
    robot_.emplace(parameters_);
    steps(1.5);
    for (int i = 0; i < kDeeds && wrong_.empty(); ++i) deed();
    return wrong_.empty() ? "" : "seed " + std::to_string(seed) + ": " + wrong_;
  }
  int started = 0, asked = 0, continued = 0;

 private:
  bool chance(unsigned of) { return random_() % of == 0; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() % 1001U) / 1000.0;
  }

  void one(const std::vector<OperatorRequest>& requests = {}) {
    const HostNs at = now_ + kStepPeriod;
    if (camera_on_ && ++ticks_ % 6 == 0)
      camera_.push_back(
          {robot_->x_m, robot_->y_m, robot_->yaw_rad, at, static_cast<std::uint32_t>(ticks_)});
    const RunState before = last_.run_state;
    const Outputs& out = tick(*step_, *robot_, requests);
    last_ = out.snapshot;
    if (last_.filter.recoveries > 0) moved_ = true;
    if (last_.filter.camera_used > used_) seen_ = true;
    used_ = last_.filter.camera_used;
    if (last_.run_state == RunState::kDriving) moved_ = true;
    if (last_.run_state == RunState::kRunning && before != RunState::kRunning) begins();
  }
  void steps(double duration_s) {
    for (double t = 0.0; t < duration_s && wrong_.empty(); t += to_s(kStepPeriod)) one();
  }

  static bool there(const Pose& pose, double within = 1.0) {
    const double turn_rad = std::remainder(pose.yaw_rad, 2.0 * kPi);
    return std::sqrt(pose.x_m * pose.x_m + pose.y_m * pose.y_m) <= 0.03 * within &&
           std::abs(turn_rad) <= 3.0 * kRadPerDeg * within;
  }
  bool known() const {
    return there(last_.world) && !moved_ &&
           (!seen_ || there(last_.estimates[PoseSource::kFused].pose));
  }

  // Judged by the pose before: while the robot is armed it stands still.
  void begins() {
    const Pose& now = last_.world;
    switch (*request_) {
      case OperatorRequest::kStart:
        if (!known_) wrong("a run began, and nobody had said where the robot stands");
        [[fallthrough]];
      case OperatorRequest::kStartPlaced:
        // With a camera that sees it, the fused pose stays.
        if (!there(now)) wrong("a run from the start began elsewhere");
        moved_ = false;
        ++started;
        break;
      default:
        if (std::abs(now.x_m - at_.x_m) > 2e-3 || std::abs(now.y_m - at_.y_m) > 2e-3)
          wrong("a run that continues began elsewhere");
        ++continued;
    }
  }

  void start(OperatorRequest request) {
    if (under_way(last_.run_state)) return one({request});
    request_ = request;
    known_ = known();
    at_ = last_.world;
    const StartRefusal other = last_.start_refusal;
    const bool asks = last_.start_places.asks();
    if (asks == known_) wrong(asks ? "it asks for nothing" : "it does not ask");
    one({request});
    if (request == OperatorRequest::kStart && asks) {
      ++asked;
      if (under_way(last_.run_state)) wrong("a start that says nothing is not refused");
    }
    if (request == OperatorRequest::kStart && !asks && other == StartRefusal::kNone &&
        !under_way(last_.run_state))
      wrong("a start is refused though the robot is known to stand there");
    steps(between(0.2, 4.0));
  }

  void place() {
    if (!step_->changeable()) return;
    const bool exactly = chance(3);
    const double scale = chance(2) ? 0.02 : 1.0;
    const Pose at = exactly ? course_->start
                            : Pose{.x_m = between(-1.0, 1.0) * scale,
                                   .y_m = between(-1.0, 1.0) * scale,
                                   .yaw_rad = between(-3.0, 3.0) * scale};
    restart_.push(step_->restart_state(at, now_));
    moved_ = !(at.x_m == 0.0 && at.y_m == 0.0 && at.yaw_rad == 0.0);
    used_ = 0;
    one();
  }

  void drive() {
    one({OperatorRequest::kDrive});
    const double scale = chance(2) ? 0.05 : 1.0;
    const double speed_mps = between(-0.1, 0.1) * scale, rate_radps = between(-0.5, 0.5) * scale;
    for (double t = between(0.1, 3.0); t > 0.0; t -= to_s(kStepPeriod)) {
      velocities_.push_back({now_ + kStepPeriod, speed_mps, rate_radps});
      one();
    }
    steps(1.0);
  }

  void carry() {
    if (robot_->armed) return;
    const bool back = chance(2);
    robot_->x_m = back ? 0.0 : robot_->x_m + between(-0.3, 0.3);
    robot_->y_m = back ? 0.0 : robot_->y_m + between(-0.3, 0.3);
    robot_->yaw_rad = back ? 0.0 : robot_->yaw_rad + between(-1.0, 1.0);
    steps(0.5);
  }

  void deed() {
    switch (random_() % 12U) {
      case 0:
      case 1:
        return start(OperatorRequest::kStart);
      case 2:
        return start(OperatorRequest::kStartPlaced);
      case 3:
        return start(OperatorRequest::kContinue);
      case 4:
        return place();
      case 5:
        return drive();
      case 6:
        return carry();
      case 7:
        one({chance(2) ? OperatorRequest::kPause : OperatorRequest::kResume});
        return steps(0.3);
      case 8:
        one({chance(2) ? OperatorRequest::kStop : OperatorRequest::kHold});
        return steps(1.0);
      case 9:
        camera_on_ = !camera_on_;
        return steps(0.5);
      case 10: {
        // The robot is unplugged, and its board begins anew.
        KinematicRobot again(parameters_);
        again.x_m = robot_->x_m;
        again.y_m = robot_->y_m;
        again.yaw_rad = robot_->yaw_rad;
        robot_.emplace(again);
        ++session_;
        seen_ = false;
        return steps(1.5);
      }
      default:
        return steps(between(0.5, 15.0));
    }
  }

  void wrong(const std::string& what) {
    std::ostringstream text;
    text << what << ", at " << to_s(now_) << " s, x " << last_.world.x_m << " y " << last_.world.y_m
         << " yaw " << last_.world.yaw_rad;
    if (wrong_.empty()) wrong_ = text.str();
  }

  std::mt19937_64 random_;
  std::optional<Step> step_;
  std::optional<KinematicRobot> robot_;
  Snapshot last_{};
  bool camera_on_ = false, moved_ = false, seen_ = false, known_ = false;
  std::uint32_t used_ = 0;
  int ticks_ = 0;
  std::optional<OperatorRequest> request_;
  Pose at_{};
  std::string wrong_;
};

// A robot that is started from a place where it is not drives out of its fence.
TEST(StartPlace, NoSequenceOfDeedsStartsARobotThatMayBeElsewhereUnasked) {
  int started = 0, asked = 0, continued = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Sequence sequence;
    EXPECT_EQ(sequence.run(seed), "");
    started += sequence.started;
    asked += sequence.asked;
    continued += sequence.continued;
  }
  EXPECT_GT(started, 50) << "they must really be started";
  EXPECT_GT(asked, 50);
  EXPECT_GT(continued, 20);
}

}  // namespace
}  // namespace tp100::bridge
