#pragma once
// Records a run in one MCAP file, from a thread of its own: the exact inputs and results of every
// step, what viewers see, and what is needed to replay it. A chunk reaches the file every half
// second, so that a kill loses less than the last second.

#include <memory>
#include <string>

#include "publish/recording_writer.h"
#include "publish/sink.h"

namespace tp100::publish {

struct RecorderSettings {
  RecordingSettings recording{};
  bool patient = false;  ///< a full queue is waited for: for who runs in virtual time
};

/// The recording so far.
struct RecordingStatus {
  bool active = false;  ///< false once it has ended, for whatever reason
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< records that found no room in the queue
  HostNs last_ns = 0;         ///< time of the newest step in it
  double cpu_s = 0.0;         ///< that the recorder's thread has used
  std::string warning{};      ///< why it ended early; one line, empty: it did not
};

class Recorder : public Sink {
 public:
  /// Creates the file. Throws SetupError if it cannot be.
  Recorder(const RecorderSettings& settings, const RunFacts& facts);
  ~Recorder() override;

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

  /// A message of a channel that does not follow from the steps. Any thread.
  void message(Channel channel, HostNs at, std::string_view json);

  /// Writes what is queued and the end of the file; what comes later is ignored. Any thread; the
  /// destructor does it too.
  void finish();
  /// Ends the recording and removes the file, and its folder if nothing else is in it.
  void discard();
  /// Any thread.
  RecordingStatus status() const;
  const std::string& path() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::publish
