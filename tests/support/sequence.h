#pragma once
// Numbers that look random, for tests whose inputs must be the same with every compiler.

#include <cstdint>

namespace tp100::test {

class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed) {}

  double between(double low, double high) { return low + (high - low) * next(); }
  int below(int bound) { return static_cast<int>(next() * bound); }
  bool chance(double share) { return next() < share; }

 private:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

  std::uint64_t state_;
};

}  // namespace tp100::test
