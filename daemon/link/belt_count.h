#pragma once
// One encoder's count: unwrapped to 64 bit, without single jumps that no belt can make.

#include <cstdint>

namespace tp100::link {

class BeltCount {
 public:
  /// This many impossible steps in a row are the truth after all: wrong counts per metre, say.
  static constexpr int kHeldInRow = 10;

  /// Counts a second that a belt may reach; 0: any.
  explicit BeltCount(double max_per_s) : max_per_s_(max_per_s) {}

  /// A new boot: the count begins with the next value.
  void forget() { known_ = false; }
  /// The board's count, `dt_s` after the last one. False: it jumped (glitches on the encoder's
  /// wires), and the belt goes on at the rate that it had, for 0.1 s at most. A jump that comes
  /// again 0.1 s to 1 s after another is believed: who watches the belts is to see it.
  bool update(std::int32_t value, double dt_s);
  std::int64_t counts() const { return counts_; }

 private:
  static constexpr double kForgottenS = 1.0;

  double max_per_s_;
  bool known_ = false;
  std::int32_t last_ = 0;
  std::int64_t counts_ = 0;
  double per_s_ = 0.0;
  int held_in_row_ = 0;
  double since_jump_s_ = kForgottenS;
};

}  // namespace tp100::link
