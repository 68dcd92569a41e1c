#pragma once
// Records a run in virtual time.

#include <memory>
#include <string>

#include "messages/messages.h"
#include "messages/sink.h"
#include "record/recorder.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {

class LockstepRecorder : public messages::Sink, public messages::TruthSink {
 public:
  /// Records to FOLDER/COURSE-ROBOT-SEED/run.mcap; replaces an existing file. `loaded.files` must
  /// have the course. Throws UserError.
  LockstepRecorder(const std::string& folder, const Loaded& loaded, std::uint64_t seed);

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;
  /// Records the run of these settings.
  void record(LockstepSettings& settings);
  /// Finishes the file and prints errors on standard error.
  void finish();
  std::string path() const { return recorder_.status().path; }

 private:
  LockstepRecorder(const std::string& folder, const Loaded& loaded, const config::RunSetup& run,
                   std::uint64_t seed);

  void take_disturbance(HostNs at);
  void record(const messages::Event& event);

  record::Recorder recorder_{{.blocking = true}};
  messages::Messages messages_;
  RunState run_state_ = RunState::kIdle;
};

}  // namespace tp100::sim
