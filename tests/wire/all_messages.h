#pragma once
// All messages of the protocol, ordered by type.

#include "wire/messages.h"

namespace tp100::wire {

/// Calls visit(name, Message{}) once for every message.
template <class Visit>
void for_each_message(Visit&& visit) {
  visit("Hello", Hello{});
  visit("Sample", Sample{});
  visit("Acknowledge", Acknowledge{});
  visit("SyncReply", SyncReply{});
  visit("FaultReport", FaultReport{});
  visit("Log", Log{});
  visit("HelloRequest", HelloRequest{});
  visit("Parameters", Parameters{});
  visit("Command", Command{});
  visit("Arm", Arm{});
  visit("Disarm", Disarm{});
  visit("Stop", Stop{});
  visit("SyncRequest", SyncRequest{});
}

}  // namespace tp100::wire
