#pragma once
// The loop's events as messages, for the log and for viewers. Pure.

#include <string>
#include <vector>

#include "live/live_cycle.h"
#include "messages/messages.h"

namespace tp100::live {

/// Describes `event`: one message, and for an abort one more per fault.
std::vector<messages::Event> describe_event(const LiveEvent& event);

/// The robot acknowledged a STOP.
bool acknowledges_stop(const link::SessionEvent& event);

/// Session, run, course and page in one line; course and page may be empty.
std::string state_line(SessionState session, RunState run, const std::string& course,
                       const std::string& page);

/// Names of the faults in a mask, separated by commas; "none" if it is empty.
std::string fault_names(FaultMask faults);

}  // namespace tp100::live
