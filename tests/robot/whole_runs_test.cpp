// Whole runs in virtual time: what happened in each, and a hash of its poses, figures and commands,
// must be as tests/robot/whole_runs.txt says. A change of the product that changes the behaviour of
// a robot, however little, changes a line of that file. `scripts/test --accept` writes it anew.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/faults.h"
#include "course/path.h"
#include "hand_driven.h"
#include "runs.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

const std::string kFile = source_path("tests/robot/whole_runs.txt");

/// A hash of every pose, figure and command of a run (FNV-1a, 64 bits).
class Hash : public messages::Sink {
 public:
  void take(const StepRecord& record) override {
    const Snapshot& snapshot = record.snapshot;
    for (const PoseSource source : kPoseSources) add(snapshot.estimates[source].pose);
    for (const PoseSource source : kPoseSources) {
      add(snapshot.estimates[source].covariance.xx);
      add(snapshot.estimates[source].covariance.yaw_yaw);
    }
    add(snapshot.world);
    for (const double figure : {snapshot.left_mps, snapshot.right_mps, snapshot.slip_left,
                                snapshot.slip_right, snapshot.cross_track_m, snapshot.progress_m,
                                snapshot.gyro_bias_radps, snapshot.imu_pitch_rad})
      add(figure);
    add(snapshot.command.desired_yaw_rad);
    add(snapshot.command.yaw_rate_radps);
    add(snapshot.command.speed_mps);
    add(static_cast<double>(record.command_valid));
    add(static_cast<double>(record.request));
    add(static_cast<double>(snapshot.run_state));
  }
  std::uint64_t value() const { return value_; }

 private:
  void add(const Pose& pose) {
    for (const double part :
         {pose.x_m, pose.y_m, pose.z_m, pose.roll_rad, pose.pitch_rad, pose.yaw_rad})
      add(part);
  }
  void add(double number) {
    for (const std::uint8_t byte : std::bit_cast<std::array<std::uint8_t, 8>>(number))
      value_ = (value_ ^ byte) * 0x100000001b3;
  }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// What happened in a run.
struct Outcome {
  double driven_m = 0.0;     ///< by the true robot
  double deviation_m = 0.0;  ///< its largest distance from the path; by hand, of the steering pose
                             ///< from it
  std::string end;           ///< how the run ended, and why
  std::uint64_t hash = 0;
};

struct WholeRun {
  std::string name;
  std::function<Outcome()> drive;
};

Outcome outcome(const report::RunResult& result, const course::Course& course) {
  const course::Path path(course);
  Outcome out;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const Pose &world = result.points[i].world, &truth = result.points[i].truth;
    out.deviation_m =
        std::max(out.deviation_m, path.distance(world.x_m, world.y_m, 0.0, path.length_m()));
    if (i == 0) continue;
    const Pose& before = result.points[i - 1].truth;
    out.driven_m += std::hypot(truth.x_m - before.x_m, truth.y_m - before.y_m);
  }
  out.end = result.completed ? "completed" : result.cause;
  return out;
}

/// Changes of a run's settings.
using Change = std::function<void(LockstepSettings&)>;

/// A run on a course.
WholeRun on(const std::string& course, const Options& options, const std::string& what = {},
            const Change& change = {},
            report::RunResult (*drive)(const LockstepSettings&) = run_lockstep) {
  return {"course " + course + ", " + options.robot + (what.empty() ? "" : ", " + what), [=] {
            LockstepSettings run = run_of(course, load(options));
            if (change) change(run);
            Hash hash;
            run.sinks = {&hash};
            Outcome out = outcome(drive(run), run.course);
            out.hash = hash.value();
            return out;
          }};
}

/// The second of two runs, without a restart of anything between them.
report::RunResult drive_again(const LockstepSettings& run) {
  return run_lockstep_twice(run, 120.0).again;
}

Change law(control::LawName name) {
  return [=](LockstepSettings& run) { run.configuration.parameters.control.law = name; };
}
Change steered_by(PoseSource source, const std::string& camera = {}, const Change& change = {}) {
  return [=](LockstepSettings& run) {
    run.configuration.parameters.steering = source;
    if (!camera.empty()) run.camera = load_camera(camera);
    if (change) change(run);
  };
}
Change faults(const std::vector<std::string>& texts) {
  return [=](LockstepSettings& run) { run.faults = parse_faults(texts); };
}

/// A world that answers each step; `answer` changes what a flat floor would be.
Change world(const std::function<void(WorldSample&, double t_s)>& answer, bool owns_pose) {
  return [=](LockstepSettings& run) {
    const PoseSource steering = run.configuration.parameters.steering;
    run.configuration.parameters.world.owns_pose = owns_pose;
    run.world = [=](const StepRecord& record) {
      WorldSample sample{.session = 1,
                         .answered_ns = record.now_ns,
                         .has_ground = true,
                         .has_pose = owns_pose,
                         .pose = record.snapshot.estimates[steering].pose};
      answer(sample, to_s(record.now_ns));
      return sample;
    };
  };
}

/// A driver's hand for a while; `age_s`: of the input when it arrives.
struct Hand {
  double duration_s, speed_mps, yaw_rate_radps, age_s = 0.0;
};

/// A robot on the floor of a course, and what a person does with it.
WholeRun by_hand(const std::string& what, const Options& options, const std::string& course,
                 const std::function<void(HandDriven&)>& person) {
  return {"by hand, " + options.robot + ", " + what, [=] {
            Hash hash;
            const auto floor = std::make_shared<const course::Course>(load_course(course));
            HandDriven drive({.loaded = load(options), .course = floor, .sink = &hash});
            Outcome out;
            Pose before = drive.robot().truth().pose;
            drive.after_physics = [&] {
              const Pose& truth = drive.robot().truth().pose;
              out.driven_m += std::hypot(truth.x_m - before.x_m, truth.y_m - before.y_m);
              before = truth;
            };
            drive.after_step = [&](const StepRecord& record) {
              const Pose& pose = record.snapshot.estimates[record.snapshot.steering].pose;
              out.deviation_m = std::max(out.deviation_m,
                                         std::hypot(pose.x_m - before.x_m, pose.y_m - before.y_m));
            };
            EXPECT_TRUE(drive.wait_until_ready());
            person(drive);
            const std::optional<Fault> fault = first_fault(drive.record().snapshot.faults);
            out.end = std::string(to_string(drive.state())) +
                      (fault ? ", " + std::string(describe(*fault).name) : "");
            out.hash = hash.value();
            return out;
          }};
}

/// Takes the lease and moves the hand.
void move(HandDriven& drive, const std::vector<Hand>& hands) {
  const std::string token = drive.take(1);
  for (const Hand& hand : hands) {
    drive.before_step = [&](HostNs) {
      drive.drive(1, token, hand.speed_mps, hand.yaw_rate_radps, hand.age_s);
    };
    drive.step_for(hand.duration_s);
  }
  drive.before_step = {};
}

/// Starts the course and drives up to a place on it.
void start(HandDriven& drive, double up_to_m) {
  drive.request(OperatorRequest::kStart);
  drive.step_until([&] { return drive.record().snapshot.progress_m > up_to_m; }, 60.0);
}
void drive_to_the_end(HandDriven& drive) {
  drive.step_until([&] { return !under_way(drive.state()); }, 120.0);
}

const std::vector<WholeRun>& runs() {
  using enum PoseSource;
  static const std::vector<WholeRun> all = {
      on("1-straight", {.robot = "end-loaded"}),
      on("1-curve", {.robot = "uniform"}),
      on("1-sharp", {.robot = "front-heavy"}),
      on("1-sharp", {.robot = "worn"}),
      on("2", {.robot = "slippery"}),
      on("2", {.robot = "large"}),
      on("3", {.robot = "end-loaded"}),
      on("3", {.robot = "uniform", .setup = "terrain"}, "terrain"),
      on("3", {.robot = "worn", .setup = "stand"}, "stand"),
      on("calibrate-spin-left", {.robot = "uniform"}),
      on("calibrate-tight-right", {.robot = "large"}),
      on("3", {.robot = "uniform"}, "a second time", {}, drive_again),
  // boards, bodies, floors
#ifdef TP100_HAS_IMAGE
      on("1-straight", {.board = "avr", .robot = "end-loaded"}, "the chip"),
#endif
      on("1-sharp", {.body = "shear", .robot = "uniform"}, "sheared contact",
         [](LockstepSettings& run) {
           run.robot.model = {.slip_left = 0.001, .slip_right = 0.001, .wheelbase_m = 0.178};
         }),
      on("2", {.floor = "uneven", .robot = "end-loaded"}, "uneven floor"),
      // laws, rates, estimates
      on("2", {.robot = "end-loaded"}, "pure pursuit", law(control::LawName::kPurePursuit)),
      on("2", {.robot = "end-loaded"}, "LQR", law(control::LawName::kLqr)),
      on("1-sharp", {.robot = "end-loaded"}, "100 Hz",
         [](LockstepSettings& run) { run.configuration.loop.rate_hz = 100.0; }),
      on("1-sharp", {.robot = "uniform"}, "steered by the model", steered_by(kModel)),
      on("2", {.robot = "uniform"}, "camera steers", steered_by(kFused, "overhead")),
      on("3", {.robot = "end-loaded", .setup = "terrain"}, "terrain, poor camera steers",
         steered_by(kFused, "rough")),
      on("1-sharp", {.robot = "end-loaded"}, "camera stands still",
         steered_by(kFused, "overhead",
                    [](LockstepSettings& run) {
                      run.misread = [](CameraSample& seen) { seen.x_m = std::min(seen.x_m, 0.2); };
                    })),
      // external worlds
      on("1-curve", {.robot = "end-loaded"}, "world with a slope",
         world([](WorldSample& answer, double) { answer.pitch_rad = -0.1; }, false)),
      on("1-curve", {.robot = "end-loaded"}, "world owns the pose",
         world([](WorldSample& answer, double) { answer.pose.pitch_rad = -0.02; }, true)),
      on("1-straight", {.robot = "end-loaded"}, "world turns the robot round",
         world([](WorldSample& answer, double) { answer.pose.x_m *= -1.0; }, true)),
      on("1-straight", {.robot = "end-loaded"}, "world falls silent",
         world(
             [](WorldSample& answer, double t_s) {
               if (t_s > 6.0) answer.answered_ns = 6 * kNsPerS;
             },
             false)),
      // pushes and faults of cable, robot and host
      on("1-straight", {.robot = "uniform"}, "pushed hard",
         [](LockstepSettings& run) {
           run.course.disturbances = {
               {.at_m = 0.3, .sideways_m = -0.06, .yaw_rad = 0.4, .duration_s = 0.2}};
         }),
      on("1-sharp", {.robot = "end-loaded"}, "bits flipped, bytes lost",
         faults({"flip:0.0005", "drop:0.0005"})),
      on("1-curve", {.robot = "end-loaded"}, "late bytes, device clock drifts, wraps",
         faults({"jitter:8", "drift:200", "wrap@5"})),
      on("1-curve", {.robot = "end-loaded"}, "host stalls", faults({"host-stall:300@6"})),
      on("1-curve", {.robot = "end-loaded"}, "unplugged", faults({"unplug:1@6"})),
      on("1-curve", {.robot = "end-loaded"}, "board restarts", faults({"reboot@6"})),
      on("1-straight", {.robot = "end-loaded"}, "encoder stuck", faults({"encoder-stuck:left@6"})),
      on("1-straight", {.robot = "end-loaded"}, "encoder loses edges",
         faults({"encoder-lose:0.3:right@4"})),
      on("1-curve", {.robot = "end-loaded"}, "gyro frozen", faults({"imu-frozen@6"})),
      on("1-straight", {.robot = "end-loaded"}, "battery empty", faults({"battery:5.5@6"})),
      on("1-straight", {.robot = "end-loaded"}, "motor reversed",
         [](LockstepSettings& run) { run.robot.drive.invert_right_motor = true; }),
      on("1-straight", {.robot = "end-loaded"}, "slip unknown",
         [](LockstepSettings& run) { run.robot.model = {}; }),
      // people
      by_hand(
          "turns and reverses", {.robot = "end-loaded"}, "2",
          [](HandDriven& drive) {
            move(drive, {{3.0, 0.1, 0.0}, {3.0, 0.1, 0.5}, {2.0, 0.0, -0.8}, {3.0, -0.08, 0.1}});
          }),
      by_hand("against the fence", {.robot = "slippery"}, "1-straight",
              [](HandDriven& drive) {
                move(drive, {{14.0, 0.2, 0.1}, {4.0, -0.1, 0.0}});
              }),
      by_hand("with late input, then silent", {.robot = "large"}, "2",
              [](HandDriven& drive) {
                move(drive, {{3.0, 0.1, 0.0, 0.12}, {1.0, 0.1, 0.3, 0.16}});
                drive.step_for(3.0);
              }),
      by_hand("STOP", {.robot = "uniform"}, "2",
              [](HandDriven& drive) {
                move(drive, {{2.0, 0.15, 0.2}});
                drive.request(OperatorRequest::kStop);
                drive.step_for(1.0);
              }),
      by_hand("course 2 paused and resumed", {.robot = "end-loaded"}, "2",
              [](HandDriven& drive) {
                start(drive, 0.5);
                drive.request(OperatorRequest::kPause);
                drive.step_for(5.0);
                drive.request(OperatorRequest::kResume);
                drive_to_the_end(drive);
              }),
      by_hand("course 1-curve held and continued", {.robot = "uniform"}, "1-curve",
              [](HandDriven& drive) {
                start(drive, 0.4);
                drive.request(OperatorRequest::kHold);
                drive.step_for(2.0);
                drive.request(OperatorRequest::kContinue);
                drive.step_for(0.5);
                drive_to_the_end(drive);
              }),
  };
  return all;
}

std::string line_of(const WholeRun& run, const Outcome& out) {
  std::ostringstream line;
  line << std::left << std::setw(64) << run.name << std::right << std::fixed << std::setprecision(3)
       << std::setw(8) << out.driven_m << std::setprecision(4) << std::setw(12) << out.deviation_m
       << "  " << std::left << std::setw(34) << out.end << std::right << std::hex
       << std::setfill('0') << std::setw(16) << out.hash;
  return line.str();
}

std::string without_hash(const std::string& line) { return line.substr(0, line.rfind(' ')); }

bool accepting() { return std::getenv("TP100_ACCEPT") != nullptr; }

class WholeRuns : public testing::TestWithParam<std::size_t> {
 protected:
  static void TearDownTestSuite() {
    if (!accepting() || accepted().size() != runs().size()) return;
    std::ofstream file(kFile);
    file << "# What happened in each whole run of whole_runs_test.cpp, and a hash of all its poses "
            "and commands. Another hash\n# beside the same figures: same behaviour, other bits. "
            "Written by scripts/test --accept.\n# driven_m: by the true robot. deviation_m: its "
            "largest distance from the path; by hand, of the steering pose from it.\n"
         << std::left << std::setw(64) << "# run"
         << "driven_m deviation_m  " << std::setw(34) << "end"
         << "hash\n";
    for (const auto& [index, line] : accepted()) file << line << '\n';
  }
  static std::map<std::size_t, std::string>& accepted() {
    static std::map<std::size_t, std::string> lines;
    return lines;
  }
};

TEST_P(WholeRuns, HappenAsTheyDidBefore) {
  const WholeRun& run = runs()[GetParam()];
  const std::string is = line_of(run, run.drive());
  if (accepting()) {
    accepted()[GetParam()] = is;
    return;
  }
  std::ifstream file(kFile);
  std::string was;
  while (std::getline(file, was) && was.compare(0, 64, is, 0, 64) != 0) continue;
  if (was == is) return;
  FAIL() << run.name << ": "
         << (was.empty()                             ? "a run that the file does not have"
             : without_hash(was) == without_hash(is) ? "same behaviour, other bits"
                                                     : "another behaviour")
         << "\n  was " << was << "\n  is  " << is
         << "\nIf that is intended: scripts/test --accept, and review the difference.";
}

INSTANTIATE_TEST_SUITE_P(All, WholeRuns, testing::Range(std::size_t{0}, runs().size()),
                         [](const testing::TestParamInfo<std::size_t>& param) {
                           std::string name;
                           for (const char sign : runs()[param.param].name)
                             if (std::isalnum(static_cast<unsigned char>(sign)) != 0) name += sign;
                           return name;
                         });

}  // namespace
}  // namespace tp100::sim

// With fused multiply-add the C library's sines have other last bits. The hashes must hold on every
// processor, so the program starts again without it: this variable is read before main().
int main(int argc, char** argv) {
  constexpr const char* kVariable = "GLIBC_TUNABLES";
  if (std::getenv(kVariable) == nullptr) {
    setenv(kVariable, "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4", 1);
    execv("/proc/self/exe", argv);
    return EXIT_FAILURE;
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
