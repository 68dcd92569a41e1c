#pragma once
// Whoever takes what the steps produced: recorder, server, worlds.

#include "core/pose.h"
#include "core/step_record.h"

namespace tp100::publish {

/// Called from one thread, never the real-time one, in the order of the steps. A sink must not
/// block: it holds up every other sink and the operator. What takes time belongs to a thread of its
/// own.
class Sink {
 public:
  virtual ~Sink() = default;

  /// One step. `record` is only valid during the call. A gap in record.step is a record that found
  /// no room.
  virtual void take(const StepRecord& record) = 0;
  /// Where the robot truly was at host time `at`; only where somebody outside knows.
  virtual void take_truth(HostNs at, const Pose& truth) {
    (void)at;
    (void)truth;
  }
};

}  // namespace tp100::publish
