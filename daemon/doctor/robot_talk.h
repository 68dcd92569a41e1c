#pragma once
// The session with the robot on a port, turned by hand: for commands of the program that look at a
// robot or try its tracks without the loop, the step and the server of a run. One thread.

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "core/sample.h"
#include "core/time.h"
#include "link/session.h"
#include "link/transport.h"

namespace tp100::doctor {

class RobotTalk {
 public:
  /// `stop` ends every turning; it outlives the talk.
  RobotTalk(link::Port port, const link::SessionSettings& settings, const std::atomic<bool>& stop);
  RobotTalk(const RobotTalk&) = delete;
  RobotTalk& operator=(const RobotTalk&) = delete;

  /// Reads, answers and commands until `enough`, or `limit_s` has passed, the port is gone or
  /// somebody stops. Returns whether it was enough.
  bool turn(double limit_s, const std::function<bool()>& enough);

  /// What is commanded from now on; at first nothing. An armed robot moves by it.
  void command(double speed_mps, double yaw_rate_radps);
  /// Arms and waits. False: refused, or not acknowledged; why() and remedy() say it.
  bool arm();
  /// Motors off; waits until that is acknowledged or given up. Works when somebody stops, too.
  void disarm();

  /// Called with each sample and the time at which it was read.
  std::function<void(const Sample&, HostNs)> on_sample = [](const Sample&, HostNs) {};
  /// Called with the time from writing a command to reading the first sample that confirms it. [ns]
  std::function<void(HostNs)> on_confirmed = [](HostNs) {};

  const link::Session& session() const { return session_; }
  const Sample& newest() const { return newest_; }
  bool greeted() const { return greeted_; }  ///< a hello came, of whatever version
  bool gone() const { return gone_; }
  /// Its motors were on for 100 ms although arm() had not asked for it. It is told to stop as long
  /// as they are.
  bool moved_unasked() const { return moved_unasked_; }
  const std::string& why() const { return why_; }
  const std::string& remedy() const { return remedy_; }
  /// Index of the parameter that the firmware refused; -1: none.
  int refused_parameter() const { return refused_parameter_; }

 private:
  void turn_once();
  void read(HostNs now);
  void take(HostNs now);
  void note(const link::SessionEvent& event);
  void watch(const Sample& sample, HostNs now);
  void send(HostNs now);
  void write();

  link::Port port_;
  link::Session session_;
  const std::atomic<bool>& stop_;
  Sample newest_{};
  bool greeted_ = false;
  bool gone_ = false;
  std::string why_;
  std::string remedy_;
  int refused_parameter_ = -1;
  bool acknowledged_ = false;
  bool asked_ = false;  // armed by arm()
  std::optional<HostNs> on_since_ns_;
  HostNs next_stop_ns_ = 0;
  bool moved_unasked_ = false;

  double speed_mps_ = 0.0;
  double yaw_rate_radps_ = 0.0;
  std::uint32_t session_number_ = 0;
  std::uint16_t sequence_ = 0;  // of the last command that was written
  std::uint16_t awaited_ = 0;   // a command whose confirmation is awaited
  HostNs awaited_since_ns_ = 0;
  bool awaiting_ = false;
  HostNs next_command_ns_ = 0;
};

}  // namespace tp100::doctor
