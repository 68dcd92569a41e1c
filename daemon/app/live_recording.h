#pragma once
// The recordings of a running bridge: one at a time, from the start of the program or when somebody
// asks. Each can be replayed, whenever it began (publish/recorder.h).

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "app/run_setup.h"
#include "publish/figures.h"
#include "publish/recorder.h"
#include "publish/sink.h"

namespace tp100::app {

class LiveRecording : public publish::Sink {
 public:
  /// Records nothing yet. `run` and its configuration must outlive this. Throws SetupError: nothing
  /// can be written to record.directory.
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
  /// What is said on the channels (publish::Listener); what does not follow from the steps is
  /// recorded.
  void hear(publish::Channel channel, std::uint64_t unix_ns, std::string_view json);

  // The thread that drains the steps.
  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;
  /// Removes the recording: the run never began.
  void discard();

 private:
  std::uint64_t max_bytes() const;

  const RunFiles& files_;
  const RunSetup& run_;
  publish::PublishClock clock_;
  std::unique_ptr<publish::Recorder> recorder_;  // null: no folder is set
  mutable std::mutex mutex_;                     // of what follows
  std::string name_;                             // of the run's folder
  HostNs began_ns_ = 0;
  std::map<publish::Channel, std::string> in_force_;  // the last message of channels that have one
};

/// Whether a message of that channel does not follow from the steps: only who is told can record
/// it.
bool is_told(publish::Channel channel);

/// DIRECTORY/YYYYMMDD-HHMMSS-NAME in local time, with -2, -3, ... behind NAME if that folder is
/// there already. Makes the folder. Throws SetupError.
std::string make_run_folder(const std::string& directory, const std::string& name,
                            std::int64_t unix_ns);

}  // namespace tp100::app
