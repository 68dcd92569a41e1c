#pragma once
// The daemon's figures as text that Prometheus collects (exposition format 0.0.4), for
// GET /metrics.

#include <string>

#include "messages/figures.h"
#include "messages/messages.h"

namespace tp100::messages {

/// The daemon's figures at one moment.
struct DaemonMetrics {
  StateFigures state{};
  LoopFigures loop{};
  LinkFigures link{};
  RecordingFigures recording{};
  ClientsFigures clients{};
};

/// One family of samples per figure, each with its help and type: SI units in the names, durations
/// in seconds, counters ending in _total, states and faults as one sample of value 0 or 1 for each
/// possible name. What is not known (battery voltage, clock relation) is left out.
std::string prometheus_text(const DaemonMetrics& metrics, const RunContext& run_context);

}  // namespace tp100::messages
