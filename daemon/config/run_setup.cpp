#include "config/run_setup.h"

#include "core/enum_names.h"
#include "core/error.h"
#include "core/processor.h"
#include "terrain/climbable.h"

namespace tp100::config {

namespace {

/// All but the configuration.
void parse_rest(const RunFiles& files, RunSetup& run) {
  run.configuration.parameters.setup = files.setup;
  run.configuration.parameters.world.kind = files.world;
  run.robot = course::parse_robot(files.robot.text, files.robot.path);
  run.course.reset();
  if (!files.course.text.empty())
    run.course = std::make_shared<const course::Course>(
        course::parse_course(files.course.text, files.course.path));
  run.parameters = bridge_parameters(run.configuration, run.robot);
}

}  // namespace

RunSetup parse_run(const RunFiles& files) {
  RunSetup run;
  run.configuration = parse_configuration(files.configuration.text, files.configuration.path);
  parse_rest(files, run);
  return run;
}

void require_fit(const RunSetup& run) {
  if (!run.configuration.camera.listen.empty() && run.parameters.setup == bridge::Setup::kStand)
    throw UserError("--camera: on a stand it sees a robot that stands still; leave it out");
  if (run.course != nullptr) terrain::require_climbable(*run.course, run.robot);
}

LoadedRun with_files(const LoadedRun& run, const course::TextFile& course,
                     const course::TextFile& robot, bridge::Setup setup) {
  LoadedRun out = run;
  out.files.course = course;
  out.files.robot = robot;
  out.files.setup = setup;
  parse_rest(out.files, out.setup);
  return out;
}

WorldRun world_run(const RunSetup& run) {
  WorldRun out;
  out.parameters = run.parameters.world;
  out.settings = run.configuration.world;
  out.version = TP100_VERSION;
  out.setup = bridge::to_string(run.parameters.setup);
  if (run.course == nullptr) return out;
  out.course = run.course->name;
  for (const course::Surface& surface : run.course->terrain.surfaces)
    out.surfaces.emplace_back(surface.name, surface.slip_offset);
  return out;
}

bridge::Setup setup_option(const std::string& option, bridge::Setup configured) {
  if (option.empty()) return configured;
  if (const auto setup = value_in(bridge::kSetupNames, option)) return *setup;
  throw UserError("--setup " + one_line(option) + ": not a set-up; use stand, flat or terrain");
}

bridge::WorldKind world_option(const std::string& option, bridge::WorldKind configured) {
  if (option.empty()) return configured;
  if (option.starts_with("udp:")) return bridge::WorldKind::kUdp;
  const auto kind = value_in(bridge::kWorldKindNames, option);
  if (kind && *kind != bridge::WorldKind::kUdp) return *kind;
  throw UserError("--world " + one_line(option) +
                  ": not a world; use internal, files or udp:[HOST:]PORT, as in udp:9760");
}

messages::RunContext run_context_of(const RunSetup& run) {
  return {.version = TP100_VERSION,
          .course = run.course,
          .robot = run.robot,
          .setup = bridge::to_string(run.parameters.setup),
          .world = bridge::to_string(run.parameters.world.kind),
          .pacing = name_in(kPacingNames, run.configuration.loop.pacing),
          .rate_hz = run.configuration.loop.rate_hz,
          .stop_unwatched = run.configuration.server.stop_unwatched};
}

record::RunFacts run_facts(const RunFiles& files, const RunSetup& run,
                           const record::McapMap& more) {
  record::RunFacts facts;
  facts.run_context = run_context_of(run);
  facts.facts = {{"course", run.course == nullptr ? "" : run.course->name},
                 {"robot", run.robot.name},
                 {"setup", facts.run_context.setup},
                 {"world", bridge::to_string(files.world)},
                 {kArithmeticFact, arithmetic()}};
  facts.facts.insert(facts.facts.end(), more.begin(), more.end());
  const auto attach = [&facts](const char* name, const course::TextFile& file) {
    facts.files.push_back(
        {.name = name, .media_type = "application/toml", .log_ns = 0, .data = file.text});
  };
  attach(kConfigurationFile, files.configuration);
  attach(kRobotFile, files.robot);
  if (!files.course.text.empty()) attach(kCourseFile, files.course);
  return facts;
}

}  // namespace tp100::config
