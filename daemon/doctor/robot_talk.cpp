#include "doctor/robot_talk.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "bridge/cycle.h"
#include "core/board.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/faults.h"
#include "core/histogram.h"
#include "doctor/hello.h"

namespace tp100::doctor {
namespace {

// Same period and life of a command as a run at its default rate.
constexpr HostNs kCommandPeriodNs = 5 * kNsPerMs;
constexpr DeviceUs kCommandLifeUs = 150'000;
constexpr double kArmLimitS = 1.0;
constexpr double kDisarmLimitS = 0.5;
constexpr HostNs kUnaskedNs = 100 * kNsPerMs;
constexpr HostNs kStopAgainNs = 200 * kNsPerMs;

constexpr double kFirstFrameS = 5.0;
constexpr double kHandshakeS = 4.0;
constexpr double kBootloaderS = 2.0;
// Enough time to detect a bad sensor or a low battery.
constexpr double kLookS = 0.2;

doctor::LinkTest test_link(RobotTalk& talk, double duration_s) {
  Histogram age;
  Histogram round_trip;
  std::size_t samples = 0;
  talk.on_sample = [&](const Sample& sample, HostNs now) {
    ++samples;
    age.add(now - sample.measured_ns);
  };
  talk.on_confirmed = [&](HostNs took) { round_trip.add(took); };
  const LinkCounters before = talk.session().counters();
  const HostNs begun = monotonic_now();
  talk.turn(duration_s, [] { return false; });
  doctor::LinkTest test;
  test.duration_s = to_s(monotonic_now() - begun);
  talk.on_sample = [](const Sample&, HostNs) {};
  talk.on_confirmed = [](HostNs) {};
  test.samples = samples;
  test.expected_samples = test.duration_s * 1e6 / wire::kSamplePeriodUs;
  test.counters = talk.session().counters() - before;
  test.age = percentiles(age);
  test.round_trip = percentiles(round_trip);
  test.confirmed = static_cast<std::size_t>(round_trip.count());
  test.clock_known = talk.session().clock().valid;
  test.clock_uncertainty_us = talk.session().clock().uncertainty_us;
  test.clock_drift_ppm = talk.session().clock().drift * 1e6;
  return test;
}

void listen(RobotTalk& talk, const VisitOptions& options, doctor::Visit& visit) {
  const link::Session& session = talk.session();
  const auto in_state = [&session](SessionState state) { return session.state() == state; };
  talk.turn(kFirstFrameS, [&] { return session.counters().frames_in > 0; });
  const bool answered = session.counters().frames_in > 0;
  if (answered)
    visit.ready = talk.turn(kHandshakeS, [&] {
      return in_state(SessionState::kReady) || in_state(SessionState::kRefused);
    });
  visit.ready = in_state(SessionState::kReady);
  // Foreign bytes never end a frame and may not have been counted as corrupted yet: count them all.
  visit.bytes_in = session.counters().bytes_in;
  visit.frames_in = session.counters().frames_in;
  if (talk.greeted()) add_hello(session.hello(), visit);
  if (talk.refused_parameter() >= 0)
    visit.refused = bridge::parameter_name(static_cast<unsigned>(talk.refused_parameter()));
  if (visit.ready) {
    talk.turn(kLookS, [] { return false; });
    if (options.link_test_s > 0.0) visit.link = test_link(talk, options.link_test_s);
    add_sample(talk.newest(), visit);
    visit.moved_unasked = talk.moved_unasked();
  }
  visit.reboots = session.counters().reboots;
}

}  // namespace

RobotTalk::RobotTalk(link::Port port, const link::SessionSettings& settings,
                     const std::atomic<bool>& stop)
    : port_(std::move(port)), session_(settings), stop_(stop) {
  session_.open(monotonic_now());
}

bool RobotTalk::turn(double limit_s, const std::function<bool()>& enough) {
  const HostNs end = monotonic_now() + from_s(limit_s);
  while (!enough()) {
    if (gone_ || stop_ || monotonic_now() >= end) return false;
    turn_once();
  }
  return true;
}

void RobotTalk::command(double speed_mps, double yaw_rate_radps) {
  speed_mps_ = speed_mps;
  yaw_rate_radps_ = yaw_rate_radps;
}

bool RobotTalk::arm() {
  acknowledged_ = false;
  asked_ = true;
  why_ = "not acknowledged";
  fix_ = "check the cable and run it again";
  session_.request(RobotRequest::kArm, monotonic_now());
  turn(kArmLimitS, [this] { return !session_.request_pending(); });
  return acknowledged_ && !stop_;
}

bool RobotTalk::disarm() {
  command(0.0, 0.0);
  session_.request(RobotRequest::kDisarm, monotonic_now());
  const HostNs end = monotonic_now() + from_s(kDisarmLimitS);
  while (session_.request_pending() && !gone_ && monotonic_now() < end) turn_once();
  asked_ = false;
  return !session_.request_pending() && !gone_;
}

void RobotTalk::turn_once() {
  pollfd descriptor{port_.fd(), POLLIN, 0};
  ::poll(&descriptor, 1, 1);
  const HostNs now = monotonic_now();
  read(now);
  take(now);
  session_.poll(now);
  send(now);
  write();
}

void RobotTalk::read(HostNs now) {
  std::array<std::uint8_t, 4096> buffer;
  const ssize_t n = ::read(port_.fd(), buffer.data(), buffer.size());
  if (n > 0) {
    session_.receive(std::span(buffer.data(), static_cast<std::size_t>(n)), now);
  } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
    gone_ = true;
  }
}

void RobotTalk::take(HostNs now) {
  for (const link::SessionEvent& event : session_.take_events()) note(event);
  for (const Sample& sample : session_.take_samples()) {
    newest_ = sample;
    if (session_.session_number() != session_number_) {
      // Nothing was sent in this session yet; sequence numbers continue from here.
      session_number_ = session_.session_number();
      sequence_ = sample.last_command;
      awaiting_ = false;
    }
    if (awaiting_ && wrapped_difference(sample.last_command, awaited_) >= 0) {
      awaiting_ = false;
      on_confirmed(now - awaited_since_ns_);
    }
    watch(sample, now);
    on_sample(sample, now);
  }
}

void RobotTalk::watch(const Sample& sample, HostNs now) {
  if (asked_ || !motors_on(sample)) {
    on_since_ns_.reset();
    return;
  }
  if (!on_since_ns_) on_since_ns_ = sample.measured_ns;
  if (sample.measured_ns - *on_since_ns_ < kUnaskedNs) return;
  moved_unasked_ = true;
  if (now < next_stop_ns_) return;
  next_stop_ns_ = now + kStopAgainNs;
  session_.request(RobotRequest::kStop, now);
}

void RobotTalk::note(const link::SessionEvent& event) {
  if (link::as<link::HelloReceived>(event) || link::as<link::VersionMismatch>(event))
    greeted_ = true;
  const link::Acknowledged* answer = link::as<link::Acknowledged>(event);
  if (answer == nullptr) return;
  if (answer->request == wire::Type::kParameters) {
    if (answer->result == wire::Result::kOutOfRange) refused_parameter_ = answer->detail;
    return;
  }
  if (answer->request != wire::Type::kArm) return;
  acknowledged_ = answer->result == wire::Result::kAccepted;
  if (acknowledged_) return;
  why_ = "refused";
  if (answer->result == wire::Result::kFaultPersists) {
    if (const auto fault = first_fault(answer->detail)) {
      why_ = describe(*fault).cause;
      fix_ = describe(*fault).fix;
    }
  }
}

void RobotTalk::send(HostNs now) {
  const bool ready =
      session_.state() == SessionState::kReady && session_.session_number() == session_number_;
  if (!ready || now < next_command_ns_) return;
  next_command_ns_ = now + kCommandPeriodNs;
  Command command;
  command.answers = newest_.sequence;
  command.answered_us = newest_.device_us;
  command.speed_mps = speed_mps_;
  command.yaw_rate_radps = yaw_rate_radps_;
  command.expiry_us = session_.clock().to_device(now) + kCommandLifeUs;
  session_.send(command, now);
  ++sequence_;
  if (awaiting_) return;
  awaiting_ = true;
  awaited_ = sequence_;
  awaited_since_ns_ = now;
}

void RobotTalk::write() {
  while (!session_.output().empty()) {
    const ssize_t n = ::write(port_.fd(), session_.output().data(), session_.output().size());
    if (n < 0) {
      if (errno != EAGAIN && errno != EINTR) gone_ = true;
      return;
    }
    session_.written(static_cast<std::size_t>(n));
  }
}

doctor::Visit probe_robot(const VisitOptions& options, const std::atomic<bool>& stop) {
  doctor::Visit visit;
  visit.port = options.port;
  visit.battery_cutoff_v = options.battery_cutoff_v;
  try {
    {
      link::Port port = link::open_port(options.port, options.serial);
      const bool pseudo_terminal = port.pseudo_terminal();
      RobotTalk talk(std::move(port), options.session, stop);
      listen(talk, options, visit);
      visit.emulator = talk.greeted() && is_emulator(pseudo_terminal, talk.session().hello().board);
    }
    if (visit.bytes_in == 0 && !stop)
      visit.bootloader = bootloader_answers(options.port, kBootloaderS);
  } catch (const SetupError& error) {
    if (visit.bytes_in == 0) visit.open_error = error.what();
  }
  return visit;
}

}  // namespace tp100::doctor
