#pragma once
// The paper's Encoder.txt and Orientation.txt, in a thread of their own.

#include <chrono>
#include <memory>

#include "live/world_link.h"

namespace tp100::live {

class WorldFiles : public WorldLink {
 public:
  /// `give` is called in the thread of the files; `events` must outlive them. Throws UserError: a
  /// bad template, or a folder that is not writable.
  WorldFiles(const config::WorldRun& run, config::GiveWorld give, messages::EventQueue& events);
  /// Ends the thread; the files stay.
  ~WorldFiles() override;

  /// Queues the newest step for the file; never waits for the disk.
  void take(const StepRecord& record) override;
  void stop() override;
  bool ended_by(std::chrono::steady_clock::time_point deadline) override;
  WorldFigures figures() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
