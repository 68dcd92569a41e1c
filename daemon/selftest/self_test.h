#pragma once
// `tp100d doctor` from within the running daemon, for its machine and its port, with the same
// findings. Nothing moves except in wheels_up().

#include <mutex>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "core/worker.h"
#include "course/robot_file.h"
#include "loop/real_time.h"
#include "messages/sink.h"
#include "selftest/session_monitor.h"
#include "selftest/wheels_up_check.h"
#include "server/service.h"

namespace tp100::selftest {

/// The part that is examined at a time, in the order of `tp100d doctor`.
enum class DoctorPart { kPort, kRobot, kMachine };

class SelfTest : public messages::Sink {
 public:
  using Answer = server::Answer;

  /// Configuration and robot in force, with the command line's values; `events` must outlive it,
  /// and it must outlive `disk`.
  SelfTest(config::Configuration configuration, const course::Robot& robot, Worker& disk,
           messages::EventQueue& events);

  /// doctor and wheels_up_watch.
  std::vector<server::ServiceRow> services();

  // The main thread:
  void on_event(const link::SessionEvent& event, const wire::Hello& hello, const OpenPort& port);
  /// A line about the search for the port.
  void note_port(const std::string& line);
  /// The privileges that were requested.
  void set_privileges(const std::vector<loop::Privilege>& privileges);
  void take(const StepRecord& record) override;
  /// Another robot is in force.
  void choose(const course::Robot& robot);

  /// Answers with the findings as JSON (CHANNELS.md, doctor): port and machine from the thread that
  /// waits for disks, the robot after a second, or five if it is silent. One at a time.
  /// Any thread; does not wait.
  void examine(DoctorPart part, Answer answer);
  /// The part that moves.
  WheelsUpCheck& wheels_up() { return wheels_up_; }

 private:
  void finish(const std::string& why, const std::string& json);
  std::string port_findings() const;
  std::string machine_findings() const;

  const config::Configuration configuration_;
  Worker& disk_;
  WheelsUpCheck wheels_up_;
  mutable std::mutex mutex_;  // guards what follows; never held while waiting for a file
  SessionMonitor monitor_;
  double battery_cutoff_v_ = 0.0;
  std::string note_;
  std::vector<loop::Privilege> privileges_;
  Answer answer_;  // set: an examination is under way
};

}  // namespace tp100::selftest
