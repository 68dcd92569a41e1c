#pragma once
// The last seconds of a running bridge, kept in memory. When a fault occurs while nothing is
// recorded, they are written as a recording: steps with samples, commands and states, and the
// channels' messages, up to a second after the fault. `tp100d report` and `export` read it; replay
// does not, because it does not begin with the first step.

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "config/run_setup.h"
#include "messages/channels.h"
#include "messages/publish_clock.h"
#include "messages/sink.h"
#include "record/worker.h"

namespace tp100::live {

/// Where black boxes are written: record.black_box_directory, else record.directory, else
/// $XDG_STATE_HOME/tp100 or ~/.local/state/tp100; empty: nowhere, there is no home.
std::string black_box_directory(const config::RecordSettings& settings);

class BlackBox : public messages::Sink {
 public:
  /// Most files that one run of the program keeps. The newest replaces the oldest, so that a fault
  /// that recurs does not fill the disk.
  static constexpr std::size_t kMostFiles = 20;
  static constexpr HostNs kAfterwardsNs = kNsPerS;

  /// `recorded` tells whether a recording is running that holds the same; any thread. Black boxes
  /// are written by `disk`. The references must outlive this.
  BlackBox(const config::RunFiles& files, const config::RunSetup& run,
           const messages::PublishClock& clock, record::Worker& disk,
           std::function<bool()> recorded);
  /// Calls finish() and waits until everything is written.
  ~BlackBox() override;

  /// Takes a message of a channel (server::Listener). Any thread.
  void hear(messages::Channel channel, std::uint64_t unix_ns, std::string_view json);

  // The thread that drains the steps. Never waits for the disk.
  void take(const StepRecord& record) override;
  /// The program ends: the fault whose second is not over is written, too.
  void finish();
  /// What there is to say since the last call: a file that was written, or why it was not; one
  /// line, or empty.
  std::string take_note();

 private:
  struct Message {
    messages::Channel channel;
    HostNs at_ns;
    std::string json;
  };
  struct Step {
    HostNs at_ns;
    std::vector<std::uint8_t> bytes;
  };
  using Steps = std::deque<Step>;
  using Messages = std::deque<Message>;

  void keep(const StepRecord& record);
  void begin_to_write();
  void write(const std::string& fault, const Steps& steps, const Messages& messages);
  void keep_newest(const std::string& file);
  void note(std::string text);

  const config::RunFiles& files_;
  const config::RunSetup& run_;
  messages::PublishClock clock_;
  record::Worker& disk_;
  std::function<bool()> recorded_;
  HostNs length_ns_;
  std::string directory_;
  Steps steps_;
  std::vector<std::uint8_t> encoded_;      // the newest step
  FaultMask known_ = 0;                    // faults of the last step
  std::string fault_;                      // that waits to be written; empty: none
  HostNs due_ns_ = 0;                      // when it is
  std::deque<std::string> files_written_;  // so far, oldest first; of the disk's thread
  std::mutex mutex_;                       // of what follows
  Messages messages_;
  std::string note_;
};

}  // namespace tp100::live
