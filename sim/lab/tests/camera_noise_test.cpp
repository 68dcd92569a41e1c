// The camera's noise in the filter, beside that of an emulated camera on whole runs.
#include <gtest/gtest.h>

#include <string>

#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

/// NIS of the camera over several runs together, whose noise is `noise_factor` times the assumed.
report::CameraFigures nis(const std::string& robot, double noise_factor) {
  Options options;
  options.robot = robot;
  LockstepSettings run{.course = load_course("1-curve"),
                       .robot = load(options).robot,
                       .camera = load_camera("overhead")};
  run.configuration.parameters.steering = PoseSource::kFused;
  run.camera->noise_m *= noise_factor;
  run.camera->noise_rad *= noise_factor;
  report::CameraFigures all;
  for (run.seed = 1; run.seed <= 3; ++run.seed) {
    const report::CameraFigures one = run_lockstep(run).camera;
    all.nis_mean =
        (all.nis_mean * all.judged + one.nis_mean * one.judged) / (all.judged + one.judged);
    all.judged += one.judged;
  }
  return all;
}

// The filter allows for changing slip, which these runs do not have: it may be 5 % too cautious,
// but never overconfident. A better and a worse camera leave the band.
TEST(CameraNoise, IsWhatTheFilterAssumesOnRobotsOfEveryKind) {
  constexpr double kCautious = 0.15;
  for (const char* robot : {"end-loaded", "uniform", "slippery"}) {
    const report::CameraFigures of = nis(robot, 1.0);
    EXPECT_GT(of.nis_mean, 3.0 - of.nis_half_band() - kCautious) << robot;
    EXPECT_LT(of.nis_mean, 3.0 + of.nis_half_band()) << robot;
  }
  const report::CameraFigures better = nis("end-loaded", 0.8), worse = nis("end-loaded", 1.25);
  EXPECT_LT(better.nis_mean, 3.0 - 3.0 * better.nis_half_band());
  EXPECT_GT(worse.nis_mean, 3.0 + 3.0 * worse.nis_half_band());
}

}  // namespace
}  // namespace tp100::sim
