#pragma once
// Messages of the slow channels, as JSON (CHANNELS.md).

#include <string>

#include "core/estimates.h"
#include "core/sample.h"
#include "messages/figures.h"
#include "messages/messages.h"

namespace tp100::messages {

std::string link_message(double t_s, const LinkFigures& link);
std::string loop_message(double t_s, const LoopFigures& loop, const RunContext& run_context);
std::string state_message(HostNs now, const PublishClock& clock, const StateFigures& state,
                          const RunContext& run_context);
std::string recording_message(const RecordingFigures& recording);
std::string clients_message(const ClientsFigures& clients);

/// "good", "poor" or "lost".
const char* link_quality(const LinkFigures& link);

}  // namespace tp100::messages
