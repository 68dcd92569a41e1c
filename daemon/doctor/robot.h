#pragma once
// The robot's reported state and the quality of its link.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/faults.h"
#include "core/histogram.h"
#include "core/link_state.h"
#include "core/sample.h"
#include "doctor/finding.h"
#include "wire/messages.h"

namespace tp100::doctor {

/// A distribution of times.
struct Percentiles {
  double p50_us = 0.0;
  double p90_us = 0.0;
  double p99_us = 0.0;
  double max_us = 0.0;
};

/// Statistics over an interval of samples and of zero commands.
struct LinkTest {
  double duration_s = 0.0;
  std::size_t samples = 0;
  double expected_samples = 0.0;  ///< at the robot's rate
  LinkCounters counters{};        ///< of that interval only
  Percentiles age{};              ///< from measuring to reading a sample
  /// From writing a command to reading the first sample that confirms it; includes up to one sample
  /// period of the robot.
  Percentiles round_trip{};
  std::size_t confirmed = 0;  ///< commands
  bool clock_known = false;   ///< at its end
  double clock_uncertainty_us = 0.0;
  double clock_drift_ppm = 0.0;
};

/// Measures the link of a robot to which commands stream: the robot confirms the sequence of the
/// last one. One thread.
class LinkMeter {
 public:
  /// Sequence numbers of commands continue from those of `samples`, the first of a session.
  void restart(std::span<const Sample> samples);
  void on_sample(const Sample& sample, HostNs now);
  void on_command(HostNs now);
  /// So many commands were sent at unknown times.
  void skip(std::uint64_t commands) { sent_ = static_cast<std::uint16_t>(sent_ + commands); }

  /// A measurement begins, in place of an earlier one.
  void begin(const LinkCounters& counters, HostNs now);
  LinkTest end(const LinkCounters& counters, const ClockState& clock, HostNs now) const;

 private:
  std::uint16_t sent_ = 0;
  std::optional<std::uint16_t> awaited_{};
  HostNs awaited_since_ns_ = 0;
  HostNs begun_ns_ = 0;
  LinkCounters before_{};
  std::size_t samples_ = 0;
  std::optional<Histogram> age_{}, round_trip_{};  ///< none before begin()
};

/// How long a probe waits for a first frame, and how long it tests the link.
inline constexpr double kFirstFrameS = 5.0, kLinkTestS = 1.0;

/// Result of a probe: how far the handshake got, and the robot's state.
struct ProbeResult {
  std::string port{};
  std::string open_error{};   ///< why the port could not be opened; empty: it could
  std::size_t bytes_in = 0;   ///< received from the port
  std::size_t frames_in = 0;  ///< valid frames of this protocol among them
  bool bootloader = false;    ///< the bootloader of a silent board answered
  std::string hello{};        ///< text of the hello; empty: none
  bool ours = false;          ///< firmware for this program
  bool emulator = false;      ///< is_emulator() of core/board.h
  std::string refused{};      ///< the parameter that the firmware refused; empty: none
  bool ready = false;         ///< samples arrived and the clocks are synchronized
  std::uint64_t reboots = 0;
  FaultMask faults = 0;           ///< latched by the robot
  bool moved_unasked = false;     ///< armed or driving without a request
  double battery_v = 0.0;         ///< of the whole battery
  double battery_cutoff_v = 0.0;  ///< the robot stops below this voltage; 0: never
  bool imu_fresh = false;
  double up_mps2 = 0.0;  ///< specific force along the IMU's z axis, at standstill
  std::optional<LinkTest> link{};
};

// Parts of a probe, of the newest hello and of the newest sample.
void add_hello(const wire::Hello& hello, ProbeResult& probe);
void add_sample(const Sample& sample, ProbeResult& probe);

/// Names: firmware, start, bootloader, parameters, session, reboots, motors, fault, battery, imu,
/// link, clock; open for a port that cannot be opened.
Findings robot_findings(const ProbeResult& probe);

}  // namespace tp100::doctor
