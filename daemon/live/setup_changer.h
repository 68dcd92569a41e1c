#pragma once
// Changes course, robot, set-up or the robot's place while the daemon runs and no run is under way:
// reads and checks the files and builds the new step in the thread that waits for disks, hands it
// to the loop and takes the old one back.

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "config/setup_files.h"
#include "core/worker.h"
#include "live/active_run.h"
#include "live/live_cycle.h"
#include "server/controls.h"

namespace tp100::live {

class SetupChanger {
 public:
  /// `run`: in force in `cycle`, which must outlive the changer, as the changer must outlive
  /// `disk`. `clock` stamps messages; `ros2`: nodes want theirs, too.
  SetupChanger(std::shared_ptr<const ActiveRun> run, LiveCycle& cycle, Worker& disk,
               const messages::PublishClock& clock = {}, bool ros2 = false);

  // Any thread; none of these waits for the disk.
  /// Answers when the loop has made the change, with what is then in force. A change that waits for
  /// other jobs of the disk for 3 s is given up.
  void choose(const server::SetupChoice& choice, server::Answer answer);
  /// Places the robot at `at`, or without it at the course's start. Needs no disk.
  void place(const std::optional<Pose>& at, server::Answer answer);
  /// Whether a change of course, robot or set-up is pending: then no run may be started.
  bool changing() const;

  std::shared_ptr<const ActiveRun> in_force() const;
  const config::SetupFiles& files() const { return files_; }
  /// For those who wait for the same disk.
  Worker& disk() { return disk_; }

  // The thread that drains the steps:
  /// A change that the loop has made.
  struct MadeChange {
    std::optional<Exchange> exchange{};  ///< nothing: only the place has changed
    std::string text{};                  ///< of the event
  };
  /// Call it with each record before anything else takes the record: returns the change of which it
  /// is the first step. Then call finish().
  std::optional<MadeChange> take(const StepRecord& next);
  /// Answers the request: the change is in force in the loop and here, and on its way to the
  /// server.
  void finish();
  /// Answers a change that the loop did not make. Call it regularly.
  void tick();

 private:
  struct Order {
    server::SetupChoice choice{};
    bool places = false;
    std::optional<Pose> at{};
  };
  void ask(Order order, server::Answer answer);
  std::unique_ptr<SetupRequest> make(const Order& order);
  void end(const std::string& why);

  LiveCycle& cycle_;
  Worker& disk_;
  const messages::PublishClock clock_;
  const bool ros2_;
  const config::SetupFiles files_;
  mutable std::mutex mutex_;  // guards what follows; never held while waiting for a disk
  std::shared_ptr<const ActiveRun> run_;
  MadeChange next_;                        // the change under way
  std::string json_;                       // its answer
  server::Answer answer_;                  // set: a change is under way
  std::uint64_t number_ = 0;               // of that change
  HostNs waits_since_ns_ = 0;              // for the disk's thread; 0: it does not
  std::unique_ptr<SetupRequest> request_;  // is the loop's
};

}  // namespace tp100::live
