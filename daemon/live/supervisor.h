#pragma once
// The second thread of `tp100d run`: ports, log, operator, signals, figures. Exchanges data with
// the real-time thread through its rings only. Because it accepts STOP from the operator and feeds
// the watchdog, it waits, until the robot is disarmed, neither for a disk nor for a lock that is
// held by a thread waiting for one.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/world_settings.h"
#include "live/connector.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "live/recording_policies.h"
#include "live/ros2_node.h"
#include "live/setup_changer.h"
#include "loop/fixed_rate_loop.h"
#include "loop/real_time.h"
#include "messages/sink.h"
#include "record/worker.h"
#include "server/server.h"

namespace tp100::live {

struct SupervisorSettings {
  ConnectorSettings connector{};
  config::CameraSettings camera{};
  config::WorldRun world{};
  bool go = false;
  bool ran_before = false;  ///< as in StartFacts
  std::optional<double> duration_s;
  std::string stats_path;
  std::string course;  ///< names for log and figures; empty: no course
  std::string robot;
  std::string setup;
  bool verbose = false;  ///< log the loop's timing once a second
  bool stay = false;     ///< stay on after the end of a run
  // Never null; they must outlive the supervisor.
  const loop::RealTimeProcess* process = nullptr;
  LiveRecording* recording = nullptr;     ///< gets every step
  BlackBox* black_box = nullptr;          ///< gets every step
  record::Worker* disk = nullptr;         ///< writes --stats
  server::Server* server = nullptr;       ///< started and fed here
  LiveControls* controls = nullptr;       ///< of the server
  SetupChanger* setup_changer = nullptr;  ///< of the controls

  Ros2Node* ros2 = nullptr;  ///< null: none; must outlive the supervisor
};

class Supervisor {
 public:
  /// `cycle` and `loop` must outlive the supervisor.
  Supervisor(const SupervisorSettings& settings, LiveCycle& cycle, loop::FixedRateLoop& loop);
  ~Supervisor();

  /// `sink` gets every step from now on, in the thread of run(), and must outlive it.
  void add_sink(messages::Sink& sink);

  /// Runs until the course is completed, the run fails, the time is over or a signal arrives;
  /// disarms the robot first. Returns the exit status; throws SetupError for errors before the
  /// first session. Ends the process if a disk hangs.
  int run();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
