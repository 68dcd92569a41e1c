#pragma once
// One step with everything that went in and came out, as plain data of fixed size: what the
// real-time thread hands to recorders and viewers.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/camera_sample.h"
#include "core/command.h"
#include "core/link_state.h"
#include "core/parameter_change.h"
#include "core/sample.h"
#include "core/snapshot.h"
#include "core/world_sample.h"

namespace tp100 {

/// Inputs and results of one step. Replaying the inputs in order through a step with the same
/// parameters and course gives the same results bit for bit (same build). Only the first
/// `*_count` entries of each array are meaningful.
struct StepRecord {
  static constexpr std::size_t kMaxSamples = 64;
  static constexpr std::size_t kMaxRequests = 16;
  static constexpr std::size_t kMaxCamera = 8;
  static constexpr std::size_t kMaxWorld = 8;
  static constexpr std::size_t kMaxChanges = 8;

  HostNs now_ns = 0;
  std::uint64_t step = 0;  ///< counts the steps since the start; a gap is a dropped record

  std::array<Sample, kMaxSamples> samples{};  ///< oldest first
  std::uint32_t sample_count = 0;
  std::array<OperatorRequest, kMaxRequests> requests{};
  std::uint32_t request_count = 0;
  std::array<CameraSample, kMaxCamera> camera{};
  std::uint32_t camera_count = 0;
  std::array<WorldSample, kMaxWorld> world{};
  std::uint32_t world_count = 0;
  std::array<ParameterChange, kMaxChanges> changes{};
  std::uint32_t change_count = 0;
  SessionState session = SessionState::kClosed;
  ClockState clock{};
  std::uint32_t session_number = 0;
  bool robot_rebooted = false;
  RequestAnswer answer = RequestAnswer::kNone;

  LinkCounters link{};         ///< counters after the step
  bool command_valid = false;  ///< snapshot.command was sent
  RobotRequest request = RobotRequest::kNone;
  Snapshot snapshot{};
};

}  // namespace tp100
