#pragma once
// The server of `tp100d run`: page, viewers and what they ask, joined to the live loop.

#include <memory>
#include <string>

#include "app/configuration.h"
#include "app/live_controls.h"
#include "publish/server.h"

namespace tp100::app {

/// What the server needs to know about the run.
struct ServedRun {
  const Configuration& configuration;
  const bridge::Parameters& parameters;
  std::shared_ptr<const course::Course> course;  ///< null: none
  const course::Robot& robot;
  publish::PublishClock clock{};
};

/// Listens as configured; null if the server is off. Throws SetupError.
std::unique_ptr<publish::Server> make_server(const ServedRun& run, LiveControls& controls);

/// Wall clock and monotonic clock at this moment.
publish::PublishClock read_clocks();

}  // namespace tp100::app
