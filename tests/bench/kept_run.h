#pragma once
// Course 3 with everything on, driven by the emulated robot, to be fed to a fresh step.

#include <memory>
#include <utility>
#include <vector>

#include "bridge/parameters.h"
#include "config/configuration.h"
#include "kept_steps.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::test {

struct KeptRun {
  bridge::Parameters parameters;
  std::shared_ptr<const course::Course> course;
  std::vector<StepRecord> records;
  bool completed = false;
};

/// Filter, overhead camera and control; terrain as the set-up says.
inline KeptRun keep_course_3(bridge::Setup setup) {
  sim::Loaded loaded = sim::load({});
  loaded.configuration.parameters.steering = bridge::Steering::kFused;
  KeptRun run;
  run.course = std::make_shared<const course::Course>(sim::load_course("3"));
  run.parameters = config::bridge_parameters(loaded.configuration, loaded.robot);
  run.parameters.setup = setup;
  StepKeeper keeper;
  run.completed = sim::run_lockstep({.course = *run.course,
                                     .robot = loaded.robot,
                                     .configuration = loaded.configuration,
                                     .setup = setup,
                                     .camera = sim::load_camera("overhead"),
                                     .sink = &keeper})
                      .completed;
  run.records = std::move(keeper.records);
  return run;
}

}  // namespace tp100::test
