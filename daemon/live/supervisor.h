#pragma once
// The second thread of `tp100d run`: ports, log, operator, signals, figures. Talks to the real-time
// thread through its rings only. It takes STOP from the operator and feeds the watchdog: it waits
// for no disk, nor for a lock that somebody holds while waiting for one, before the robot is
// disarmed.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/world_run.h"
#include "live/black_box.h"
#include "live/connector.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "loop/fixed_rate_loop.h"
#include "messages/sink.h"
#include "record/worker.h"
#include "server/server.h"

namespace tp100::live {

struct SupervisorSettings {
  ConnectorSettings connector{};
  config::CameraSettings camera{};
  config::WorldRun world{};
  bool go = false;
  bool ran_before = false;  ///< as StartFacts
  std::optional<double> duration_s;
  std::string stats_path;
  std::string course;  ///< names for log and figures; an empty course is none
  std::string robot;
  std::string setup;
  std::vector<loop::Grant> process_grants;
  bool verbose = false;  ///< the loop's times in the log once a second
  bool stay = false;     ///< a run that is over does not end the program
  // Never null; they must outlive the supervisor.
  LiveRecording* recording = nullptr;  ///< gets every step
  BlackBox* black_box = nullptr;       ///< the same
  record::Worker* disk = nullptr;      ///< writes --stats and black boxes
  server::Server* server = nullptr;    ///< started and fed here
  LiveControls* controls = nullptr;    ///< of the server
};

class Supervisor {
 public:
  /// `cycle` and `loop` must outlive the supervisor.
  Supervisor(const SupervisorSettings& settings, LiveCycle& cycle, loop::FixedRateLoop& loop);
  ~Supervisor();

  /// `sink` gets every step from now on, from the thread of run(), and must outlive it.
  void add_sink(messages::Sink& sink);

  /// Runs until the course is completed, the run fails, the time is over or a signal comes; the
  /// robot is disarmed first. Returns the exit status; throws SetupError for what is wrong before
  /// the first session. Ends the process where a disk stands still.
  int run();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
