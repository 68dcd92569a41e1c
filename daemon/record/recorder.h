#pragma once
// Records runs in MCAP files, one at a time, from a thread of its own: the exact inputs and results
// of every step, what viewers see, and what is needed to replay it. A chunk reaches the file every
// half second, so that a kill loses less than the last second.
//
// A recording may begin at any step, even a past one, and can still be replayed: it begins with the
// inputs that led there, which a history keeps (step_history.h).

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "messages/sink.h"
#include "record/recording_writer.h"
#include "record/step_history.h"

namespace tp100::record {

struct RecorderSettings {
  /// Without it, a recording that does not begin with the first step cannot be replayed.
  std::optional<HistorySettings> history{};
  HostNs look_back_ns = 0;  ///< how long steps and messages are kept for ask_look_back()
  bool blocking = false;    ///< wait for a full queue: for programs in virtual time
};

/// The current recording, or the last one.
struct RecordingStatus {
  bool active = false;  ///< false once it has ended, for whatever reason
  std::string path{};   ///< empty: there was none yet
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< records dropped because the queue was full
  HostNs first_ns = 0;        ///< time of the first step in it; 0: none yet
  HostNs last_ns = 0;         ///< time of the newest step in it
  double cpu_s = 0.0;         ///< used by the recorder's thread
  std::string warning{};      ///< why it ended early or cannot be replayed; one line, or empty
};

class Recorder : public messages::Sink {
 public:
  using Clock = std::chrono::steady_clock;
  /// Creates folder and file of a recording. Called on the recorder's thread, so that no other
  /// thread waits for the disk. Throws UserError.
  using Make = std::function<std::unique_ptr<RecordingWriter>()>;
  /// Receives why a request failed, in one line, or nothing. Called once, on the recorder's thread,
  /// or on the caller's if the request is refused at once. Must not block.
  using Answer = std::function<void(const std::string& why)>;
  /// Receives the status of a recording that has ended, or one without a path and with the reason
  /// as its warning if it could not begin. Called once, as Answer is.
  using Ended = std::function<void(const RecordingStatus&)>;

  /// Records nothing yet.
  explicit Recorder(const RecorderSettings& settings = {});
  /// Ends the recording, however long the disk takes.
  ~Recorder() override;

  // Any thread; none of these waits for the disk.
  /// Begins a recording of what is taken after this call. Returns its number; 0: refused, since
  /// another is running or requested, or the disk has not served the earlier requests.
  std::uint64_t ask_begin(Make make, const Answer& answer);
  /// As ask_begin(), for a recording that begins look_back_ns ago and ends when another recording
  /// begins. It is not in number() and status(), and two of them share no step.
  std::uint64_t ask_look_back(Make make, const Ended& ended);
  /// Ends recording `number`, or the current one if that is 0.
  void ask_end(std::uint64_t number, Answer answer);
  /// Ends a running recording, and discards the history before step `next`, which restarts the step
  /// with another course, robot or set-up: a recording that begins or looks back later cannot
  /// contain it.
  void forget(std::uint64_t next);
  /// Number of the recording that is running or requested; 0: none.
  std::uint64_t number() const;
  RecordingStatus status() const;
  /// Records a channel message that cannot be derived from the steps.
  void message(messages::Channel channel, HostNs at, std::string_view json);

  // Any thread; these wait for the disk:
  /// As ask_begin(). Throws UserError if there is another, or the file cannot be created.
  void begin(Make make);
  void begin(const RecordingSettings& recording, const RunFacts& facts);
  /// Ends the recording, if there is one, and waits until all that was taken is written. False: not
  /// before `deadline`.
  bool end(Clock::time_point deadline = Clock::time_point::max());

  void take(const StepRecord& record) override;
  /// The robot's true pose at host time `at`.
  void take_truth(HostNs at, const Pose& truth);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::record
