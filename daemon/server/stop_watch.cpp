#include "server/stop_watch.h"

namespace tp100::server {

using Status = messages::StopFigures::Status;

void StopWatch::press(const std::string& by, HostNs now) {
  ++figures_.count;
  figures_.by = by;
  figures_.latched = true;
  pressed_ns_ = now;
  if (unanswered()) return;
  figures_.requested_ns = now;
  figures_.status = Status::kPending;
}

void StopWatch::answered(HostNs at) {
  // An answer from before the press belongs to an older one.
  if (!unanswered() || at < figures_.requested_ns) return;
  figures_.status = Status::kAcknowledged;
  figures_.acknowledged_ms = to_s(at - figures_.requested_ns) * 1e3;
}

bool StopWatch::tick(HostNs now) {
  if (figures_.status != Status::kPending || now - figures_.requested_ns < kLimitNs) return false;
  figures_.status = Status::kNotAcknowledged;
  return true;
}

}  // namespace tp100::server
