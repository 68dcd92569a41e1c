#pragma once
// A run of course 3 by the emulated robot with all features enabled, kept as the input of a new
// step.

#include <memory>
#include <utility>
#include <vector>

#include "bridge/parameters.h"
#include "config/configuration.h"
#include "core/step_record.h"
#include "messages/sink.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::test {

class StepKeeper : public messages::Sink {
 public:
  void take(const StepRecord& record) override { records.push_back(record); }
  std::vector<StepRecord> records;
};

struct KeptRun {
  bridge::Parameters parameters;
  std::shared_ptr<const course::Course> course;
  std::vector<StepRecord> records;
  bool completed = false;
};

/// Runs with filter, overhead camera and control; `setup` determines the terrain.
inline KeptRun keep_course_3(bridge::Setup setup) {
  sim::Loaded loaded = sim::load({});
  loaded.configuration.parameters.steering = PoseSource::kFused;
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
                                     .sinks = {&keeper}})
                      .completed;
  run.records = std::move(keeper.records);
  return run;
}

}  // namespace tp100::test
