#pragma once
// The server of `tp100d run`: page, viewers and what they ask, joined to the live loop; and what it
// says, to whoever records it.

#include <memory>
#include <string>

#include "app/live_controls.h"
#include "app/run_setup.h"
#include "publish/server.h"

namespace tp100::app {

/// Listens as configured; `listener` hears all that is said. `controls` must outlive it. Throws
/// SetupError.
std::unique_ptr<publish::Server> make_server(const RunSetup& run,
                                             const publish::PublishClock& clock,
                                             LiveControls& controls, publish::Listener listener);

}  // namespace tp100::app
