#pragma once
// Interfaces of everything that receives the results of steps: recorder, server, worlds.

#include "core/pose.h"
#include "core/step_record.h"

namespace tp100::messages {

/// Called from one thread, never the real-time one, in the order of the steps. A sink must not
/// block: it would delay every other sink and the operator. Slow work belongs in a thread of its
/// own.
class Sink {
 public:
  virtual ~Sink() = default;
  /// One step. `record` is only valid during the call. A gap in record.step means dropped records.
  virtual void take(const StepRecord& record) = 0;
};

/// Receives the robot's true pose, where it is measured from outside: of an emulated robot.
class TruthSink {
 public:
  virtual ~TruthSink() = default;
  /// The true pose at host time `at`; called after the step that used the sample of that time.
  virtual void take_truth(HostNs at, const Pose& truth) = 0;
};

}  // namespace tp100::messages
