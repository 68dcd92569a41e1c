#include "live/first_session.h"

#include "bridge/cycle.h"
#include "core/error.h"
#include "live/live_events.h"

namespace tp100::live {
namespace {

// A board needs 2 s after its reset, and less for a handshake; a silent port is given up sooner.
constexpr HostNs kFirstSessionNs = 6 * kNsPerS;

}  // namespace

void FirstSession::on_event(const SessionReport& report) const {
  if (wait_ || over_) return;
  if (link::as<link::VersionMismatch>(report.event) != nullptr) {
    throw UserError(connector_.path() + ": " + version_mismatch(report.hello));
  }
  if (link::as<link::Unanswered>(report.event) != nullptr ||
      link::as<link::BadHello>(report.event) != nullptr) {
    const messages::Event event = describe_event(report).front();
    throw UserError(connector_.path() + ": " + event.cause + "; " + event.fix);
  }
  const link::Acknowledged* answer = link::as<link::Acknowledged>(report.event);
  const bool refused = answer != nullptr && answer->request == wire::Type::kParameters &&
                       answer->result == wire::Result::kOutOfRange;
  if (refused) {
    throw UserError("robot " + robot_ + ": the firmware refuses " +
                    bridge::parameter_name(answer->detail) +
                    " as out of range; correct it in the robot file");
  }
}

void FirstSession::on_state(SessionState state, HostNs now) {
  state_ = state;
  const bool meant = state != SessionState::kListening || port_ != "auto";
  if (tried_ns_ == 0 && state != SessionState::kClosed && meant) tried_ns_ = now;
  if (state == SessionState::kReady) over_ = true;
}

void FirstSession::check(HostNs now) const {
  if (wait_ || over_ || tried_ns_ == 0 || now - tried_ns_ < kFirstSessionNs) return;
  throw UserError(connector_.path() + ": no session with the robot was established in " +
                  std::to_string(kFirstSessionNs / kNsPerS) + " s, last state " +
                  std::string(to_string(state_)) +
                  ": its hello or its answers do not belong to this version; flash this version's "
                  "firmware (scripts/flash, installed: tp100-flash)");
}

}  // namespace tp100::live
