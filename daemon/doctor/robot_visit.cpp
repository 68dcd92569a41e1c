#include "doctor/robot_visit.h"

#include <array>
#include <utility>

#include "bridge/cycle.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/start_rule.h"
#include "doctor/bootloader.h"
#include "doctor/hello.h"
#include "doctor/robot_talk.h"
#include "loop/histogram.h"

namespace tp100::doctor {
namespace {

constexpr double kFirstFrameS = 5.0;
constexpr double kHandshakeS = 4.0;
constexpr double kBootloaderS = 2.0;
// Time for a sensor or a cell that is bad to be noticed.
constexpr double kLookS = 0.2;
constexpr std::uint8_t kFreshSamples = 10;

doctor::Percentiles percentiles(const loop::Histogram& times) {
  const auto us = [&times](double fraction) {
    return static_cast<double>(times.percentile(fraction)) * 1e-3;
  };
  return {us(0.5), us(0.9), us(0.99), static_cast<double>(times.max()) * 1e-3};
}

doctor::LinkTest test_link(RobotTalk& talk, double duration_s) {
  loop::Histogram age;
  loop::Histogram round_trip;
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

void read_hello(wire::Hello hello, doctor::Visit& visit) {
  std::array<std::uint8_t, wire::Hello::kSize> payload{};
  wire::write_payload(hello, payload.data());
  const Greeting greeting = read_greeting(payload.data(), payload.size());
  visit.greeting = greeting.text;
  visit.ours = greeting.ours;
}

void listen(RobotTalk& talk, const VisitOptions& options, doctor::Visit& visit) {
  const link::Session& session = talk.session();
  const auto in_state = [&session](SessionState state) { return session.state() == state; };
  talk.turn(kFirstFrameS, [&] { return session.counters().frames_in > 0; });
  const bool spoke = session.counters().frames_in > 0;
  if (spoke)
    visit.ready = talk.turn(kHandshakeS, [&] {
      return in_state(SessionState::kReady) || in_state(SessionState::kRefused);
    });
  visit.ready = in_state(SessionState::kReady);
  // Foreign bytes end no frame and may not have been counted out yet: all of them count here.
  visit.bytes_in = session.counters().bytes_in;
  visit.frames_in = session.counters().frames_in;
  if (talk.greeted()) read_hello(session.hello(), visit);
  if (talk.refused_parameter() >= 0)
    visit.refused = bridge::parameter_name(static_cast<unsigned>(talk.refused_parameter()));
  if (visit.ready) {
    talk.turn(kLookS, [] { return false; });
    if (options.link_test_s > 0.0) visit.link = test_link(talk, options.link_test_s);
    const Sample& newest = talk.newest();
    visit.faults = newest.faults;
    visit.battery_v = newest.battery_v;
    visit.moved_unasked = talk.moved_unasked();
    visit.imu_fresh = newest.imu_age < kFreshSamples;
    visit.up_mps2 = newest.accel_mps2[2];
  }
  visit.reboots = session.counters().reboots;
}

}  // namespace

doctor::Visit visit_robot(const VisitOptions& options, const std::atomic<bool>& stop) {
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
