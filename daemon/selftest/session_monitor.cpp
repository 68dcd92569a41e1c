#include "selftest/session_monitor.h"

#include "bridge/cycle.h"
#include "core/board.h"
#include "core/faults.h"
#include "core/time.h"

namespace tp100::selftest {

void SessionMonitor::on_event(const link::SessionEvent& event, const wire::Hello& hello,
                              const OpenPort& port) {
  port_ = port;
  hello_ = hello;
  if (const auto* changed = link::as<link::StateChanged>(event)) {
    // Another board may be behind the port that is opened next.
    if (changed->to == SessionState::kClosed) identified_ = false;
  } else if (link::as<link::HelloReceived>(event) || link::as<link::VersionMismatch>(event)) {
    identified_ = true;
    refused_parameter_ = -1;
  } else if (const auto* answer = link::as<link::Acknowledged>(event)) {
    if (answer->request == wire::Type::kParameters && answer->result == wire::Result::kOutOfRange)
      refused_parameter_ = answer->detail;
  }
}

void SessionMonitor::take(const StepRecord& record) {
  session_ = record.inputs.session;
  follow(record);
  if (probing_ == Probing::kAsked) {
    probing_ = Probing::kWaiting;
    begun_ns_ = record.now_ns;
    before_ = record.link;
  }
  if (probing_ == Probing::kWaiting && session_ == SessionState::kReady) {
    probing_ = Probing::kMeasuring;
    ready_ns_ = record.now_ns;
    meter_.begin(record.link, record.now_ns);
  }
  const bool measured =
      probing_ == Probing::kMeasuring && record.now_ns - ready_ns_ >= from_s(doctor::kLinkTestS);
  const bool waited =
      probing_ == Probing::kWaiting && record.now_ns - begun_ns_ >= from_s(doctor::kFirstFrameS);
  if (!measured && !waited) return;
  probing_ = Probing::kDone;
  ended_ns_ = record.now_ns;
  after_ = record.link;
  clock_ = record.inputs.clock;
  newest_ = record.snapshot.sample;
  has_sample_ = record.snapshot.has_sample && session_ == SessionState::kReady;
  faults_ = record.snapshot.faults;
}

void SessionMonitor::follow(const StepRecord& record) {
  // A record that was dropped on its way to this thread most likely contained a command.
  if (record.step > step_ + 1) meter_.skip(record.step - step_ - 1);
  step_ = record.step;
  if (session_ != SessionState::kReady || record.inputs.session_number != session_number_) {
    session_number_ = record.inputs.session_number;
    meter_.restart(record.inputs.samples);
  }
  for (const Sample& sample : record.inputs.samples) meter_.on_sample(sample, record.now_ns);
  if (record.command_valid) meter_.on_command(record.now_ns);
}

void SessionMonitor::begin() { probing_ = Probing::kAsked; }

std::optional<doctor::ProbeResult> SessionMonitor::done() {
  if (probing_ != Probing::kDone) return std::nullopt;
  probing_ = Probing::kNo;
  const LinkCounters change = after_ - before_;
  doctor::ProbeResult probe;
  probe.port = port_.path;
  probe.bytes_in = change.bytes_in;
  probe.frames_in = change.frames_in;
  if (identified_) {
    doctor::add_hello(hello_, probe);
    probe.emulator = is_emulator(port_.pseudo_terminal, hello_.board);
  }
  if (refused_parameter_ >= 0)
    probe.refused = bridge::parameter_name(static_cast<unsigned>(refused_parameter_));
  probe.reboots = change.reboots;
  probe.ready = has_sample_;
  if (!probe.ready) return probe;
  doctor::add_sample(newest_, probe);
  probe.moved_unasked = (faults_ & fault_bit(Fault::moves_unasked)) != 0;
  probe.link = meter_.end(after_, clock_, ended_ns_);
  return probe;
}

}  // namespace tp100::selftest
