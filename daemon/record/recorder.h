#pragma once
// Records runs in MCAP files, one at a time, from a thread of its own: the exact inputs and results
// of every step, what viewers see, and what is needed to replay it. A chunk reaches the file every
// half second, so that a kill loses less than the last second.
//
// A recording may begin at any step and is replayable all the same: the inputs of every step before
// it, which a journal keeps, come first in it.

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "messages/sink.h"
#include "record/recording_writer.h"

namespace tp100::record {

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
  std::string path{};   ///< empty: there was none yet
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< records that found no room in the queue
  HostNs first_ns = 0;        ///< time of the first step in it; 0: none yet
  HostNs last_ns = 0;         ///< time of the newest step in it
  double cpu_s = 0.0;         ///< that the recorder's thread has used
  std::string warning{};      ///< why it ended early or cannot be replayed; one line, empty: well
};

class Recorder : public messages::Sink {
 public:
  using Clock = std::chrono::steady_clock;
  /// Makes folder and file of a recording. Called on the recorder's thread, so that nobody else
  /// waits for the disk. Throws SetupError.
  using Make = std::function<std::unique_ptr<RecordingWriter>()>;
  /// What became of a request: why it failed, in one line, or nothing. Called once, on the
  /// recorder's thread, or on the caller's if the request is refused at once. Must not block.
  using Answer = std::function<void(const std::string& why)>;

  /// Records nothing yet. Throws SetupError: the journal cannot be written.
  explicit Recorder(const RecorderSettings& settings = {});
  /// Ends the recording, however long the disk takes.
  ~Recorder() override;

  // Any thread; none of these waits for the disk.
  /// A recording begins here: what is taken after this call is in it. Returns its number; 0:
  /// refused, since another is running or asked for, or the disk has not served the requests
  /// before.
  std::uint64_t ask_begin(Make make, Answer answer);
  /// Recording `number`, or whichever there is if that is 0, ends here.
  void ask_end(std::uint64_t number, Answer answer);
  /// Of the recording that is running or asked for; 0: none.
  std::uint64_t number() const;
  RecordingStatus status() const;
  /// A message of a channel that does not follow from the steps.
  void message(messages::Channel channel, HostNs at, std::string_view json);

  // Any thread; these wait for the disk.
  /// As ask_begin(). Throws SetupError if there is another, or the file cannot be created.
  void begin(Make make);
  void begin(const RecordingSettings& recording, const RunFacts& facts);
  /// Ends the recording, if there is one, and waits until all that was taken is written. False: not
  /// before `deadline`.
  bool end(Clock::time_point deadline = Clock::time_point::max());

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::record
