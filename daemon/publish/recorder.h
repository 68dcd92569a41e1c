#pragma once
// Records runs in MCAP files, one at a time, from a thread of its own: the exact inputs and results
// of every step, what viewers see, and what is needed to replay it. A chunk reaches the file every
// half second, so that a kill loses less than the last second.
//
// A recording may begin at any step and is replayable all the same: the inputs of every step before
// it, which a journal keeps, come first in it.

#include <memory>
#include <string>

#include "publish/recording_writer.h"
#include "publish/sink.h"

namespace tp100::publish {

struct RecorderSettings {
  /// Where the journal (step_journal.h) is; empty: none, a recording that does not begin with the
  /// first step cannot be replayed.
  std::string journal_folder{};
  std::uint64_t journal_bytes = 2'000'000'000;  ///< it gives up there
  bool patient = false;  ///< a full queue is waited for: for who runs in virtual time
};

/// The recording so far; when it has ended, the last one.
struct RecordingStatus {
  bool active = false;  ///< false once it has ended, for whatever reason
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< records that found no room in the queue
  HostNs last_ns = 0;         ///< time of the newest step in it
  double cpu_s = 0.0;         ///< that the recorder's thread has used
  std::string warning{};      ///< why it ended early or cannot be replayed; one line, empty: well
};

class Recorder : public Sink {
 public:
  /// Records nothing yet. Throws SetupError: the journal cannot be written.
  explicit Recorder(const RecorderSettings& settings = {});
  /// Ends the recording.
  ~Recorder() override;

  // Any thread.
  /// Begins a recording with the next step; none must be running. Throws SetupError if the file
  /// cannot be created.
  void begin(const RecordingSettings& recording, const RunFacts& facts);
  /// Writes what is queued and the end of the file, if there is a recording.
  void end();
  /// Ends the recording and removes the file, and its folder if nothing else is in it.
  void discard();
  RecordingStatus status() const;
  /// Of the last recording; empty: none yet.
  std::string path() const;
  /// A message of a channel that does not follow from the steps.
  void message(Channel channel, HostNs at, std::string_view json);

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::publish
