#pragma once
// A short recording: the daemon's cycle with a scripted robot at standstill.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "../link/scripted_robot.h"
#include "bridge/cycle.h"
#include "config/run_setup.h"
#include "record/recorder.h"
#include "record/step_codec.h"

namespace tp100::app {

/// Records two seconds of course 1-curve at 200 steps per second; a parameter changes after one
/// second. `edit` may change a record before it is recorded, or drop it by returning false. The
/// recording begins after `begin_at` steps. `facts` are added to the run's own facts or override
/// them.
inline void record_run(
    const std::string& path,
    const std::function<bool(StepRecord&)>& edit = [](StepRecord&) { return true; },
    const record::McapMap& facts = {{"seed", "5"}}, int begin_at = 0, bool compress = true,
    const std::function<void(record::Recorder&, HostNs now)>& at_end = {}) {
  config::RunFiles files;
  files.robot = course::read_bundled(course::Bundled::kRobots, "end-loaded");
  files.course = course::read_bundled(course::Bundled::kCourses, "1-curve");
  const config::RunSetup run = config::parse_run(files);
  record::Recorder recorder({.history = record::HistorySettings{}, .blocking = true});
  const auto begin = [&] {
    record::RunFacts all = config::run_facts(files, run, {});
    for (const auto& fact : facts) {
      std::erase_if(all.facts, [&](const auto& own) { return own.first == fact.first; });
      all.facts.push_back(fact);
    }
    recorder.begin({.path = path, .compress = compress, .clock = {kNsPerS, 0}}, all);
  };
  ScriptedRobot robot;
  bridge::Cycle cycle(bridge::session_settings(run.parameters), run.parameters, run.course);
  HostNs now = kNsPerS;
  cycle.session().open(now);
  cycle.request(OperatorRequest::kStart);
  const auto record = std::make_unique<StepRecord>();
  for (int i = 0; i < 400; ++i) {
    if (i == begin_at) begin();
    now += 5 * kNsPerMs;
    robot.tick(now);
    cycle.session().receive(robot.take(), now);
    if (i == 200) cycle.change({LiveParameter::kAcceleration, 0.05});
    cycle.step(now);
    cycle.record(*record);
    if (edit(*record)) recorder.take(*record);
    cycle.session().take_events();
    robot.receive(cycle.session().output(), now);
    cycle.session().written(cycle.session().output().size());
  }
  if (at_end) at_end(recorder, now);
}

}  // namespace tp100::app
