#include "live/run_recorder.h"

#include <utility>

namespace tp100::live {
namespace {

constexpr HostNs kTailNs = kNsPerS;

}  // namespace

// Who looks on may have ended it, and begun another.
void RunRecorder::end() {
  if (own_ != 0) recording_.stop(own_, [](const std::string&) {});
  own_ = 0;
}

void RunRecorder::on_run_state(RunState to, HostNs now) {
  if (!on_) return;
  if (to != RunState::kArming) {
    if (to != RunState::kRunning && own_ != 0) end_ns_ = now + kTailNs;
    return;
  }
  end_ns_.reset();
  end();
  if (recording_.number() != 0) return;
  own_ = recording_.start("", [note = note_](const std::string& why) {
    if (why.empty()) return;
    const std::lock_guard lock(note->mutex);
    note->text = "this run is not recorded: " + why;
  });
}

void RunRecorder::tick(HostNs now) {
  if (!end_ns_ || now < *end_ns_) return;
  end_ns_.reset();
  end();
}

std::string RunRecorder::take_note() {
  const std::lock_guard lock(note_->mutex);
  return std::exchange(note_->text, {});
}

}  // namespace tp100::live
