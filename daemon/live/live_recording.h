#pragma once
// The recordings of a running bridge: one at a time, from the start of the program or when somebody
// asks. Each can be replayed, whenever it began (record/recorder.h).

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "config/run_setup.h"
#include "messages/figures.h"
#include "messages/sink.h"
#include "record/recorder.h"

namespace tp100::live {

class LiveRecording : public messages::Sink {
 public:
  /// Records nothing yet. `run` and its configuration must outlive this. Throws SetupError: nothing
  /// can be written to record.directory.
  LiveRecording(const config::RunFiles& files, const config::RunSetup& run,
                const messages::PublishClock& clock);

  using Answer = record::Recorder::Answer;

  // Any thread; none of these waits for the disk.
  /// A recording begins here, in a new folder of record.directory; an empty `name` is the course's.
  /// Returns its number; 0: refused, as the answer says.
  std::uint64_t start(const std::string& name, Answer answer);
  /// Recording `number`, or whichever there is if that is 0, ends here.
  void stop(std::uint64_t number, Answer answer);
  /// Of the recording that is running or asked for; 0: none.
  std::uint64_t number() const;
  messages::RecordingFigures figures() const;
  /// CPU time that recordings have taken [s].
  double cpu_s() const;
  /// Takes a message of a channel (server::Listener) and records it if it does not follow from the
  /// steps.
  void hear(messages::Channel channel, std::uint64_t unix_ns, std::string_view json);

  // The thread that drains the steps.
  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

  // These wait for the disk.
  /// As start(). Throws SetupError.
  void begin();
  /// Ends the recording and waits until all of it is written; false: not before `deadline`.
  bool finish(std::chrono::steady_clock::time_point deadline);
  /// Removes the recording: the run never began.
  void discard();

 private:
  std::uint64_t max_bytes() const;
  record::Recorder::Make make(const std::string& name) const;

  const config::RunFiles& files_;
  const config::RunSetup& run_;
  messages::PublishClock clock_;
  std::mutex mutex_;                                   // of what follows
  std::map<messages::Channel, std::string> in_force_;  // the last message of channels that have one
  std::unique_ptr<record::Recorder> recorder_;         // null: no folder is set
};

/// Whether a message of that channel does not follow from the steps: only who is told can record
/// it.
bool is_told(messages::Channel channel);

/// DIRECTORY/YYYYMMDD-HHMMSS-NAME in local time, with -2, -3, ... behind NAME if that folder is
/// there already. Makes the folder. Throws SetupError.
std::string make_run_folder(const std::string& directory, const std::string& name,
                            std::int64_t unix_ns);

}  // namespace tp100::live
