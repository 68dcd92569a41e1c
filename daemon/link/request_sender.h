#pragma once
// Requests to the robot (STOP, arm, disarm): each is repeated until it is acknowledged or given up.
// No clock; no allocation; safe in the real-time thread.

#include <cstdint>
#include <utility>

#include "core/command.h"
#include "core/limits.h"
#include "core/time.h"
#include "link/output_queue.h"
#include "link/session_event.h"
#include "wire/messages.h"

namespace tp100::link {

/// One request under way. Its limit is kAnswerNs.
class OneShotRequest {
 public:
  static constexpr HostNs kRepeatNs = 30 * kNsPerMs;

  /// Starts (or replaces) the request; `token` comes back in the acknowledgement.
  void start(std::uint32_t token, HostNs now);
  void cancel() { pending_ = false; }

  /// True if a copy is to be sent now. After the limit, copies are sent at the limit's interval.
  bool due(HostNs now) const { return pending_ && now >= next_ns_; }
  void sent(HostNs now) { next_ns_ = now + (overdue_ ? kAnswerNs : kRepeatNs); }

  /// True once, when the limit has passed without an acknowledgement.
  bool take_overdue(HostNs now);
  /// True if `token` is this request's; the request is then over.
  bool acknowledge(std::uint32_t token);

  bool pending() const { return pending_; }
  std::uint32_t token() const { return token_; }

 private:
  std::uint32_t token_ = 0;
  HostNs started_ns_ = 0;
  HostNs next_ns_ = 0;
  bool pending_ = false;
  bool overdue_ = false;
};

/// Tokens of requests and parameters: each above all earlier ones of the robot's boot.
class Tokens {
 public:
  std::uint32_t next(HostNs now);
  /// The robot knows a higher token.
  void leap();

 private:
  std::uint32_t token_ = 0;
};

class RequestSender {
 public:
  /// All must outlive the sender.
  RequestSender(Tokens& tokens, OutputQueue<kMaxOut>& output, SessionEvents& events)
      : tokens_(tokens), output_(output), events_(events) {}

  /// Sends STOP; without a connection, as soon as there is one.
  void stop(HostNs now);
  void disarm(HostNs now);
  /// Arms the boot `boot_nonce`; the robot must not obey after device time `expiry_us`.
  void arm(std::uint32_t boot_nonce, std::uint32_t expiry_us, HostNs now);
  /// Reports an arm or disarm that cannot be sent now as failed.
  void refuse(wire::Type type, HostNs now);

  /// A new robot may be there: a STOP under way is sent to it at once, with a fresh token.
  void restart_stop(HostNs now);
  /// The session is over: an arm fails, a disarm is dropped, a STOP remains.
  void end_session(HostNs now);
  /// Gives up what is overdue and, if `connected`, queues what is due. True if anything was.
  bool poll(bool connected, HostNs now);
  /// Takes the answer to a request. True: the robot accepted an arm that had already been given up,
  /// so the caller must disarm it.
  bool on_acknowledge(const wire::Acknowledge& acknowledge, HostNs now);

  /// Outcome of the last arm or disarm; reported once.
  RequestAnswer take_answer() { return std::exchange(answer_, RequestAnswer::kNone); }
  bool pending() const { return motion_.pending() || stop_.pending(); }

 private:
  void start_motion(wire::Type type, HostNs now);
  void fail_motion(wire::Type type, HostNs now);
  void fail_arm(HostNs now);

  Tokens& tokens_;
  OutputQueue<kMaxOut>& output_;
  SessionEvents& events_;
  OneShotRequest stop_;
  OneShotRequest motion_;  // arm or disarm
  wire::Type motion_type_ = wire::Type::kDisarm;
  wire::Arm arm_{};
  std::uint32_t overdue_arm_token_ = 0;
  RequestAnswer answer_ = RequestAnswer::kNone;
};

}  // namespace tp100::link
