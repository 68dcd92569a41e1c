#include "app/run_recorder.h"

#include "core/error.h"

namespace tp100::app {
namespace {

constexpr HostNs kTailNs = kNsPerS;

}  // namespace

// Who looks on may have ended it, and begun another.
bool RunRecorder::under_way() const {
  const publish::RecordingFigures is = recording_.figures();
  return is.active && is.file == own_;
}

std::string RunRecorder::on_run_state(RunState to, HostNs now) {
  if (!on_) return {};
  if (to != RunState::kArming) {
    if (to != RunState::kRunning && !own_.empty()) end_ns_ = now + kTailNs;
    return {};
  }
  end_ns_.reset();
  if (under_way()) recording_.stop();
  own_.clear();
  if (recording_.figures().active) return {};
  try {
    recording_.start("");
  } catch (const SetupError& error) {
    return std::string("this run is not recorded: ") + error.what();
  }
  own_ = recording_.figures().file;
  return {};
}

void RunRecorder::tick(HostNs now) {
  if (!end_ns_ || now < *end_ns_) return;
  end_ns_.reset();
  if (under_way()) recording_.stop();
  own_.clear();
}

}  // namespace tp100::app
