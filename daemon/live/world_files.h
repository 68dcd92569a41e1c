#pragma once
// The paper's Encoder.txt and Orientation.txt, in a thread of their own.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "config/world_settings.h"
#include "messages/sink.h"

namespace tp100::live {

/// What happened to the files since the start.
struct WorldFileCounters {
  std::uint64_t written = 0;
  std::uint64_t write_errors = 0;
  std::uint64_t read = 0;      ///< changed and valid: passed to the step
  std::uint64_t rejected = 0;  ///< changed, but incomplete, not numeric or out of range
  std::uint64_t dropped = 0;   ///< valid, but the step's queue was full
};

class WorldFiles : public messages::Sink {
 public:
  /// `give` is called in the thread of the files. Throws SetupError: a bad template, or a folder
  /// that is not writable.
  WorldFiles(const config::WorldRun& run, config::GiveWorld give);
  /// Ends the thread; the files stay.
  ~WorldFiles() override;

  /// Queues the newest step for the file; never waits for the disk.
  void take(const StepRecord& record) override;
  /// Requests the thread to end; does not wait for it.
  void stop();
  /// Waits for the end of the thread; false: `deadline` passed first.
  bool ended_by(std::chrono::steady_clock::time_point deadline);
  /// A line to log since the last call, or empty.
  std::string take_note();
  WorldFileCounters counters() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
