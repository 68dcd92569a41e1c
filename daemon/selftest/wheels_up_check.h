#pragma once
// `tp100d doctor --wheels-up` from within the running daemon: with a session of its own on the port
// that the daemon hands over, in a thread of its own, started by one viewer that must keep polling.

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "config/configuration.h"
#include "core/worker.h"
#include "course/robot_file.h"
#include "doctor/wheels_up.h"
#include "messages/event_queue.h"
#include "selftest/port_handover.h"
#include "server/lease.h"
#include "server/service.h"

namespace tp100::selftest {

/// Reason of refusals while a check is under way.
inline constexpr const char* kTracksRun = "a check of the tracks is under way; wait for its end";

class WheelsUpCheck : public doctor::Operator {
 public:
  /// `events`, which must outlive it, hear how a check ended.
  WheelsUpCheck(config::Configuration configuration, const course::Robot& robot,
                messages::EventQueue& events);
  /// Stops the tracks first.
  ~WheelsUpCheck() override { stop(); }

  // Any thread; none of these waits for the robot.
  /// Sets the robot to examine.
  void choose(const course::Robot& robot);
  /// Begins a check and returns its token; the port must be given to handover() within 2 s.
  Result<std::string> begin(const std::string& viewer, HostNs now);
  /// The viewer still watches, and may answer. Returns the state of the check as JSON
  /// (CHANNELS.md).
  Result<std::string> watch(const server::Request& request);
  /// The client of that name is gone: ends its check.
  void lose(const std::string& viewer);
  /// Ends a check at once; without one it does nothing. Takes no lock.
  void stop() { stop_.store(true, std::memory_order_release); }
  bool on() const { return on_.load(std::memory_order_acquire); }
  PortHandover& handover() { return handover_; }
  /// Host time at which the robot acknowledged last that a check had switched its motors off; 0: no
  /// check has.
  HostNs motors_off_ns() const { return motors_off_ns_; }

  // The check's thread:
  void say(const std::string& line) override;
  void ask(const doctor::Question& question) override;
  std::optional<std::string> take_answer() override;
  bool ended() const override { return false; }
  bool watches() const override;
  void motors_off(HostNs at) override { motors_off_ns_ = at; }

 private:
  void lose_viewer(const std::string& why);
  void finish(const doctor::Findings& findings, const std::string& port);
  doctor::Findings examine(const course::Robot& robot, std::string& port);

  const config::Configuration configuration_;
  messages::EventQueue& events_;
  PortHandover handover_;
  std::atomic<bool> stop_{false}, on_{false};
  std::atomic<HostNs> input_ns_{0};  // of the viewer's newest sign of life
  std::atomic<HostNs> motors_off_ns_{0};
  std::mutex mutex_;  // guards what follows; held for moments only
  course::Robot robot_;
  server::Lease lease_;
  std::string step_;
  std::optional<doctor::Question> question_{};
  unsigned question_number_ = 0;
  std::optional<std::string> answer_{};
  std::string result_;            // JSON; empty: not ended
  std::string lost_;              // why its viewer no longer watches
  Worker check_{"tracks check"};  // declared last: its jobs use the others
};

}  // namespace tp100::selftest
