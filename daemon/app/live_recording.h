#pragma once
// The recordings of a running bridge: one at a time, from the start of the program or when somebody
// asks.

#include <memory>
#include <mutex>
#include <string>

#include "app/run_setup.h"
#include "publish/figures.h"
#include "publish/recorder.h"
#include "publish/sink.h"

namespace tp100::app {

class LiveRecording : public publish::Sink {
 public:
  /// Records nothing yet. `run` and its configuration must outlive this.
  LiveRecording(const RunFiles& files, const RunSetup& run, const publish::PublishClock& clock);

  // Any thread.
  /// Begins a recording in a new folder of record.directory; an empty `name` is the course's.
  /// Throws SetupError: no folder is set, a recording runs already, or the disk says no.
  void start(const std::string& name);
  /// Ends the recording, if there is one.
  void stop();
  publish::RecordingFigures figures() const;
  /// CPU time that recordings have taken [s].
  double cpu_s() const;

  // The thread that drains the steps.
  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;
  void message(publish::Channel channel, HostNs at, std::string_view json);
  /// Removes the recording: the run never began.
  void discard();

 private:
  std::shared_ptr<publish::Recorder> recorder() const;

  const RunFiles& files_;
  const RunSetup& run_;
  publish::PublishClock clock_;
  mutable std::mutex mutex_;
  std::shared_ptr<publish::Recorder> recorder_;
  std::string name_;  // of the run's folder
  HostNs began_ns_ = 0;
};

/// DIRECTORY/YYYYMMDD-HHMMSS-NAME in local time, with -2, -3, ... behind NAME if that folder is
/// there already. Makes the folder. Throws SetupError.
std::string make_run_folder(const std::string& directory, const std::string& name,
                            std::int64_t unix_ns);

}  // namespace tp100::app
