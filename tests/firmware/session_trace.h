#pragma once
// Records what a firmware sends and does in a scripted session.

#include <memory>
#include <string>
#include <vector>

#include "rig.h"
#include "support/golden_trace.h"

namespace tp100::firmware {

/// Runs a rig and records what it sends and does.
class SessionTrace {
 public:
  SessionTrace(const std::string& name, int period_ms)
      : driving{"firmware/" + name + "_samples.csv",
                {"ms",           "state",      "faults",      "verdict",      "left_motor",
                 "right_motor",  "samples",    "sequence",    "age_us",       "left_counts",
                 "right_counts", "left_duty",  "right_duty",  "gyro_z",       "accel_x",
                 "battery_mv",   "told_state", "told_faults", "last_command", "imu_age",
                 "oversize",     "cobs",       "undersize",   "crc",          "unknown",
                 "unsent",       "good",       "idles",       "kicks",        "writes",
                 "i2c_calls",    "recoveries"}},
        events{"firmware/" + name + "_events.csv",
               {"ms", "type", "a", "b", "c", "d", "e", "f", "g", "h"}},
        period_ms_(period_ms) {}

  /// Another robot is plugged in.
  Rig& plug(bool boot_now = true) {
    rig_ = std::make_unique<Rig>(boot_now);
    told_ = Told{};
    return *rig_;
  }
  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      rig_->run(1);
      ++ms_;
      write_events();
      if (ms_ % period_ms_ == 0) write_samples();
    }
  }
  void hang(int ms) {
    rig_->hang(ms);
    ms_ += ms;
  }

  test::GoldenTrace driving;
  test::GoldenTrace events;

 private:
  struct Told {
    std::size_t samples = 0;
    std::size_t hellos = 0;
    std::size_t acknowledges = 0;
    std::size_t sync_replies = 0;
    std::size_t reports = 0;
    std::size_t logs = 0;
  };

  double ago_us(std::uint32_t us) const { return static_cast<std::int32_t>(rig_->hal.now_us - us); }
  void event(wire::Type type, std::vector<double> values) {
    values.resize(8);
    values.insert(values.begin(), {1.0 * ms_, 1.0 * static_cast<int>(type)});
    events.row(values);
  }
  void write_events() {
    Rig& r = *rig_;
    for (; told_.hellos < r.hellos.size(); ++told_.hellos) {
      const wire::Hello& m = r.hellos[told_.hellos];
      event(m.kType, {1.0 * m.protocol, m.firmware[0] * 1e4 + m.firmware[1] * 1e2 + m.firmware[2],
                      m.schema == wire::kSchemaHash ? 1.0 : 0.0, 1.0 * m.board, 1.0 * m.boot_nonce,
                      1.0 * m.reset_cause, 1.0 * m.state, 1.0 * m.faults});
    }
    for (; told_.acknowledges < r.acknowledges.size(); ++told_.acknowledges) {
      const wire::Acknowledge& m = r.acknowledges[told_.acknowledges];
      event(m.kType, {1.0 * m.request, 1.0 * m.token, 1.0 * m.result, 1.0 * m.detail});
    }
    for (; told_.sync_replies < r.sync_replies.size(); ++told_.sync_replies) {
      const wire::SyncReply& m = r.sync_replies[told_.sync_replies];
      event(m.kType, {1.0 * m.id, ago_us(m.received_us), ago_us(m.sent_us), 1.0 * m.corrupted,
                      1.0 * m.missed_edges});
    }
    for (; told_.reports < r.reports.size(); ++told_.reports) {
      const wire::FaultReport& m = r.reports[told_.reports];
      event(m.kType, {ago_us(m.device_us), 1.0 * m.fault, 1.0 * m.faults, 1.0 * m.detail});
    }
    for (; told_.logs < r.log_messages.size(); ++told_.logs) {
      const wire::Log& m = r.log_messages[told_.logs];
      int text = 0;
      for (const std::uint8_t byte : m.text) text = (text * 31 + byte) % 1'000'003;
      event(m.kType, {ago_us(m.device_us), 1.0 * m.level, 1.0 * text});
    }
  }
  // Sums over the samples since the last row, so that none is missing.
  void write_samples() {
    const Rig& r = *rig_;
    wire::Sample last{};
    double left_duty = 0.0, right_duty = 0.0, gyro_z = 0.0, accel_x = 0.0, left_counts = 0.0,
           right_counts = 0.0, age_us = 0.0;
    int states = 0, faults = 0, commands = 0, imu_ages = 0;
    const std::size_t before = told_.samples;
    for (; told_.samples < r.samples.size(); ++told_.samples) {
      last = r.samples[told_.samples];
      left_duty += last.left_duty;
      right_duty += last.right_duty;
      gyro_z += last.gyro[2];
      accel_x += last.accel[0];
      left_counts += last.left_counts;
      right_counts += last.right_counts;
      age_us += ago_us(last.device_us);
      states += last.state;
      faults += last.faults;
      commands += last.last_command;
      imu_ages += last.imu_age;
    }
    const LinkCounts& link = r.program.link_counts();
    driving.row({1.0 * ms_,
                 1.0 * static_cast<int>(r.program.state()),
                 1.0 * r.program.faults(),
                 1.0 * static_cast<int>(r.program.last_verdict()),
                 1.0 * r.hal.duties.left,
                 1.0 * r.hal.duties.right,
                 static_cast<double>(told_.samples - before),
                 1.0 * last.sequence,
                 age_us,
                 left_counts,
                 right_counts,
                 left_duty,
                 right_duty,
                 gyro_z,
                 accel_x,
                 1.0 * last.battery_mv,
                 1.0 * states,
                 1.0 * faults,
                 1.0 * commands,
                 1.0 * imu_ages,
                 1.0 * link.oversize,
                 1.0 * link.cobs,
                 1.0 * link.undersize,
                 1.0 * link.crc,
                 1.0 * link.unknown,
                 1.0 * link.unsent,
                 1.0 * link.good,
                 1.0 * r.hal.idles,
                 1.0 * r.hal.kicks,
                 1.0 * r.hal.nonzero_writes,
                 1.0 * r.hal.i2c_calls,
                 1.0 * r.hal.recoveries});
  }

  std::unique_ptr<Rig> rig_;
  Told told_;
  int period_ms_;
  int ms_ = 0;
};

}  // namespace tp100::firmware
