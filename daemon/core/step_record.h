#pragma once
// One step with everything that went in and came out, as plain data of fixed size: what the
// real-time thread hands to recorders and viewers.

#include <cstdint>

#include "core/bounded_list.h"
#include "core/carried_state.h"
#include "core/command.h"
#include "core/link_state.h"
#include "core/sample.h"
#include "core/snapshot.h"

namespace tp100 {

/// What happened since the last step. It is filled by the cycle, taken by the step, recorded and
/// replayed as it is.
struct StepInputs {
  using Samples = BoundedList<Sample, 64>;
  using Camera = BoundedList<CameraSample, 8>;
  using Changes = BoundedList<ParameterChange, 8>;
  using Velocities = BoundedList<VelocityInput, 8>;

  BoundedList<CarriedState, 1> restart{};  ///< before anything else, the step restarts with this
  Samples samples{};                       ///< oldest first; may be empty
  BoundedList<OperatorRequest, 16> requests{};  ///< oldest first
  Camera camera{};                              ///< as they arrived; empty without a camera
  BoundedList<WorldSample, 8> world{};          ///< oldest first; empty without an external world
  Changes changes{};                            ///< oldest first; applied before the requests
  Velocities velocities{};  ///< oldest first; empty unless the robot is driven by hand
  SessionState session = SessionState::kClosed;
  ClockState clock{};
  std::uint32_t session_number = 0;             ///< +1 each time a session becomes ready
  bool robot_rebooted = false;                  ///< a new boot nonce since the last step
  RequestAnswer answer = RequestAnswer::kNone;  ///< to the last arm or disarm
};

/// Inputs and results of one step. Replaying the inputs in order through a step with the same
/// parameters and course gives the same results bit for bit (same build).
struct StepRecord {
  HostNs now_ns = 0;
  std::uint64_t step = 0;  ///< counts the steps since the start; a gap is a dropped record
  StepInputs inputs{};

  LinkCounters link{};         ///< counters after the step
  bool command_valid = false;  ///< snapshot.command was sent
  RobotRequest request = RobotRequest::kNone;
  Snapshot snapshot{};
};

}  // namespace tp100
