#pragma once
// What `tp100d run` consists of, besides what only its main thread uses: built from files and
// options, in this order, and destroyed in the reverse one.

#include <memory>
#include <optional>
#include <vector>

#include "core/worker.h"
#include "live/active_run.h"
#include "live/daemon.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "live/ros2_node.h"
#include "live/setup_changer.h"
#include "loop/fixed_rate_loop.h"
#include "loop/real_time.h"
#include "messages/event_queue.h"
#include "messages/messages.h"
#include "runs/run_archive.h"
#include "selftest/self_test.h"
#include "server/server.h"

namespace tp100::live {

struct DaemonParts {
  /// Starts threads, but neither the loop's nor the server's. Throws UserError.
  DaemonParts(const config::LoadedRun& run, const DaemonOptions& options);

  /// Those who keep something of what is in force; they refer to the parts. `continues`: where an
  /// exchange ends a recording, another one begins; else each run has a recording of its own.
  std::vector<ExchangeListener> listeners(bool continues);

  const std::shared_ptr<const ActiveRun> first_run;  ///< in force at the start
  const config::Configuration& configuration = first_run->loaded.setup.configuration;
  LiveCycle cycle;
  const messages::PublishClock clock;
  /// Made before memory is locked and by a thread whose ordinary scheduling its own ones inherit;
  /// null: switched off.
  const std::unique_ptr<ros2::Participant> participant;
  const loop::RealTimeProcess process;
  loop::FixedRateLoop loop;
  messages::EventQueue events;  ///< logged and published by the main thread
  LiveRecording recording;
  BlackBox black_box;
  SetupChanger setup;
  runs::RunArchive runs;
  selftest::SelfTest self_test;
  LiveControls controls;
  Worker disk{"disk"};  ///< waits for files, so that no other thread has to; its jobs use the above
  server::Server server;
  std::optional<Ros2Node> ros2;  ///< with a participant
};

}  // namespace tp100::live
