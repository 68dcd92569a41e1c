#pragma once
// Session and step joined: bytes and time in, bytes out. The same object runs in the live loop and
// in lockstep with the emulated robot. No clock, port or file; no allocation after construction.
//
// One turn:  receive(bytes, now)...  step(now)  output() → port  written(n)

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "bridge/step.h"
#include "core/step_record.h"
#include "link/session.h"

namespace tp100::bridge {

/// Session settings for this robot: wire parameters of the bridge's drive and model values. Values
/// that the firmware would refuse are sent as they are; the refusal names the field.
link::SessionSettings session_settings(const bridge::Parameters& parameters);

/// Name of a field of wire::Parameters by its index, as a refusal reports it; "unknown" beyond the
/// last.
const char* parameter_name(unsigned index);

class Cycle {
 public:
  static constexpr std::size_t kMaxRequests = 16;  ///< operator requests between two steps
  static constexpr std::size_t kMaxCamera = 8;     ///< camera samples between two steps
  static constexpr std::size_t kMaxWorld = 8;      ///< messages of an external world between them
  static constexpr std::size_t kMaxChanges = 8;    ///< changes of parameters between two steps

  /// Throws SetupError if parameters and course do not fit together.
  Cycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
        std::shared_ptr<const course::Course> course);

  /// A port was opened or is gone.
  void open(HostNs now);
  void close(HostNs now);

  /// Bytes that arrived; `now` is the time at which the last of them was read.
  void receive(std::span<const std::uint8_t> bytes, HostNs now);
  /// What an operator asks; taken by the next step. A STOP is never dropped, others are if too many
  /// come.
  void request(OperatorRequest request);
  /// A parameter changes with the next step. Dropped if too many come.
  void change(const ParameterChange& change);
  /// What the overhead camera saw; taken by the next step. Dropped if too many come.
  void camera(const CameraSample& seen);
  /// What an external world said; taken by the next step. If too many come, the newest counts, and
  /// a stop in any of them.
  void world(const WorldSample& said);
  /// One turn: session time, step, command. The reference stays valid until the next call.
  const bridge::Outputs& step(HostNs now);
  /// Motors off for good (the program ends): from now on the step cannot arm. See
  /// request_pending().
  void disarm(HostNs now);
  /// True until the last request to the robot is acknowledged or given up (200 ms), and the end of
  /// a run is confirmed or not (250 ms).
  bool request_pending() const { return session_.request_pending() || outputs_->disarming; }

  /// Bytes to write. After writing `n` of them call written(n).
  std::span<const std::uint8_t> output() const { return session_.output(); }
  void written(std::size_t n) { session_.written(n); }
  /// Drops bytes that the port did not take in time.
  void drop_output() { session_.drop_output(); }

  /// Session events since the last take; valid until the next call that takes time or bytes.
  std::span<const link::SessionEvent> take_events() { return session_.take_events(); }
  /// Samples that the last step took; valid until the next receive().
  std::span<const Sample> samples() const { return samples_; }
  /// The inputs of the last step exactly as they were passed; valid until the next receive().
  const bridge::Inputs& inputs() const { return inputs_; }
  const bridge::Outputs& outputs() const { return *outputs_; }
  const link::Session& session() const { return session_; }
  /// Writes the last step into `out`, but for entries beyond the counts, which stay as they are.
  /// Call it before the next receive(), request(), camera() or world(); a port that is gone since
  /// changes nothing but the link's counters.
  void record(StepRecord& out) const;

 private:
  link::Session session_;
  bridge::Step step_;
  bridge::Outputs none_{};
  const bridge::Outputs* outputs_ = &none_;
  std::span<const Sample> samples_;
  bridge::Inputs inputs_{};
  HostNs now_ns_ = 0;
  std::uint64_t steps_ = 0;
  std::array<OperatorRequest, kMaxRequests> requests_{};
  std::size_t request_count_ = 0;
  std::array<CameraSample, kMaxCamera> camera_{};
  std::size_t camera_count_ = 0;
  std::array<WorldSample, kMaxWorld> world_{};
  std::size_t world_count_ = 0;
  std::array<ParameterChange, kMaxChanges> changes_{};
  std::size_t change_count_ = 0;
  bool stopping_ = false;
};

}  // namespace tp100::bridge
