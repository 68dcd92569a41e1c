#pragma once
// Session and step joined: bytes and time in, bytes out. The same object runs in the live loop and
// in lockstep with the emulated robot. No clock, port or file; no allocation after construction.
//
// One cycle:  session().receive(bytes, now)...  step(now)  session().output() → port

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "bridge/step.h"
#include "core/step_record.h"
#include "link/session.h"

namespace tp100::bridge {

/// Session settings for this robot: wire parameters of the bridge's drive and model values. Values
/// that the firmware would refuse are sent as they are; the refusal names the field. On a `course`
/// that identifies the robot the slip of turns is unknown, so the firmware does not judge turns.
link::SessionSettings session_settings(const bridge::Parameters& parameters,
                                       const course::Course* course = nullptr);

/// Name of a field of wire::Parameters by its index, as a refusal reports it; "unknown" beyond the
/// last.
const char* parameter_name(unsigned index);

/// What an operator changes between two runs.
struct SetupChange {
  std::optional<Step> step{};  ///< with another course, robot or set-up
  /// Of that step, if they are others than the robot has: a new session begins.
  std::optional<wire::Parameters> parameters{};
  std::optional<Pose> place{};  ///< where the robot is now
};

class Cycle {
 public:
  /// At standstill the step restarts this often, so that a recording that begins later needs no
  /// inputs from before.
  static constexpr HostNs kRestartPeriodNs = 60 * kNsPerS;

  /// Throws SetupError if parameters and course do not fit together.
  Cycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
        std::shared_ptr<const course::Course> course);
  Cycle(const Cycle&) = delete;
  Cycle& operator=(const Cycle&) = delete;

  /// The link: it takes the port's opening, end and bytes, and gives the bytes to write and the
  /// events to report. step() takes its samples, sends to it and moves its time.
  link::Session& session() { return session_; }
  const link::Session& session() const { return session_; }

  /// What an operator asks; taken by the next step. A STOP is never dropped, others are if too many
  /// come.
  void request(OperatorRequest request);
  /// A parameter changes with the next step. Dropped if too many come.
  void change(const ParameterChange& change);
  /// What a driver wants; taken by the next step. If too many come, the newest counts.
  void velocity(const VelocityInput& input);
  /// What the overhead camera saw; taken by the next step. Dropped if too many come.
  void camera(const CameraSample& seen);
  /// Received from an external world; taken by the next step. If too many come, the newest counts,
  /// and a stop in any of them.
  void world(const WorldSample& received);
  /// Makes the change: the next step restarts with it, which is an input of that step. The old
  /// step is then in `change`, to be freed elsewhere. False, and nothing is changed: there is a
  /// run, the robot moves, or an external world is in use (Step::changeable).
  bool change_setup(SetupChange& change, HostNs now);
  /// Number of steps so far.
  std::uint64_t steps() const { return steps_; }
  /// One cycle: session time, step, command. The reference stays valid until the next call.
  const bridge::Outputs& step(HostNs now);
  /// Motors off for good (the program ends): from now on the step cannot arm. See
  /// request_pending().
  void disarm(HostNs now);
  /// True until the last request to the robot is acknowledged or given up (200 ms), and the end of
  /// a run is confirmed or not (250 ms).
  bool request_pending() const { return session_.request_pending() || outputs_->disarming; }

  /// The inputs of the last step exactly as they were passed.
  const StepInputs& inputs() const { return *inputs_; }
  const bridge::Outputs& outputs() const { return *outputs_; }
  /// Writes the last step into `out`. If the port was closed since, only the link's
  /// counters differ.
  void record(StepRecord& out) const;

 private:
  void restart_at_rest(HostNs now);

  link::Session session_;
  bridge::Step step_;
  bridge::Outputs none_{};
  const bridge::Outputs* outputs_ = &none_;
  std::array<StepInputs, 2> both_inputs_{};
  StepInputs* next_ = &both_inputs_[0];    // what the next step will take
  StepInputs* inputs_ = &both_inputs_[1];  // what the last step took
  HostNs now_ns_ = 0;
  HostNs restarted_ns_ = 0;
  std::uint64_t steps_ = 0;
  bool stopping_ = false;
};

}  // namespace tp100::bridge
