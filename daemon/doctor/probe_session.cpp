#include "doctor/probe_session.h"

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
#include "core/limits.h"
#include "doctor/hello.h"

namespace tp100::doctor {
namespace {

// A command for each sample, which lives as long as one of a run.
constexpr HostNs kCommandPeriodNs = wire::kSamplePeriodUs * kNsPerUs;
constexpr HostNs kCommandLifeNs = from_s(bridge::Parameters{}.command_life_s);

constexpr double kHandshakeS = 4.0;
constexpr double kBootloaderS = 2.0;
// Enough time to detect a bad sensor or a low battery.
constexpr double kLookS = 0.2;

void listen(ProbeSession& robot, const ProbeOptions& options, doctor::ProbeResult& probe) {
  const link::Session& session = robot.session();
  const auto in_state = [&session](SessionState state) { return session.state() == state; };
  robot.run(kFirstFrameS, [&] { return session.counters().frames_in > 0; });
  const bool answered = session.counters().frames_in > 0;
  if (answered)
    probe.ready = robot.run(kHandshakeS, [&] {
      return in_state(SessionState::kReady) || in_state(SessionState::kRefused);
    });
  probe.ready = in_state(SessionState::kReady);
  // Foreign bytes never end a frame and may not have been counted as corrupted yet: count them all.
  probe.bytes_in = session.counters().bytes_in;
  probe.frames_in = session.counters().frames_in;
  if (robot.identified()) add_hello(session.hello(), probe);
  if (robot.refused_parameter() >= 0)
    probe.refused = bridge::parameter_name(static_cast<unsigned>(robot.refused_parameter()));
  if (probe.ready) {
    robot.run(kLookS, [] { return false; });
    if (options.link_test_s > 0.0) probe.link = robot.test_link(options.link_test_s);
    add_sample(robot.newest(), probe);
    probe.moved_unasked = robot.moved_unasked();
  }
  probe.reboots = session.counters().reboots;
}

}  // namespace

ProbeSession::ProbeSession(link::Port port, const link::SessionSettings& settings,
                           const std::atomic<bool>& stop)
    : port_(std::move(port)), session_(settings), stop_(stop) {
  session_.open(monotonic_now());
}

bool ProbeSession::run(double limit_s, const std::function<bool()>& enough) {
  const HostNs end = monotonic_now() + from_s(limit_s);
  while (!enough()) {
    if (gone_ || stop_ || monotonic_now() >= end) return false;
    cycle_once();
  }
  return true;
}

LinkTest ProbeSession::test_link(double duration_s) {
  meter_.begin(session_.counters(), monotonic_now());
  run(duration_s, [] { return false; });
  return meter_.end(session_.counters(), session_.clock(), monotonic_now());
}

void ProbeSession::command(double speed_mps, double yaw_rate_radps) {
  speed_mps_ = speed_mps;
  yaw_rate_radps_ = yaw_rate_radps;
}

bool ProbeSession::arm() {
  acknowledged_ = false;
  asked_ = true;
  why_ = "not acknowledged";
  fix_ = "check the cable and run it again";
  session_.request(RobotRequest::kArm, monotonic_now());
  run(kOnWithinS, [this] { return !session_.request_pending(); });
  return acknowledged_ && !stop_;
}

bool ProbeSession::disarm() {
  command(0.0, 0.0);
  session_.request(RobotRequest::kDisarm, monotonic_now());
  const HostNs end = monotonic_now() + from_s(kOffWithinS);
  while (session_.request_pending() && !gone_ && monotonic_now() < end) cycle_once();
  asked_ = false;
  return !session_.request_pending() && !gone_;
}

void ProbeSession::cycle_once() {
  pollfd descriptor{port_.fd(), POLLIN, 0};
  ::poll(&descriptor, 1, 1);
  const HostNs now = monotonic_now();
  read(now);
  take(now);
  session_.poll(now);
  send(now);
  write();
}

void ProbeSession::read(HostNs now) {
  std::array<std::uint8_t, 4096> buffer;
  const ssize_t n = ::read(port_.fd(), buffer.data(), buffer.size());
  if (n > 0) {
    session_.receive(std::span(buffer.data(), static_cast<std::size_t>(n)), now);
  } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
    gone_ = true;
  }
}

void ProbeSession::take(HostNs now) {
  for (const link::SessionEvent& event : session_.take_events()) note(event);
  for (const Sample& sample : session_.take_samples()) {
    newest_ = sample;
    if (session_.session_number() != session_number_) {
      session_number_ = session_.session_number();
      meter_.restart({&sample, 1});
    }
    meter_.on_sample(sample, now);
    watch(sample, now);
    on_sample(sample);
  }
}

void ProbeSession::watch(const Sample& sample, HostNs now) {
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

void ProbeSession::note(const link::SessionEvent& event) {
  if (link::as<link::HelloReceived>(event) || link::as<link::VersionMismatch>(event))
    identified_ = true;
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

void ProbeSession::send(HostNs now) {
  const bool ready =
      session_.state() == SessionState::kReady && session_.session_number() == session_number_;
  if (!ready || now < next_command_ns_) return;
  next_command_ns_ = now + kCommandPeriodNs;
  Command command;
  command.answers = newest_.sequence;
  command.answered_us = newest_.device_us;
  command.speed_mps = speed_mps_;
  command.yaw_rate_radps = yaw_rate_radps_;
  command.expiry_us = session_.clock().to_device(now + kCommandLifeNs);
  session_.send(command, now);
  meter_.on_command(now);
}

void ProbeSession::write() {
  while (!session_.output().empty()) {
    const ssize_t n = ::write(port_.fd(), session_.output().data(), session_.output().size());
    if (n < 0) {
      if (errno != EAGAIN && errno != EINTR) gone_ = true;
      return;
    }
    session_.written(static_cast<std::size_t>(n));
  }
}

doctor::ProbeResult probe_robot(const ProbeOptions& options, const std::atomic<bool>& stop) {
  doctor::ProbeResult probe;
  probe.port = options.port;
  probe.battery_cutoff_v = options.battery_cutoff_v;
  try {
    {
      link::Port port = link::open_port(options.port, options.serial);
      const bool pseudo_terminal = port.pseudo_terminal();
      ProbeSession robot(std::move(port), options.session, stop);
      listen(robot, options, probe);
      probe.emulator =
          robot.identified() && is_emulator(pseudo_terminal, robot.session().hello().board);
    }
    if (probe.bytes_in == 0 && !stop)
      probe.bootloader = bootloader_answers(options.port, kBootloaderS);
  } catch (const UserError& error) {
    if (probe.bytes_in == 0) probe.open_error = error.what();
  }
  return probe;
}

}  // namespace tp100::doctor
