#pragma once
// A session and a scripted robot, connected without loss or delay and run in steps of 1 ms.

#include <string>
#include <vector>

#include "link/session.h"
#include "scripted_robot.h"

namespace tp100::link {

class SessionRig {
 public:
  static SessionSettings settings() {
    SessionSettings settings;
    settings.baud = 0;
    return settings;
  }

  explicit SessionRig(const SessionSettings& with = settings()) : session(with) {}

  /// Runs for `ms` milliseconds. The robot's bytes pass through `mangle` first.
  void run(int ms) {
    for (int i = 0; i < ms; ++i) step();
  }
  void step() {
    now += kNsPerMs;
    robot.tick(now);
    std::vector<std::uint8_t> bytes = robot.take();
    if (mangle) mangle(bytes);
    session.receive(bytes, now);
    session.poll(now);
    for (const Sample& sample : session.take_samples()) samples.push_back(sample);
    if (commands && session.state() == SessionState::kReady) session.send(command, now);
    for (const SessionEvent& event : session.take_events()) {
      events.push_back(event);
      if (const StateChanged* changed = as<StateChanged>(event))
        states += (states.empty() ? "" : " ") + std::string(to_string(changed->to));
    }
    if (!port_takes) return;
    if (!loses_output) robot.receive(session.output(), now);
    session.written(session.output().size());
  }
  void connect() {
    session.open(now);
    run(400);
  }
  /// Runs until the next sample has come.
  void run_to_sample() {
    for (const std::size_t before = samples.size(); samples.size() == before;) step();
  }
  /// The events of one kind.
  template <class What>
  std::vector<What> of() const {
    std::vector<What> all;
    for (const SessionEvent& event : events)
      if (const What* what = as<What>(event)) all.push_back(*what);
    return all;
  }
  template <class What>
  int count() const {
    return static_cast<int>(of<What>().size());
  }

  HostNs now = kNsPerS;
  ScriptedRobot robot{0};
  Session session;
  std::function<void(std::vector<std::uint8_t>&)> mangle;
  bool port_takes = true;
  bool loses_output = false;
  bool commands = false;
  Command command{};
  std::vector<Sample> samples;
  std::vector<SessionEvent> events;
  std::string states;
};

}  // namespace tp100::link
