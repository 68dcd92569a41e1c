#pragma once
// Sample frames → samples: units, unwrapped time and counts, host time, and a check of order and
// plausibility. Fixed size, no allocation.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/link_state.h"
#include "core/sample.h"
#include "link/belt_count.h"
#include "wire/messages.h"

namespace tp100::link {

/// Device time extended to 64 bit within one boot, across sessions.
class DeviceClock {
 public:
  /// A new boot: no relation to earlier times.
  void forget() { known_ = false; }
  /// The extended time of a value read at host time `now`.
  DeviceUs extend(std::uint32_t device_us, HostNs now);

 private:
  DeviceUs newest_us_ = 0;
  HostNs newest_ns_ = 0;
  bool known_ = false;
};

class SampleIntake {
 public:
  static constexpr std::size_t kCapacity = 64;  ///< kept between two takes
  /// This many refused samples in a row: the stream makes no sense, ask for a new session.
  static constexpr int kNonsense = 40;

  /// `counters` must outlive the intake. `max_counts_per_s`: a belt's limit, 0: none.
  SampleIntake(LinkCounters& counters, double max_counts_per_s)
      : counters_(counters), left_(max_counts_per_s), right_(max_counts_per_s) {}

  /// A new session: the next sample is the first one. Counts continue unless it is a new boot.
  void begin(bool new_boot);
  /// Takes one sample with its extended device time, unless it is out of order or not plausible:
  /// false. Kept only if `clock` is valid.
  bool push(const wire::Sample& wire, DeviceUs device_us, const ClockState& clock, HostNs now);
  /// Samples since the last take, oldest first; valid until the next push.
  std::span<const Sample> take();
  bool empty() const { return count_ == 0; }
  bool nonsense() const { return refused_in_row_ >= kNonsense; }

 private:
  void count(const wire::Sample& wire, DeviceUs device_us);
  bool in_order(std::uint16_t sequence, DeviceUs device_us, std::uint32_t& missing);
  void keep(const Sample& sample);

  LinkCounters& counters_;
  std::array<Sample, kCapacity> samples_{};
  std::size_t count_ = 0;
  std::uint32_t dropped_ = 0;  // since the last kept sample

  bool started_ = false;
  std::uint16_t last_sequence_ = 0;
  std::uint64_t seen_ = 0;  // bit i: sequence last - i was taken
  DeviceUs last_device_us_ = 0;
  BeltCount left_, right_;
  int refused_in_row_ = 0;
};

}  // namespace tp100::link
