#include "report/run_monitor.h"

#include <utility>

namespace tp100::report {

void RunMonitor::add(RunEvent event) {
  if (events_.size() < kMax)
    events_.push_back(std::move(event));
  else
    ++more_;
}

void RunMonitor::step(const StepRecord& record) {
  if (!first_ && record.step != step_ + 1)
    add({.at_ns = record.now_ns,
         .text = "steps " + std::to_string(step_ + 1) + " to " + std::to_string(record.step - 1) +
                 " are not in the recording",
         .fix = "record to a faster disk",
         .bad = true});
  step_ = record.step;
  for (std::uint32_t i = 0; i < record.inputs.requests.size(); ++i)
    add({.at_ns = record.now_ns,
         .text = std::string("operator: ") + to_string(record.inputs.requests[i])});
  if (record.inputs.robot_rebooted)
    add({.at_ns = record.now_ns, .text = "the robot has booted", .bad = !first_});
  if (record.inputs.answer == RequestAnswer::kFailed)
    add({.at_ns = record.now_ns,
         .text = "the robot refused or did not confirm arm or disarm",
         .bad = true});
  states(record);
  faults(record);
  first_ = false;
}

void RunMonitor::states(const StepRecord& record) {
  const Snapshot& snapshot = record.snapshot;
  const auto report = [&](std::string text) {
    add({.at_ns = record.now_ns, .text = std::move(text)});
  };
  if (record.inputs.session != session_)
    report(change_text("link", session_, record.inputs.session));
  session_ = record.inputs.session;
  if (snapshot.run_state != run_) report(change_text("run", run_, snapshot.run_state));
  run_ = snapshot.run_state;
  if (snapshot.recovering != recovering_)
    report(snapshot.recovering ? "a disturbance was detected" : "back on the path");
  recovering_ = snapshot.recovering;
  if (!snapshot.has_sample || snapshot.sample.state == robot_) return;
  report(std::string("robot: ") + to_string(snapshot.sample.state));
  robot_ = snapshot.sample.state;
}

void RunMonitor::faults(const StepRecord& record) {
  each_fault(record.snapshot.faults & ~faults_, [&](Fault fault) {
    const FaultText& words = describe(fault);
    add({.at_ns = record.now_ns,
         .text = std::string(words.name) + ": " + std::string(words.cause),
         .fix = std::string(words.fix),
         .bad = true});
  });
  faults_ = record.snapshot.faults;
}

}  // namespace tp100::report
