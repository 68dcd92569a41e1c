#pragma once
// The paper's Encoder.txt and Orientation.txt, in a thread of their own.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "config/world_run.h"
#include "messages/sink.h"

namespace tp100::live {

/// What became of the files, since the start.
struct WorldFileCounters {
  std::uint64_t written = 0;
  std::uint64_t write_errors = 0;
  std::uint64_t read = 0;      ///< changed and good: handed to the step
  std::uint64_t rejected = 0;  ///< changed, but incomplete, no numbers or out of range
  std::uint64_t dropped = 0;   ///< good, but the step had no room
};

class WorldFiles : public messages::Sink {
 public:
  /// `give` is called from the thread of the files. Throws SetupError: a bad template, a folder
  /// that cannot be written.
  WorldFiles(const config::WorldRun& run, config::GiveWorld give);
  /// Ends the thread; the files stay.
  ~WorldFiles() override;

  /// The newest step is what the file will show; never waits for the disk.
  void take(const StepRecord& record) override;
  /// Asks the thread to end; does not wait for it.
  void stop();
  /// Waits for the end of the thread; false: not before `deadline`.
  bool ended_by(std::chrono::steady_clock::time_point deadline);
  /// Something to log since the last call, or empty.
  std::string take_note();
  WorldFileCounters counters() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
