#pragma once
// Session and step joined: bytes and time in, bytes out. The same object runs in the live loop and
// in lockstep with the emulated robot. No clock, port or file; no allocation after construction.
//
// One cycle:  session().receive(bytes, now)...  step(now)  session().output() → port

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

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
std::string parameter_name(unsigned index);

/// An operator's change between two runs.
struct SetupChange {
  std::optional<Step> step{};  ///< with another course, robot or set-up
  /// The robot's, if they differ from those that it has: a new session then begins.
  std::optional<wire::Parameters> parameters{};
  std::optional<Pose> place{};  ///< where the robot is now
};

class Cycle {
 public:
  /// At standstill the step restarts this often, so that a recording that begins later needs no
  /// inputs from before.
  static constexpr HostNs kRestartPeriodNs = 60 * kNsPerS;

  /// Throws UserError if parameters and course do not fit together.
  Cycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
        std::shared_ptr<const course::Course> course);
  Cycle(const Cycle&) = delete;
  Cycle& operator=(const Cycle&) = delete;

  /// The link. The caller reports the port's opening, closing and received bytes to it, writes its
  /// output and reports its events. step() takes its samples, sends commands through it and
  /// advances its time.
  link::Session& session() { return session_; }
  const link::Session& session() const { return session_; }

  /// An operator's request for the next step. Dropped if too many are waiting; a STOP never is.
  void request(OperatorRequest request);
  /// A parameter's change with the next step. Dropped if too many are waiting.
  void change(const ParameterChange& change);
  /// A driver's input for the next step. If too many are waiting, it replaces the last one.
  void velocity(const VelocityInput& input);
  /// A sample of the overhead camera for the next step. Dropped if too many are waiting.
  void camera(const CameraSample& seen);
  /// A sample of an external world for the next step. If too many are waiting, it replaces the last
  /// one, whose stop is kept.
  void world(const WorldSample& received);
  /// Makes the change: the next step restarts with it, which is an input of that step. The old step
  /// is then in `change`, to be freed elsewhere. Returns false and changes nothing during a run,
  /// while the robot moves, or with an external world (Step::changeable).
  bool change_setup(SetupChange& change, HostNs now);
  /// Number of steps so far.
  std::uint64_t steps() const { return steps_; }
  /// One cycle: session time, step, command. The reference stays valid until the next call.
  const bridge::Outputs& step(HostNs now);
  /// Motors off for good (the program ends): from now on the step cannot arm. See
  /// request_pending().
  void disarm(HostNs now);
  /// True until the last request to the robot is acknowledged or given up (kAnswerNs), and the end
  /// of a run is confirmed or not (kOffWithinS).
  bool request_pending() const { return session_.request_pending() || outputs_->disarming; }

  /// The inputs of the last step exactly as they were passed.
  const StepInputs& inputs() const { return *inputs_; }
  const bridge::Outputs& outputs() const { return *outputs_; }
  /// Writes the last step into `out`, with the link's counters as they are now: they differ from
  /// those after that step if the port was closed since.
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
