#pragma once
// The server of `tp100d run`: page, viewers and what they ask, joined to the live loop; and what it
// says, to whoever records it.

#include <memory>
#include <string>

#include "config/run_setup.h"
#include "live/live_controls.h"
#include "server/server.h"

namespace tp100::live {

/// Listens as configured; `listener` hears all that is said. `controls` must outlive it. Throws
/// SetupError.
std::unique_ptr<server::Server> make_server(const config::RunSetup& run,
                                            const messages::PublishClock& clock,
                                            LiveControls& controls, server::Listener listener);

}  // namespace tp100::live
