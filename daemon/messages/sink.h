#pragma once
// Interface of everything that receives the results of steps: recorder, server, worlds.

#include <vector>

#include "core/pose.h"
#include "core/step_record.h"

namespace tp100::messages {

struct RunContext;

/// Called from one thread, never the real-time one, in the order of the steps. A sink must not
/// block: it would delay every other sink and the operator. Slow work belongs in a thread of its
/// own.
class Sink {
 public:
  virtual ~Sink() = default;

  /// One step. `record` is only valid during the call. A gap in record.step means dropped records.
  virtual void take(const StepRecord& record) = 0;
  /// The robot's true pose at host time `at`, if it is measured from outside; called after the step
  /// that used the sample of that time.
  virtual void take_truth(HostNs at [[maybe_unused]], const Pose& truth [[maybe_unused]]) {}
  /// From the next record on, at host time `at`, another course, robot or set-up is in force.
  virtual void take_setup(const RunContext& run_context [[maybe_unused]],
                          HostNs at [[maybe_unused]]) {}
  /// A disturbance of the robot began at `at`, if that is known from outside.
  virtual void take_disturbance(HostNs at [[maybe_unused]]) {}
};

/// Several sinks as one; they must outlive it.
class SinkList : public Sink {
 public:
  void add(Sink& sink) { sinks_.push_back(&sink); }
  bool empty() const { return sinks_.empty(); }
  void take(const StepRecord& record) override {
    for (Sink* sink : sinks_) sink->take(record);
  }
  void take_truth(HostNs at, const Pose& truth) override {
    for (Sink* sink : sinks_) sink->take_truth(at, truth);
  }
  void take_disturbance(HostNs at) override {
    for (Sink* sink : sinks_) sink->take_disturbance(at);
  }

 private:
  std::vector<Sink*> sinks_;
};

}  // namespace tp100::messages
