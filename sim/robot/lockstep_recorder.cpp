#include "sim/robot/lockstep_recorder.h"

#include <cstdio>
#include <utility>

#include "core/faults.h"
#include "messages/foxglove.h"
#include "record/recording_file.h"

namespace tp100::sim {
namespace {

record::RunFacts facts_of(const Loaded& loaded, const config::RunSetup& run, std::uint64_t seed) {
  return config::run_facts(loaded.files, run,
                           {{"program", "tp100-sim course"},
                            {"board", to_string(loaded.board)},
                            {"seed", std::to_string(seed)}});
}

// Virtual time begins at zero, also on the clock of viewers.
record::RecordingSettings settings_of(const std::string& folder, const config::RunSetup& run,
                                      std::uint64_t seed) {
  return {.path = folder + "/" + run.course->name + "-" + run.robot.name + "-" +
                  std::to_string(seed) + "/" + record::kRecordingFile,
          .max_bytes = std::uint64_t{1'000'000} *
                       static_cast<std::uint64_t>(run.configuration.record.max_mb)};
}

}  // namespace

LockstepRecorder::LockstepRecorder(const std::string& folder, const Loaded& loaded,
                                   std::uint64_t seed)
    : LockstepRecorder(folder, loaded, config::parse_run(loaded.files), seed) {}

LockstepRecorder::LockstepRecorder(const std::string& folder, const Loaded& loaded,
                                   const config::RunSetup& run, std::uint64_t seed)
    : messages_(facts_of(loaded, run, seed).run_context, {}) {
  recorder_.begin(settings_of(folder, run, seed), facts_of(loaded, run, seed));
}

void LockstepRecorder::take(const StepRecord& record) {
  recorder_.take(record);
  const Snapshot& snapshot = record.snapshot;
  if (snapshot.run_state == run_state_) return;
  const RunState from = std::exchange(run_state_, snapshot.run_state);
  this->record(
      {.at_ns = record.now_ns, .kind = "run", .text = change_text("state", from, run_state_)});
  if (run_state_ != RunState::kAborted) return;
  each_fault(snapshot.faults,
             [&](Fault fault) { this->record(messages::fault_event(record.now_ns, fault)); });
}

void LockstepRecorder::record(LockstepSettings& settings) {
  settings.add(*this);
  settings.on_disturbance = [this](HostNs at) { take_disturbance(at); };
}

void LockstepRecorder::take_disturbance(HostNs at) {
  messages::Event event;
  event.at_ns = at;
  event.kind = "push";
  event.text = "the robot is pushed";
  record(event);
}

void LockstepRecorder::record(const messages::Event& event) {
  recorder_.message(messages::Channel::kEvent, event.at_ns, messages_.event(event));
  recorder_.message(messages::Channel::kLog, event.at_ns, messages::log_text(messages_, event));
}

void LockstepRecorder::take_truth(HostNs at, const Pose& truth) { recorder_.take_truth(at, truth); }

void LockstepRecorder::finish() {
  recorder_.end();
  const std::string warning = recorder_.status().warning;
  if (!warning.empty()) std::fprintf(stderr, "tp100-sim: %s\n", warning.c_str());
}

}  // namespace tp100::sim
