#pragma once
// The recordings of a running bridge, one at a time: from the start of the program, on request, or
// around a fault. Each can be replayed, whenever it began (record/recorder.h).

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/faults.h"
#include "core/run_state.h"
#include "core/step_record.h"
#include "live/active_run.h"
#include "messages/event_queue.h"
#include "messages/figures.h"
#include "messages/messages.h"
#include "messages/sink.h"
#include "record/recorder.h"
#include "server/service.h"

namespace tp100::live {

/// Folder for black boxes: record.black_box_directory, else record.directory, else
/// $XDG_STATE_HOME/tp100 or ~/.local/state/tp100; empty if there is no home directory.
std::string black_box_directory(const config::RecordSettings& settings);

/// How long a recording of a run or a black box continues after the run or the fault.
inline constexpr HostNs kTailNs = kNsPerS;

class LiveRecording : public messages::Sink {
 public:
  /// Records nothing yet. `events`, which must outlive this, hear what record.quota_mb deletes.
  /// Throws UserError: record.directory cannot be created.
  LiveRecording(std::shared_ptr<const ActiveRun> run, const messages::PublishClock& clock,
                messages::EventQueue& events);

  using Answer = record::Recorder::Answer;

  /// record_start and record_stop.
  std::vector<server::ServiceRow> services();

  // Any thread; none of these waits for the disk.
  /// Begins a recording in a new folder of record.directory; an empty `name` means the course's.
  /// Returns its number; 0: refused, and the answer tells why.
  std::uint64_t start(const std::string& name, const Answer& answer);
  /// Ends recording `number`, or the current one if that is 0.
  void stop(std::uint64_t number, Answer answer) { recorder_.ask_end(number, std::move(answer)); }
  /// Begins a recording in black_box_directory() that looks back, so that it is record.black_box_s
  /// long after another kTailNs. It ends when another recording begins. Older black boxes without a
  /// note are deleted first, beyond record.quota_mb or, without it, 500 MB. `ended`: see
  /// record::Recorder. 0: refused.
  std::uint64_t start_black_box(const std::string& fault, HostNs now,
                                const record::Recorder::Ended& ended);
  /// Number of the recording that is running or requested, except of black boxes; 0: none.
  std::uint64_t number() const { return recorder_.number(); }
  messages::RecordingFigures figures() const;
  /// CPU time used by recordings [s].
  double cpu_s() const { return recorder_.status().cpu_s; }
  /// Takes a message of a channel (server::Listener) and records it if it cannot be derived from
  /// the steps.
  void on_message(messages::Channel channel, std::uint64_t unix_ns, std::string_view json);

  // Called by the thread that drains the steps.
  /// A running recording ends here; `continues`: and another one begins. Later ones contain the
  /// files of the run in force then.
  void exchange(const Exchange& exchange, bool continues);
  void take(const StepRecord& record) override { recorder_.take(record); }

  // These wait for the disk:
  /// Like start(). Throws UserError.
  void begin();
  /// Ends the recording and waits until it is written; false: `deadline` passed first.
  bool finish(std::chrono::steady_clock::time_point deadline) { return recorder_.end(deadline); }
  /// Removes the recording of a run that never began.
  void discard();

 private:
  /// `quota_mb`: as record.quota_mb, applied first, to runs with `only`, a literal, in their names;
  /// 0: none. Call it with the mutex held.
  record::Recorder::Make make(const std::string& directory, const std::string& name, HostNs now,
                              const record::McapMap& facts, int quota_mb,
                              std::string_view only) const;

  const config::RecordSettings settings_;
  messages::PublishClock clock_;
  messages::EventQueue& events_;
  std::mutex mutex_;  // guards what follows
  std::shared_ptr<const ActiveRun> run_;
  struct Message {
    HostNs at_ns;
    std::string json;
  };
  std::map<messages::Channel, Message> last_;  // of each recorded channel of a state
  HostNs exchanged_ns_ = 0;  // states from before name what is not in force any more
  record::Recorder recorder_;
};

/// What is recorded without being asked for: each run of a daemon that stays on, but not the time
/// between two runs; of another one, everything.
class RunRecordings : public messages::Sink {
 public:
  /// `recording` must outlive this, and `events`, which hear of a recording that could not begin,
  /// the recording. Without `stay`, one begins here: waits for the disk, and throws UserError.
  RunRecordings(LiveRecording& recording, messages::EventQueue& events, bool stay)
      : recording_(recording), events_(events), on_(stay && recording.figures().available) {
    if (!stay && recording.figures().available) recording.begin();
  }

  // Called by the thread that drains the steps, before `recording` takes the step.
  /// A recording begins with the arming, unless one is already running, and ends one second after
  /// the run, so that the end is included.
  void take(const StepRecord& record) override;

 private:
  void end();

  LiveRecording& recording_;
  messages::EventQueue& events_;
  bool on_;
  bool under_way_ = false;
  FaultMask faults_ = 0;   // of the step before
  std::uint64_t own_ = 0;  ///< the recording begun here; 0: none
  std::optional<HostNs> end_ns_{};
};

/// Records record.black_box_s around a fault that occurs while nothing is recorded; the last second
/// of them follows the fault.
class BlackBox : public messages::Sink {
 public:
  /// Most files that one run of the program keeps. The newest replaces the oldest, so that a fault
  /// that recurs does not fill the disk.
  static constexpr std::size_t kMaxFiles = 20;

  /// `recording` must outlive this, and `events`, which hear of each file, the recording.
  BlackBox(const config::RecordSettings& settings, LiveRecording& recording,
           messages::EventQueue& events);

  // Called by the thread that drains the steps, after `recording` has taken the step. Never waits
  // for the disk.
  void take(const StepRecord& record) override;
  /// The program is ending: a black box whose second is not over ends here.
  void finish();

 private:
  struct Written {
    void add(const std::string& fault, const record::RecordingStatus& status);

    messages::EventQueue& events;
    std::deque<std::string> files;  // of this run, oldest first; the recorder's thread only
  };

  bool on_;
  LiveRecording& recording_;
  FaultMask known_ = 0;    // faults of the newest step
  std::uint64_t own_ = 0;  // the recording begun here; 0: none
  HostNs end_ns_ = 0;      // when that ends
  std::shared_ptr<Written> written_;
};

}  // namespace tp100::live
