// Cameras and worlds that lie, and how far the robot really gets; and healthy ones, which must not
// end a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "core/faults.h"
#include "course/path.h"
#include "fence_runs.h"
#include "hand_driven.h"
#include "runs.h"
#include "sim/sensors/overhead_camera.h"

namespace tp100::sim {
namespace {

constexpr double kOutsideM = 0.05, kOffPathM = 0.25;
constexpr std::array kRobots = {"end-loaded", "uniform", "front-heavy",
                                "slippery",   "large",   "worn"};
constexpr std::array kCourses = {"1-straight", "1-curve", "1-sharp", "2", "3"};
constexpr std::array kSteering = {PoseSource::kFused, PoseSource::kOdometry};

enum class Lie { kStuck, kMirrored, kTurned, kScaled, kJumps, kWorld };

/// A camera, or a world that owns the pose, that does not show what is.
struct Case {
  Lie lie;
  double value;  ///< seconds, degrees, factor, metres, share of the way

  std::string name() const {
    constexpr std::array kNames = {"stuck at s", "mirrored",   "turned by deg",
                                   "scaled by",  "jumps by m", "world moves"};
    return std::string(kNames[static_cast<std::size_t>(lie)]) + " " + std::to_string(value);
  }
  bool world() const { return lie == Lie::kWorld; }
};

const std::vector<Case>& lies() {
  static const std::vector<Case> all = [] {
    std::vector<Case> cases;
    for (const double at_s : {0.0, 2.0, 5.0, 8.0, 11.0, 14.0, 17.0, 20.0})
      cases.push_back({Lie::kStuck, at_s});
    cases.push_back({Lie::kMirrored, 0.0});
    for (const double deg : {90.0, -90.0, 180.0}) cases.push_back({Lie::kTurned, deg});
    for (const double factor : {0.5, 0.65, 0.8, 0.9, 0.95, 1.05, 1.1, 1.25, 1.5, 2.0})
      cases.push_back({Lie::kScaled, factor});
    for (const double by_m : {0.05, 0.1, 0.15, 0.3, 1.0}) cases.push_back({Lie::kJumps, by_m});
    for (const double share : {0.0, 0.1, 0.5, 0.9}) cases.push_back({Lie::kWorld, share});
    return cases;
  }();
  return all;
}

/// What the camera reports in place of what it sees, `since_s` after the run began (negative:
/// before).
class LyingCamera {
 public:
  explicit LyingCamera(const Case& which) : which_(which) {}

  void misread(CameraSample& seen, double since_s) {
    const double value = which_.value;
    switch (which_.lie) {
      case Lie::kStuck:
        if (since_s < value) held_ = seen;
        std::tie(seen.x_m, seen.y_m, seen.yaw_rad) = std::tie(held_.x_m, held_.y_m, held_.yaw_rad);
        break;
      case Lie::kMirrored:
        seen.y_m = -seen.y_m;
        seen.yaw_rad = -seen.yaw_rad;
        break;
      case Lie::kTurned: {
        const Pose turned = Transform2d{.turn_rad = value * kRadPerDeg}.of(
            {.x_m = seen.x_m, .y_m = seen.y_m, .yaw_rad = seen.yaw_rad});
        std::tie(seen.x_m, seen.y_m, seen.yaw_rad) =
            std::tie(turned.x_m, turned.y_m, turned.yaw_rad);
        break;
      }
      case Lie::kScaled:
        seen.x_m *= value;
        seen.y_m *= value;
        break;
      case Lie::kJumps:
        // A second marker is found for two of four seconds.
        if (since_s < 0.0 || std::fmod(since_s, 4.0) < 2.0) break;
        seen.x_m += 0.6 * value;
        seen.y_m += 0.8 * value;
        break;
      case Lie::kWorld:
        break;
    }
  }

 private:
  Case which_;
  CameraSample held_{};
};

/// The robot of a world that owns the pose goes `share` of the way from where a run or drive began.
class LyingWorld {
 public:
  LyingWorld(double share, PoseSource steering) : share_(share), steering_(steering) {}

  WorldSample answer(const StepRecord& record) {
    const Snapshot& snapshot = record.snapshot;
    const Pose& floor = snapshot.estimates[steering_].pose;
    if (!armed(snapshot.run_state) && !moved_) began_ = floor;
    moved_ = moved_ || armed(snapshot.run_state);
    WorldSample answer;
    answer.session = 1;
    answer.answered_ns = record.now_ns;
    answer.has_ground = answer.has_pose = true;
    answer.pose = floor;
    answer.pose.x_m = std::lerp(began_.x_m, floor.x_m, share_);
    answer.pose.y_m = std::lerp(began_.y_m, floor.y_m, share_);
    return answer;
  }

 private:
  double share_;
  PoseSource steering_;
  bool moved_ = false;
  Pose began_{};
};

Loaded loaded(const std::string& robot, const std::string& setup) {
  return load({.robot = robot, .setup = setup});
}

/// Block 1 of course 3 is too high for one robot, and its edge stops a worn one.
bool drives(const std::string& robot, const std::string& course, const std::string& setup) {
  if (course != "3") return true;
  return robot != "slippery" && !(robot == "worn" && setup == "terrain");
}

LockstepSettings settings(const std::string& course, const Loaded& robot, PoseSource steering,
                          std::uint64_t seed = 1) {
  LockstepSettings run = run_of(course, robot);
  run.configuration.parameters.steering = steering;
  run.seed = seed;
  return run;
}

bool names_the_source(const Case& which, const std::string& cause) {
  // Beside the fence, a jump within odometry's covariance may be the robot's.
  if (which.lie == Lie::kJumps && which.value <= 0.1 && cause == describe(Fault::fence).name)
    return true;
  return cause ==
         describe(which.world() ? Fault::world_against_odometry : Fault::camera_against_odometry)
             .name;
}

/// Sees how far the robot gets, in the course's world: virtual ramps and blocks hold it back there.
struct Reach : messages::Sink {
  explicit Reach(const LockstepSettings& run)
      : course(run.course), path(run.course), steering(run.configuration.parameters.steering) {}
  void take(const StepRecord& record) override {
    const Snapshot& snapshot = record.snapshot;
    if (began_ns == 0 && snapshot.run_state == RunState::kRunning) began_ns = record.now_ns;
    if (virtual_obstacles)
      behind = Transform2d::between(snapshot.estimates[steering].pose, snapshot.world);
  }
  void see(const EmulatedRobot& robot) {
    if (began_ns == 0) return;
    const Pose truth = behind.of(robot.truth().pose);
    out_m = std::max(out_m, outside_m(truth, course.fence));
    off_m = std::max(off_m, path.distance(truth.x_m, truth.y_m, 0.0, path.length_m()));
  }
  double since_s(HostNs at) const { return began_ns == 0 ? -1.0 : to_s(at - began_ns); }

  const course::Course& course;
  course::Path path;
  PoseSource steering;
  bool virtual_obstacles = false;
  HostNs began_ns = 0;
  Transform2d behind{};
  double out_m = -1.0, off_m = 0.0;
};

void expect_inside(const Case& which, const std::string& course, const std::string& robot,
                   PoseSource steering) {
  SCOPED_TRACE(which.name() + ", course " + course + ", " + robot + ", steered by " +
               std::string(to_string(steering)));
  LockstepSettings run = settings(course, loaded(robot, "flat"), steering);
  Reach reach(run);
  LyingCamera camera(which);
  LyingWorld world(which.value, steering);
  if (which.world()) {
    run.configuration.parameters.world.owns_pose = true;
    run.world = [&](const StepRecord& record) { return world.answer(record); };
  } else {
    reach.virtual_obstacles = true;
    run.camera = load_camera("overhead");
    run.misread = [&](CameraSample& seen) {
      camera.misread(seen, reach.since_s(seen.measured_ns));
    };
  }
  run.sinks = {&reach};
  run.watch = [&](const EmulatedRobot& body) { reach.see(body); };
  const report::RunResult result = run_lockstep(run);
  EXPECT_LE(reach.out_m, kOutsideM) << result.cause;
  EXPECT_LE(reach.off_m, kOffPathM) << result.cause;
  EXPECT_TRUE(result.finished || names_the_source(which, result.cause)) << result.cause;
}

// Every lie on a course, each with another robot and the other steering.
TEST(Envelope, WhatACameraOrAWorldInventsKeepsTheRobotOnItsPathAndIsNamed) {
  std::size_t i = 0;
  for (const Case& which : lies()) {
    for (const std::string course : kCourses) {
      ++i;
      std::string robot = kRobots[i % kRobots.size()];
      if (!drives(robot, course, "flat")) robot = "uniform";
      if (i % 4 == 0) expect_inside(which, course, robot, kSteering[i / 4 % 2]);
    }
  }
}

class Lies : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Nightly, Lies, testing::Range(std::size_t{0}, lies().size()));

TEST_P(Lies, KeepEveryRobotOnEveryPath) {
  for (const std::string course : kCourses) {
    for (const std::string robot : kRobots) {
      if (!drives(robot, course, "flat")) continue;
      for (const PoseSource steering : kSteering)
        expect_inside(lies()[GetParam()], course, robot, steering);
    }
  }
}

/// A driver who drives towards the fence with a lying camera or world, and takes the lease again
/// each time that the drive has ended.
void expect_fenced_in(const Case& which, const std::string& robot, PoseSource steering,
                      double yaw_rate_radps) {
  SCOPED_TRACE(which.name() + " by hand, " + robot + ", steered by " +
               std::string(to_string(steering)) + ", turning at " + std::to_string(yaw_rate_radps));
  Loaded with = loaded(robot, "flat");
  with.configuration.parameters.steering = steering;
  LyingCamera camera(which);
  LyingWorld world(which.value, steering);
  const auto course = std::make_shared<const course::Course>(load_course("1-straight"));
  HandDrivenSettings set{.loaded = with, .course = course};
  if (which.world()) set.world = [&](const StepRecord& record) { return world.answer(record); };
  HandDriven drive(set);
  const course::Fence& fence = course->fence;
  OverheadCamera overhead(load_camera("overhead"), (fence.min_x_m + fence.max_x_m) / 2.0,
                          (fence.min_y_m + fence.max_y_m) / 2.0, 1);
  double out_m = -1.0;
  HostNs began_ns = 0;
  drive.after_physics = [&] {
    const Pose& truth = drive.robot().truth().pose;
    out_m = std::max(out_m, outside_m(truth, fence));
    if (which.world()) return;
    overhead.look(truth, drive.now());
    while (auto seen = overhead.take(drive.now())) {
      camera.misread(*seen, began_ns == 0 ? -1.0 : to_s(seen->measured_ns - began_ns));
      drive.see(*seen);
    }
  };
  for (int take = 0; take < 3; ++take) {
    if (!drive.step_until(
            [&] { return drive.record().snapshot.drive_refusal == StartRefusal::kNone; }, 5.0))
      break;
    const std::string token = drive.take(1);
    if (began_ns == 0) began_ns = drive.now();
    drive.before_step = [&](HostNs) { drive.drive(1, token, 0.2, yaw_rate_radps); };
    drive.step_until([&] { return drive.state() != RunState::kDriving; }, 14.0);
    for (FaultMask left = drive.record().snapshot.faults; left != 0; left &= left - 1)
      EXPECT_TRUE(names_the_source(which, std::string(describe(*first_fault(left)).name)))
          << describe(*first_fault(left)).name;
    if (drive.state() == RunState::kDriving) break;
    drive.before_step = {};
    drive.step_for(1.0);
  }
  EXPECT_LE(out_m, kOutsideM);
}

TEST(Envelope, WhatACameraOrAWorldInventsLetsNobodyDriveOutOfTheFence) {
  std::size_t i = 0;
  for (const Case& which : lies()) {
    if (++i % 3 != 0) continue;
    expect_fenced_in(which, kRobots[i / 3 % kRobots.size()], kSteering[i / 3 % 2],
                     i % 2 == 0 ? 0.2 : 0.0);
  }
}

TEST_P(Lies, LetNobodyDriveAnyRobotOutOfTheFence) {
  for (const std::string robot : kRobots) {
    for (const PoseSource steering : kSteering) {
      for (const double radps : {-0.15, 0.0, 0.3})
        expect_fenced_in(lies()[GetParam()], robot, steering, radps);
    }
  }
}

// Ramps and blocks hold the virtual robot back, so that the real one may be ahead of it. A world
// that claims them everywhere must not lead the real one on and on.
TEST(Envelope, AWorldThatClaimsRampsAndBlocksEverywhereLeadsNoRobotFarOut) {
  // What the world's obstacles may explain, and what the robot needs to stop.
  constexpr double kFarthestM = 0.15 + kOutsideM;
  for (const char* robot : {"uniform", "end-loaded"}) {
    for (const double share : {0.0, 0.56, 0.8}) {
      for (const bool block : {true, false}) {
        LockstepSettings run = settings("1-straight", loaded(robot, "flat"), PoseSource::kOdometry);
        Reach reach(run);
        LyingWorld world(share, PoseSource::kOdometry);
        run.configuration.parameters.world.owns_pose = true;
        run.world = [&](const StepRecord& record) {
          WorldSample answer = world.answer(record);
          (block ? answer.step_height_m : answer.pitch_rad) = block ? 0.02 : -0.06;
          return answer;
        };
        run.sinks = {&reach};
        run.watch = [&](const EmulatedRobot& body) { reach.see(body); };
        const report::RunResult result = run_lockstep(run);
        EXPECT_LE(reach.out_m, kFarthestM) << robot << ' ' << share << ' ' << block;
        EXPECT_FALSE(result.finished) << robot << ' ' << share << ' ' << block;
      }
    }
  }
}

/// Faults that doubt a place which is right.
constexpr FaultMask kOfTheEnvelope = fault_bit(Fault::camera_against_odometry) |
                                     fault_bit(Fault::world_against_odometry) |
                                     fault_bit(Fault::fence) | fault_bit(Fault::cross_track);

/// Healthy runs of one seed: every camera, or none, on every course, each with another robot.
class Healthy : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(One, Healthy, testing::Values(1));
INSTANTIATE_TEST_SUITE_P(Nightly, Healthy, testing::Range<std::uint64_t>(2, 62));

TEST_P(Healthy, RunsAreNotDoubted) {
  std::size_t i = GetParam();
  for (const std::string camera : {"", "overhead", "rough"}) {
    for (const std::string course : kCourses) {
      std::string robot = kRobots[++i % kRobots.size()];
      const std::string setup = i % 4 < 2 ? "flat" : camera.empty() ? "stand" : "terrain";
      if (!drives(robot, course, setup)) robot = "uniform";
      LockstepSettings run =
          settings(course, loaded(robot, setup),
                   camera.empty() ? PoseSource::kOdometry : kSteering[i % 2], GetParam());
      run.robot.emulated.floor = i % 3 == 0 ? course::Floor::kEven : course::Floor::kUneven;
      if (!camera.empty()) run.camera = load_camera(camera);
      struct : messages::Sink {
        void take(const StepRecord& record) override { faults |= record.snapshot.faults; }
        FaultMask faults = 0;
      } seen;
      run.sinks = {&seen};
      const report::RunResult result = run_lockstep(run);
      EXPECT_EQ(seen.faults & kOfTheEnvelope, 0u) << camera << ", course " << course << ", "
                                                  << robot << ", " << setup << ": " << result.cause;
    }
  }
}

}  // namespace
}  // namespace tp100::sim
