#include "selftest/session_watch.h"

#include "bridge/cycle.h"
#include "core/board.h"
#include "core/faults.h"

namespace tp100::selftest {
namespace {

// As long as `tp100d doctor` takes for both.
constexpr HostNs kTestNs = kNsPerS;
constexpr HostNs kPatienceNs = 5 * kNsPerS;

}  // namespace

void SessionWatch::hear(const link::SessionEvent& event, const wire::Hello& hello,
                        const OpenPort& port) {
  port_ = port;
  hello_ = hello;
  if (const auto* changed = link::as<link::StateChanged>(event)) {
    // Another board may be behind the port that is opened next.
    if (changed->to == SessionState::kClosed) greeted_ = false;
  } else if (link::as<link::HelloReceived>(event) || link::as<link::VersionMismatch>(event)) {
    greeted_ = true;
    refused_parameter_ = -1;
  } else if (const auto* answer = link::as<link::Acknowledged>(event)) {
    if (answer->request == wire::Type::kParameters && answer->result == wire::Result::kOutOfRange)
      refused_parameter_ = answer->detail;
  }
}

void SessionWatch::take(const StepRecord& record) {
  session_ = record.inputs.session;
  follow_commands(record);
  if (visiting_ == Visiting::kAsked) {
    visiting_ = Visiting::kWaiting;
    begun_ns_ = record.now_ns;
    before_ = record.link;
  }
  if (visiting_ == Visiting::kWaiting && session_ == SessionState::kReady) {
    visiting_ = Visiting::kMeasuring;
    ready_ns_ = record.now_ns;
    ready_before_ = record.link;
    samples_ = 0;
    age_.emplace();
    round_trip_.emplace();
  } else if (visiting_ == Visiting::kMeasuring) {
    measure(record);
  }
  const bool measured = visiting_ == Visiting::kMeasuring && record.now_ns - ready_ns_ >= kTestNs;
  const bool waited = visiting_ == Visiting::kWaiting && record.now_ns - begun_ns_ >= kPatienceNs;
  if (!measured && !waited) return;
  visiting_ = Visiting::kDone;
  ended_ns_ = record.now_ns;
  after_ = record.link;
  clock_ = record.inputs.clock;
  newest_ = record.snapshot.sample;
  has_sample_ = record.snapshot.has_sample && session_ == SessionState::kReady;
  faults_ = record.snapshot.faults;
}

void SessionWatch::measure(const StepRecord& record) {
  for (const Sample& sample : record.inputs.samples) {
    ++samples_;
    age_->add(record.now_ns - sample.measured_ns);
  }
}

void SessionWatch::follow_commands(const StepRecord& record) {
  // A record that was dropped on its way to this thread most likely had a command.
  const std::uint64_t missing = record.step > step_ + 1 ? record.step - step_ - 1 : 0;
  step_ = record.step;
  if (session_ != SessionState::kReady || record.inputs.session_number != session_number_) {
    session_number_ = record.inputs.session_number;
    awaited_.reset();
    // Nothing was sent in this session yet; sequence numbers continue from here.
    for (const Sample& sample : record.inputs.samples) sent_ = sample.last_command;
  } else {
    sent_ = static_cast<std::uint16_t>(sent_ + missing);
  }
  for (const Sample& sample : record.inputs.samples) {
    if (!awaited_ || static_cast<std::int16_t>(sample.last_command - *awaited_) < 0) continue;
    if (visiting_ == Visiting::kMeasuring) round_trip_->add(record.now_ns - awaited_since_ns_);
    awaited_.reset();
  }
  if (!record.command_valid) return;
  ++sent_;
  if (awaited_) return;
  awaited_ = sent_;
  awaited_since_ns_ = record.now_ns;
}

void SessionWatch::begin() { visiting_ = Visiting::kAsked; }

doctor::LinkTest SessionWatch::link_test() const {
  doctor::LinkTest test;
  test.duration_s = to_s(ended_ns_ - ready_ns_);
  test.samples = samples_;
  test.expected_samples = test.duration_s * 1e6 / wire::kSamplePeriodUs;
  test.counters = after_ - ready_before_;
  test.age = doctor::percentiles(*age_);
  test.round_trip = doctor::percentiles(*round_trip_);
  test.confirmed = static_cast<std::size_t>(round_trip_->count());
  test.clock_known = clock_.valid;
  test.clock_uncertainty_us = clock_.uncertainty_us;
  test.clock_drift_ppm = clock_.drift * 1e6;
  return test;
}

std::optional<doctor::Visit> SessionWatch::done() {
  if (visiting_ != Visiting::kDone) return std::nullopt;
  visiting_ = Visiting::kNo;
  const LinkCounters change = after_ - before_;
  doctor::Visit visit;
  visit.port = port_.path;
  visit.bytes_in = change.bytes_in;
  visit.frames_in = change.frames_in;
  if (greeted_) {
    doctor::add_hello(hello_, visit);
    visit.emulator = is_emulator(port_.pseudo_terminal, hello_.board);
  }
  if (refused_parameter_ >= 0)
    visit.refused = bridge::parameter_name(static_cast<unsigned>(refused_parameter_));
  visit.reboots = change.reboots;
  visit.ready = has_sample_;
  if (!visit.ready) return visit;
  doctor::add_sample(newest_, visit);
  visit.moved_unasked = (faults_ & fault_bit(Fault::moves_unasked)) != 0;
  visit.link = link_test();
  return visit;
}

}  // namespace tp100::selftest
