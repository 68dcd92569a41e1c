#pragma once
// The step: samples in, pose and command out. The same object runs live, in lockstep and in replay.
// Pure: no clock, no port, no file; no allocation after construction; safe in the real-time thread.

#include <cstdint>
#include <memory>
#include <span>

#include "bridge/parameters.h"
#include "core/camera_sample.h"
#include "core/link_state.h"
#include "core/parameter_change.h"
#include "core/snapshot.h"
#include "core/world_sample.h"
#include "course/path.h"

namespace tp100::bridge {

/// What happened since the last step.
struct Inputs {
  std::span<const Sample> samples{};            ///< oldest first; may be empty
  std::span<const OperatorRequest> requests{};  ///< oldest first
  std::span<const CameraSample> camera{};       ///< as they arrived; empty without a camera
  std::span<const WorldSample> world{};         ///< oldest first; empty without an external world
  std::span<const ParameterChange> changes{};   ///< oldest first; before the requests
  SessionState session = SessionState::kClosed;
  ClockState clock{};
  std::uint32_t session_number = 0;             ///< +1 each time a session becomes ready
  bool robot_rebooted = false;                  ///< a new boot nonce since the last step
  RequestAnswer answer = RequestAnswer::kNone;  ///< to the last arm or disarm
};

/// What to do now.
struct Outputs {
  bool command_valid = false;  ///< false: send nothing (no session, no sample yet)
  Command command{};
  RobotRequest request = RobotRequest::kNone;  ///< hand to the link once
  StartRefusal refused = StartRefusal::kNone;  ///< a start was refused in this step
  bool disarming = false;  ///< the end of a run is not confirmed yet, or motors are on unasked
  Snapshot snapshot{};
};

class Step {
 public:
  /// `course` may be null: poses only, the robot stands still. Throws SetupError if parameters and
  /// course do not fit together.
  Step(const Parameters& parameters, std::shared_ptr<const course::Course> course);
  ~Step();
  Step(Step&&) noexcept;

  /// One step at host time `now`. The reference stays valid until the next call.
  const Outputs& operator()(const Inputs& inputs, HostNs now);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::bridge
