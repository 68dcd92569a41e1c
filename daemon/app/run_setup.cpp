#include "app/run_setup.h"

namespace tp100::app {

RunSetup parse_run(const RunFiles& files) {
  RunSetup run;
  run.configuration = parse_configuration(files.configuration.text, files.configuration.path);
  run.configuration.parameters.setup = files.setup;
  run.robot = course::parse_robot(files.robot.text, files.robot.path);
  if (!files.course.text.empty())
    run.course = std::make_shared<const course::Course>(
        course::parse_course(files.course.text, files.course.path));
  run.parameters = bridge_parameters(run.configuration, run.robot);
  return run;
}

publish::RunFacts run_facts(const RunFiles& files, const RunSetup& run,
                            const publish::McapMap& more) {
  publish::RunFacts facts;
  facts.subject = {.version = TP100_VERSION,
                   .course = run.course,
                   .robot = run.robot,
                   .setup = bridge::to_string(files.setup),
                   .steering = bridge::to_string(run.parameters.steering),
                   .pacing = run.configuration.loop.pacing == Pacing::kHost ? "host" : "robot",
                   .rate_hz = run.configuration.loop.rate_hz};
  facts.facts = {{"course", run.course == nullptr ? "" : run.course->name},
                 {"robot", run.robot.name},
                 {"setup", facts.subject.setup}};
  facts.facts.insert(facts.facts.end(), more.begin(), more.end());
  const auto attach = [&facts](const char* name, const TextFile& file) {
    facts.files.push_back(
        {.name = name, .media_type = "application/toml", .log_ns = 0, .data = file.text});
  };
  attach(kConfigurationFile, files.configuration);
  attach(kRobotFile, files.robot);
  if (!files.course.text.empty()) attach(kCourseFile, files.course);
  return facts;
}

}  // namespace tp100::app
