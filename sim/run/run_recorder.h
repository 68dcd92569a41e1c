#pragma once
// Records a run in virtual time.

#include <memory>
#include <string>

#include "publish/messages.h"
#include "publish/recorder.h"
#include "publish/sink.h"
#include "sim/run/options.h"

namespace tp100::sim {

class RunRecorder : public publish::Sink {
 public:
  /// FOLDER/COURSE-ROBOT-SEED/run.mcap; replaces what is there. `loaded.files` must have the
  /// course. Throws SetupError.
  RunRecorder(const std::string& folder, const Loaded& loaded, std::uint64_t seed);

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;
  void take_push(HostNs at) override;
  /// Ends the file and says on standard error what went wrong.
  void finish();
  std::string path() const { return recorder_.status().path; }

 private:
  RunRecorder(const std::string& folder, const Loaded& loaded, const app::RunSetup& run,
              std::uint64_t seed);

  void record(const publish::Event& event);

  publish::Recorder recorder_{{.patient = true}};
  publish::Messages messages_;
  RunState run_state_ = RunState::kIdle;
};

}  // namespace tp100::sim
