#include "doctor/robot.h"

#include "core/arithmetic.h"
#include "core/faults.h"
#include "core/limits.h"
#include "doctor/hello.h"
#include "shared/number.h"
#include "text/format.h"

namespace tp100::doctor {
namespace {

using text::format;

constexpr double kFewSamples = 0.5;  // fraction of the expected samples
// A command lives 200 ms, and the step treats samples as stale long before that.
constexpr double kOldUs = 20'000.0;
constexpr double kLooseClockUs = 2'000.0;
// Vertical part of gravity for a board within 60 degrees of level.
constexpr double kUprightMps2 = 0.5 * kStandardGravityMps2;

std::string text_of(const Percentiles& times) {
  return format("%.2f/%.2f/%.2f/%.2f ms", times.p50_us * 1e-3, times.p90_us * 1e-3,
                times.p99_us * 1e-3, times.max_us * 1e-3);
}

/// Explains the missing hello.
Finding silent(const ProbeResult& probe) {
  const std::string flash = flash_command(probe.port);
  if (probe.bootloader)
    return error("bootloader", probe.port + ": only the bootloader answers", flash);
  if (probe.frames_in > 0)
    return error("firmware", probe.port + ": sends frames of the protocol but no hello",
                 "press the board's reset button; if that does not help: " + flash);
  if (probe.bytes_in > 0)
    return error("firmware",
                 probe.port + format(": %zu bytes, but no frame of a TP100", probe.bytes_in),
                 "if this is the robot: " + flash + "; else choose its port with --port");
  return error("firmware", probe.port + ": silent",
               "press the board's reset button and see whether its light blinks; if this is the "
               "robot: " +
                   flash + "; else choose its port with --port");
}

/// A latched fault is only a warning, as the next start clears it, unless its cause refuses an arm.
void add_fault(Fault fault, Findings& findings) {
  const FaultText& words = describe(fault);
  const std::string seen = std::string(words.name) + ": " + std::string(words.cause);
  switch (fault) {
    case Fault::command_timeout:
    case Fault::parameters_missing:
    case Fault::battery_low:  // see add_battery
      return;
    case Fault::imu_missing:
    case Fault::imu_stale:
      findings.push_back(error("fault", seen, std::string(words.fix)));
      return;
    default:
      findings.push_back(warning("fault", seen, std::string(words.fix)));
  }
}

void add_battery(const ProbeResult& probe, Findings& findings) {
  if (probe.battery_v >= probe.battery_cutoff_v) {
    findings.push_back(ok("battery", format("%.1f V", probe.battery_v)));
    return;
  }
  findings.push_back(error(
      "battery",
      format("%.1f V, the robot stops below %.1f V", probe.battery_v, probe.battery_cutoff_v),
      probe.battery_v < kBatteryOffV ? "switch the motors' battery on" : "charge the battery"));
}

void add_state(const ProbeResult& probe, Findings& findings) {
  if (probe.reboots > 0)
    findings.push_back(error(
        "reboots",
        "the board restarted " + text::counted(probe.reboots, "time") + " while it was watched",
        "charge the battery and check the power wiring"));
  if (probe.moved_unasked) {
    const FaultText& words = describe(Fault::moves_unasked);
    findings.push_back(error("motors", std::string(words.cause), std::string(words.fix)));
  }
  for (FaultMask left = probe.faults; left != 0; left &= left - 1)
    add_fault(*first_fault(left), findings);
  if (!probe.ready) return;
  add_battery(probe, findings);
  if (!probe.imu_fresh) return;
  if (probe.up_mps2 < kUprightMps2) {
    findings.push_back(
        error("imu",
              format("at rest its z axis shows %.1f m/s^2, upright would be %.1f", probe.up_mps2,
                     kStandardGravityMps2),
              "set the robot upright; if it is: mount the MPU6050 level, chip side up, x forward"));
  } else {
    findings.push_back(ok("imu", format("upright, z %.1f m/s^2", probe.up_mps2)));
  }
}

void add_link(const LinkTest& link, Findings& findings) {
  const std::string figures = text::counted(link.samples, "sample") +
                              format(" in %.1f s, %llu lost, ", link.duration_s,
                                     static_cast<unsigned long long>(link.counters.lost)) +
                              text::counted(link.counters.corrupted(), "frame") + " corrupted";
  const std::string times =
      "; p50/p90/p99/max of age " + text_of(link.age) + ", round trip " + text_of(link.round_trip);
  const char* const cable = "use a short cable without a hub, away from the motors' leads";
  if (static_cast<double>(link.samples) < kFewSamples * link.expected_samples) {
    findings.push_back(
        error("link", figures + format(", %.0f were due", link.expected_samples), cable));
  } else if (link.confirmed == 0) {
    findings.push_back(error("link", figures + ", and the robot confirmed no command", cable));
  } else if (link.counters.lost > 0 || link.counters.corrupted() > 0) {
    findings.push_back(warning("link", figures + times, cable));
  } else if (link.age.p99_us > kOldUs || link.round_trip.p99_us > 2.0 * kOldUs) {
    findings.push_back(
        warning("link", figures + times,
                "plug the robot in without a hub and close programs that load this machine"));
  } else {
    findings.push_back(ok("link", figures + times));
  }
  if (!link.clock_known) return;
  const std::string clock = format("known within %.0f us, drift %.0f ppm",
                                   link.clock_uncertainty_us, link.clock_drift_ppm);
  if (link.clock_uncertainty_us > kLooseClockUs) {
    findings.push_back(
        warning("clock", "the robot's clock is only " + clock,
                "plug the robot in without a hub and close programs that load this machine"));
  } else {
    findings.push_back(ok("clock", "the robot's clock is " + clock));
  }
}

Percentiles percentiles(const Histogram& times) {
  return {times.percentile_us(0.5), times.percentile_us(0.9), times.percentile_us(0.99),
          times.max_us()};
}

}  // namespace

void LinkMeter::restart(std::span<const Sample> samples) {
  awaited_.reset();
  for (const Sample& sample : samples) sent_ = sample.last_command;
}

void LinkMeter::on_sample(const Sample& sample, HostNs now) {
  ++samples_;
  if (age_) age_->add(now - sample.measured_ns);
  if (!awaited_ || shared::wrapped_difference(sample.last_command, *awaited_) < 0) return;
  if (round_trip_) round_trip_->add(now - awaited_since_ns_);
  awaited_.reset();
}

void LinkMeter::on_command(HostNs now) {
  ++sent_;
  if (awaited_) return;
  awaited_ = sent_;
  awaited_since_ns_ = now;
}

void LinkMeter::begin(const LinkCounters& counters, HostNs now) {
  before_ = counters;
  begun_ns_ = now;
  samples_ = 0;
  age_.emplace();
  round_trip_.emplace();
}

LinkTest LinkMeter::end(const LinkCounters& counters, const ClockState& clock, HostNs now) const {
  LinkTest test;
  test.duration_s = to_s(now - begun_ns_);
  test.samples = samples_;
  test.expected_samples = test.duration_s * 1e6 / wire::kSamplePeriodUs;
  test.counters = counters - before_;
  test.age = percentiles(*age_);
  test.round_trip = percentiles(*round_trip_);
  test.confirmed = static_cast<std::size_t>(round_trip_->count());
  test.clock_known = clock.valid;
  test.clock_uncertainty_us = clock.uncertainty_us;
  test.clock_drift_ppm = clock.drift * 1e6;
  return test;
}

void add_hello(const wire::Hello& hello, ProbeResult& probe) {
  const HelloReply reply = reply_of(hello);
  probe.hello = reply.text;
  probe.ours = reply.ours;
}

void add_sample(const Sample& sample, ProbeResult& probe) {
  probe.faults = sample.faults;
  probe.battery_v = sample.battery_v;
  probe.imu_fresh = sample.imu_age < kRobotStaleImu;
  probe.up_mps2 = sample.accel_mps2[2];
}

Findings robot_findings(const ProbeResult& probe) {
  if (!probe.open_error.empty()) {
    const std::size_t end = probe.open_error.rfind("; ");
    return {
        error("open", probe.open_error.substr(0, end),
              end == std::string::npos ? "see tp100d ports" : probe.open_error.substr(end + 2))};
  }
  if (probe.hello.empty()) return {silent(probe)};
  if (!probe.ours)
    return {error("firmware", probe.hello.substr(0, probe.hello.rfind("; ")),
                  flash_command(probe.port))};
  Findings findings = {ok("firmware", probe.hello),
                       ok("start", probe.emulator ? "an emulated robot: a run starts by itself"
                                                  : "a run waits for Enter at the terminal, or for "
                                                    "start on the page")};
  if (!probe.refused.empty()) {
    findings.push_back(error("parameters", "the firmware refuses " + probe.refused,
                             "correct that key of the robot file (tp100d check FILE)"));
    return findings;
  }
  if (!probe.ready && probe.reboots == 0)
    findings.push_back(error(
        "session", "the robot sends hello, but its clock could not be read",
        "use a short cable without a hub; if that does not help: " + flash_command(probe.port)));
  add_state(probe, findings);
  if (probe.link) add_link(*probe.link, findings);
  return findings;
}

}  // namespace tp100::doctor
