#pragma once
// A session and a scripted robot, connected without loss or delay and run in steps of 1 ms.

#include <algorithm>
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
    if (split == 0) {
      session.receive(bytes, now);
    } else {
      for (std::size_t at = 0; at < bytes.size(); at += split) {
        session.receive(std::span(bytes).subspan(at, std::min(split, bytes.size() - at)), now);
      }
    }
    session.poll(now);
    for (const Sample& sample : session.take_samples()) samples.push_back(sample);
    if (commands && session.state() == SessionState::kReady) session.send(command, now);
    collect();
    if (loses_output) session.written(session.output().size());
    if (port_takes) {
      robot.receive(session.output(), now);
      session.written(session.output().size());
    }
  }
  void collect() {
    for (const SessionEvent& event : session.take_events()) {
      events.push_back(event);
      if (const StateChanged* changed = as<StateChanged>(event)) {
        states += states.empty() ? "" : " ";
        states += to_string(changed->to);
      }
    }
  }
  void connect() {
    session.open(now);
    run(400);
  }
  template <class What>
  int count() const {
    return static_cast<int>(std::count_if(events.begin(), events.end(), [](const SessionEvent& e) {
      return as<What>(e) != nullptr;
    }));
  }

  HostNs now = kNsPerS;
  ScriptedRobot robot{0};
  Session session;
  std::function<void(std::vector<std::uint8_t>&)> mangle;
  std::size_t split = 0;
  bool port_takes = true;
  bool loses_output = false;
  bool commands = false;
  Command command{};
  std::vector<Sample> samples;
  std::vector<SessionEvent> events;
  std::string states;
};

}  // namespace tp100::link
