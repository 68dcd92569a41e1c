#pragma once
// One course in virtual time: the daemon's cycle and the emulated robot in one process, exchanging
// the same bytes as over a cable.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "core/sample.h"
#include "core/time.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "link/session.h"
#include "messages/sink.h"
#include "report/run_result.h"
#include "sim/robot/emulated_robot.h"

namespace tp100::sim {

struct LockstepSettings {
  course::Course course{};
  course::Robot robot{};
  config::Configuration configuration{};
  bridge::Setup setup = bridge::Setup::kFlat;
  BoardKind board = BoardKind::kNative;
  std::optional<course::EmulatedCamera> camera{};  ///< none: no camera
  /// Detections by a camera of this same drive, in order, with times since its beginning; used
  /// instead of `camera`. They arrive kDetectionDelayNs after their image.
  std::vector<CameraSample> detections{};
  std::function<void(CameraSample&)> misread{};  ///< changes every sample of either camera
  /// True: the world at the configuration's address; false: always the course's own.
  bool external_world = false;
  /// A world within this process, in place of the one at the address: its answer to a step, sent at
  /// once.
  std::function<WorldSample(const StepRecord&)> world{};
  std::uint64_t seed = 1;
  std::uint32_t start_us = 0;          ///< device clock at boot; near 2^32 it wraps during the run
  std::vector<PlannedFault> faults{};  ///< of the robot, its cable and the host
  std::function<void(const EmulatedRobot&)> watch{};  ///< sees the robot after every physics step
  std::vector<messages::Sink*> sinks{};               ///< receive every step
  std::vector<messages::TruthSink*> truth_sinks{};    ///< ... at each new sample's instant
  std::function<void(HostNs)> on_disturbance{};       ///< hears of the beginning of each
  /// Receives the session's events, with the robot's hello if it is known.
  std::function<void(const link::SessionEvent&, const wire::Hello&)> on_session_event{};
  bool host_checks_encoders = true;  ///< false: only the robot compares them with duty and gyro
  double begin_within_s = 10.0;      ///< a run that does not begin within this time has failed

  /// `sink` receives every step and the truth.
  void add(auto& sink) {
    sinks.push_back(&sink);
    truth_sinks.push_back(&sink);
  }
};

inline constexpr HostNs kDetectionDelayNs = 60 * kNsPerMs;

/// Drives the course once. On a stand no camera is used, because the robot does not move.
/// Deterministic except for `realtime_factor` and `loop`. Throws UserError if course and robot do
/// not fit together.
report::RunResult run_lockstep(const LockstepSettings& settings);

/// Drives the course twice without restarting anything: half a second after the first run ended,
/// but not before `again_s` after the port was opened, the robot is taken back to the start and
/// started again. Counters are those of the whole session.
struct TwoRuns {
  report::RunResult first{};
  report::RunResult again{};
};
TwoRuns run_lockstep_twice(const LockstepSettings& settings, double again_s);

}  // namespace tp100::sim
