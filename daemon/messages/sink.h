#pragma once
// Whoever takes what the steps produced: recorder, server, worlds.

#include <vector>

#include "core/pose.h"
#include "core/step_record.h"

namespace tp100::messages {

/// Called from one thread, never the real-time one, in the order of the steps. A sink must not
/// block: it holds up every other sink and the operator. What takes time belongs to a thread of its
/// own.
class Sink {
 public:
  virtual ~Sink() = default;

  /// One step. `record` is only valid during the call. A gap in record.step is a record that found
  /// no room.
  virtual void take(const StepRecord& record) = 0;
  /// Where the robot truly was at host time `at`; only where somebody outside knows, and after the
  /// step that took the sample of that time.
  virtual void take_truth(HostNs at, const Pose& truth) {
    (void)at;
    (void)truth;
  }
  /// Somebody pushed the robot from `at` on; only where somebody outside knows.
  virtual void take_push(HostNs at) { (void)at; }
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
  void take_push(HostNs at) override {
    for (Sink* sink : sinks_) sink->take_push(at);
  }

 private:
  std::vector<Sink*> sinks_;
};

}  // namespace tp100::messages
