#pragma once
// Converts sample frames to samples: units, unwrapped time and counts, host time, and a check of
// order and plausibility. Fixed size, no allocation.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/link_state.h"
#include "core/sample.h"
#include "shared/monitors.h"
#include "wire/messages.h"

namespace tp100::link {

/// One encoder's count: unwrapped to 64 bit, without single jumps that are impossible for a track.
class EncoderCount {
 public:
  /// After this many impossible steps in a row the counts are accepted: for example, the counts per
  /// metre may be wrong.
  static constexpr int kHeldInRow = 10;

  /// Greatest counts per second of a track; 0: unlimited.
  explicit EncoderCount(double max_per_s) : max_per_s_(max_per_s) {}

  void set_limit(double max_per_s) { max_per_s_ = max_per_s; }
  /// A new boot: the count begins with the next value.
  void forget() { known_ = false; }
  /// Takes the board's count, `elapsed_us` after the last one. False: it jumped (a glitch on the
  /// encoder's wires), and the track is taken to continue at its last rate, for 0.1 s at most. A
  /// repeated jump, see shared::JumpMemory, is accepted, so that the track monitors see it.
  bool update(std::int32_t value, DeviceUs elapsed_us);
  std::int64_t counts() const { return counts_; }

 private:
  double max_per_s_;
  bool known_ = false;
  std::int32_t last_ = 0;
  std::int64_t counts_ = 0;
  double per_s_ = 0.0;
  int held_in_row_ = 0;
  shared::JumpMemory<std::uint32_t, 1000> jumps_{};  ///< in microseconds
};

class SampleIntake {
 public:
  static constexpr std::size_t kCapacity = 64;  ///< kept between two takes
  /// After this many refused samples in a row the stream is invalid: a new session is needed.
  static constexpr int kNonsense = 40;

  /// `counters` must outlive the intake. `max_counts_per_s`: limit of a track; 0: none.
  SampleIntake(LinkCounters& counters, double max_counts_per_s)
      : counters_(counters), left_(max_counts_per_s), right_(max_counts_per_s) {}

  /// Another limit of a track, of a robot with other values.
  void set_limit(double max_counts_per_s) {
    left_.set_limit(max_counts_per_s);
    right_.set_limit(max_counts_per_s);
  }
  /// A new session: the next sample is the first one. Counts continue unless the boot is new.
  void begin(bool new_boot);
  /// Takes one sample with its extended device time. False if it is out of order or not plausible.
  /// It is kept only if `clock` is valid.
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
  EncoderCount left_, right_;
  int refused_in_row_ = 0;
};

}  // namespace tp100::link
