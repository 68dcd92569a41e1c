#include "sim/lab/state_study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/arithmetic.h"
#include "model/step_climb.h"
#include "sim/body/ode_body.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"
#include "terrain/climbable.h"
#include "terrain/terrain_follower.h"

namespace tp100::sim {
namespace {

constexpr double kRunUpM = 0.05;
constexpr double kBehindM = 0.10;
constexpr double kLittleCreep = 0.005;
constexpr double kFriction = 1.2;

course::EmulatedBody with_traction(course::EmulatedBody body) {
  body.track_deficit_left = body.track_deficit_right = 0.0;
  body.creep_left = body.creep_right = kLittleCreep;
  body.friction = kFriction;
  return body;
}

constexpr double kBlockHeightsM[] = {0.020, 0.025, 0.030, 0.037};
constexpr double kBlockDepthsM[] = {0.10, 0.20};

double slowest_s(const TrialRun& run) {
  double slowest = 0.0;
  for (const SlopeChange& change : run.slope.changes)
    slowest = std::max(slowest, change.found_s.value_or(std::numeric_limits<double>::infinity()));
  return slowest;
}

double off_nis(const TrialRun& run) { return std::abs(run.result.camera.nis_mean - kNisDegrees); }

/// Judges the largest value of a figure over all runs: no run may exceed the limit.
Judged worst(const CourseStudy& study, const std::vector<TrialRun>& runs, const char* what,
             const char* unit, double limit, double (*figure)(const TrialRun&)) {
  double largest = 0.0;
  for (const TrialRun& run : runs) largest = std::max(largest, figure(run));
  return judged_value(study, what, unit, limit, largest);
}

Judged typical(const CourseStudy& study, const std::vector<TrialRun>& runs, const char* what,
               const char* unit, double limit, double (*figure)(const TrialRun&)) {
  return {study.course, study.robot, what, unit, limit, spread_of(runs, figure)};
}

CourseStudy study_of(const std::string& course, const course::Robot& robot, bridge::Setup setup,
                     const std::vector<TrialRun>& runs) {
  CourseStudy study;
  study.course = course;
  study.robot = robot.name;
  study.setup = bridge::to_string(setup);
  study.board = to_string(BoardKind::kNative);
  study.runs = static_cast<int>(runs.size());
  study.completed = completed(runs);
  return study;
}

double false_changes(const TrialRun& run) { return run.slope.false_changes; }

CourseStudy study_flat(const course::Robot& robot, std::uint64_t first_seed, int runs) {
  std::vector<TrialRun> all;
  for (const char* kind : kPaperCourses) {
    for (TrialRun& run : run_trial({.course = load_course(kind),
                         .robot = robot,
                         .setup = bridge::Setup::kFlat,
                         .first_seed = first_seed,
                         .runs = runs,
                         .both_directions = false})) {
      run.result.points.clear();
      all.push_back(std::move(run));
    }
  }
  CourseStudy study = study_of("all, on a flat floor", robot, bridge::Setup::kFlat, all);
  study.judged.push_back(
      worst(study, all, "false changes of the slope's state, most", "", 0.0, false_changes));
  study.judged.push_back(typical(study, all, "camera NIS, mean off 3", "", 0.25, off_nis));
  return study;
}

CourseStudy study_obstacles(const course::Robot& robot, std::uint64_t first_seed, int runs) {
  const std::vector<TrialRun> all = run_trial({.course = load_course("3"),
                                               .robot = robot,
                                               .setup = bridge::Setup::kTerrain,
                                               .first_seed = first_seed,
                                               .runs = runs});
  CourseStudy study = study_of("3, state", robot, bridge::Setup::kTerrain, all);
  study.judged = {
      typical(study, all, "IMU pitch on ramps, max error", "deg", 1.5,
              [](const TrialRun& r) { return r.slope.ramp_pitch_max_error_rad * kDegPerRad; }),
      typical(study, all, "slope passes 4 deg: found after, slowest", "s", 0.3, slowest_s),
      worst(study, all, "false changes of the slope's state, most", "", 0.0, false_changes),
      worst(study, all, "ramp for step or step for ramp, most", "", 0.0,
            [](const TrialRun& r) { return static_cast<double>(r.slope.mistaken); }),
      typical(study, all, "camera NIS, mean off 3", "", -1.0, off_nis)};
  return study;
}

CourseStudy study_climb(const course::Robot& robot) {
  CourseStudy study = study_of("step without slip", robot, bridge::Setup::kTerrain, {});
  double rms_rad = 0.0, max_rad = 0.0;
  for (const double height_m : kBlockHeightsM) {
    for (const double depth_m : kBlockDepthsM) {
      const ClimbCheck check = check_climb_pitch(robot, height_m, depth_m, kSlopeTrackMps);
      ++study.runs;
      if (check.crossed) ++study.completed;
      rms_rad = std::max(rms_rad, check.pitch_rms_rad);
      max_rad = std::max(max_rad, check.pitch_max_rad);
    }
  }
  const auto judged = [&](const char* what, double limit, double value_rad) {
    study.judged.push_back(judged_value(study, what, "deg", limit, value_rad * kDegPerRad));
  };
  judged("model pitch against the body, rms", 2.0, rms_rad);
  judged("model pitch against the body, max", -1.0, max_rad);
  return study;
}

/// Computes the errors from the samples, without the level drive before and behind the block.
void judge_phases(ClimbCheck& check) {
  double squares = 0.0, phase_squares = 0.0, paper_squares = 0.0;
  std::size_t count = 0, phase_count = 0;
  for (const ClimbSample& sample : check.samples) {
    const double off = sample.model_rad - sample.body_rad;
    const double paper_off = sample.paper_rad - sample.body_rad;
    const bool level = sample.phase == model::ClimbPhase::kApproach ||
                       (sample.phase == model::ClimbPhase::kDown && std::abs(off) < 1e-3);
    if (level) continue;
    if (check.phases.empty() || check.phases.back().phase != sample.phase) {
      check.phases.push_back({.phase = sample.phase, .from_m = sample.travel_m});
      phase_squares = paper_squares = 0.0;
      phase_count = 0;
    }
    check.pitch_max_rad = std::max(check.pitch_max_rad, std::abs(off));
    squares += off * off;
    phase_squares += off * off;
    paper_squares += paper_off * paper_off;
    ++count;
    ++phase_count;
    ClimbPhaseCheck& phase = check.phases.back();
    phase.model_rms_rad = std::sqrt(phase_squares / static_cast<double>(phase_count));
    phase.paper_rms_rad = std::sqrt(paper_squares / static_cast<double>(phase_count));
  }
  if (count > 0) check.pitch_rms_rad = std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

ClimbCheck check_climb_pitch(const course::Robot& robot, double height_m, double depth_m,
                             double track_mps) {
  const course::EmulatedBody values = with_traction(robot.emulated.body);
  const model::ClimbGeometry geometry = terrain::climb_geometry(robot.shape);
  const model::BlockShape shape = {.height_m = height_m, .depth_m = depth_m};
  model::StepClimb climb(geometry, shape);
  climb.begin(kRunUpM);
  // Eq 6, asin(s / L_a), comes to the edge sooner; from there on the climb is the same.
  model::StepClimb paper = climb;
  const double paper_riser_m = std::max(height_m - geometry.wheel_radius_m, 0.0);
  const double sooner_m = climb.curve().marks().riser_end - paper_riser_m;
  paper.begin(kRunUpM - sooner_m);
  const auto paper_rad = [&](double travel_m) {
    if (travel_m >= paper_riser_m) return paper.state().pitch_rad;
    return -std::asin(std::max(travel_m, 0.0) / geometry.axle_spacing_m);
  };
  course::Block block{};
  block.place.x_m = kRunUpM - climb.touch_x_m() + depth_m / 2.0;
  block.height_m = height_m;
  block.depth_m = depth_m;
  block.width_m = 4.0 * values.gauge_m;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(block);
  OdeBody body(values, {}, false, terrain);

  const double distance_m = kRunUpM + depth_m + 2.0 * values.length_m + kBehindM;
  const double dt_s = 1e-9 * static_cast<double>(kPhysicsStepNs);
  const auto steps = static_cast<std::size_t>(distance_m / track_mps / dt_s);
  ClimbCheck check;
  check.height_m = height_m;
  check.depth_m = depth_m;
  check.samples.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    body.step(track_mps, track_mps);
    const model::ClimbState& state = climb.advance(track_mps * dt_s, dt_s);
    paper.advance(track_mps * dt_s, dt_s);
    const double travel_m = static_cast<double>(i + 1) * track_mps * dt_s - kRunUpM;
    check.samples.push_back({.travel_m = travel_m,
                             .phase = state.phase,
                             .body_rad = body.state().pose.pitch_rad,
                             .model_rad = state.pitch_rad,
                             .paper_rad = paper_rad(travel_m)});
  }
  judge_phases(check);
  check.crossed = body.state().pose.x_m > block.place.x_m + depth_m / 2.0;
  return check;
}

std::vector<CourseStudy> study_state(const course::Robot& robot, std::uint64_t first_seed,
                                     int runs) {
  return {study_flat(robot, first_seed, runs), study_obstacles(robot, first_seed, runs),
          study_climb(robot)};
}

}  // namespace tp100::sim
