#pragma once
// The second thread of `tp100d run`: ports, log, operator, signals, figures. Exchanges data with
// the real-time thread through its rings only. Because it accepts STOP from the operator and feeds
// the watchdog, it waits, until the robot is disarmed, neither for a disk nor for a lock that is
// held by a thread waiting for one.

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
#include "messages/event_queue.h"
#include "messages/sink.h"
#include "record/worker.h"
#include "server/server.h"

namespace tp100::live {

/// All references must outlive the supervisor.
struct SupervisorSettings {
  ConnectorSettings connector{};
  config::CameraSettings camera{};
  config::WorldRun world{};
  bool go = false;
  bool ran_before = false;  ///< as in StartFacts
  bool stay = false;        ///< stay on after the end of a run
  std::optional<double> duration_s{};
  std::string stats_path{};
  const loop::RealTimeProcess& process;
  messages::EventQueue& events;          ///< logged and published here
  LiveRecording& recording;              ///< gets every step
  BlackBox& black_box;                   ///< gets every step
  record::Worker& disk;                  ///< writes --stats
  server::Server& server;                ///< started and fed here
  LiveControls& controls;                ///< of the server
  SetupChanger& setup_changer;           ///< of the controls
  Ros2Node* ros2 = nullptr;              ///< null: none
  std::vector<messages::Sink*> sinks{};  ///< get every step, before all others
};

/// Runs until the course is completed, the run fails, the time is over or a signal arrives; disarms
/// the robot first. Returns the exit status; throws SetupError for errors before the first session.
/// Ends the process if a disk hangs. `cycle` and `loop` must outlive the call.
int supervise(const SupervisorSettings& settings, LiveCycle& cycle, loop::FixedRateLoop& loop);

}  // namespace tp100::live
