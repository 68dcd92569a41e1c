#pragma once
// The last motions with the state after each, so that a late measurement can be put where it
// belongs.

#include <algorithm>
#include <array>
#include <cstddef>

#include "estimation/motion.h"

namespace tp100::estimation {

/// A motion and the state at its end.
struct Step {
  Motion motion{};
  FilterState after{};
};

/// Ring of fixed size, oldest first. Full, it forgets the oldest. No allocation.
class RewindBuffer {
 public:
  /// 0.8 s of samples at 200 Hz.
  static constexpr std::size_t kCapacity = 160;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  Step& operator[](std::size_t index) { return steps_[(first_ + index) % kCapacity]; }
  const Step& operator[](std::size_t index) const { return steps_[(first_ + index) % kCapacity]; }
  Step& back() { return (*this)[size_ - 1]; }
  const Step& back() const { return (*this)[size_ - 1]; }

  void push(const Step& step) {
    if (size_ == kCapacity) {
      first_ = (first_ + 1) % kCapacity;
      --size_;
    }
    ++size_;
    back() = step;
  }
  /// Puts `step` before the one at `index`, which must not be 0. Returns its index; that is one
  /// less if the buffer was full.
  std::size_t insert(std::size_t index, const Step& step) {
    if (size_ == kCapacity) --index;
    push(Step{});
    for (std::size_t i = size_ - 1; i > index; --i) (*this)[i] = (*this)[i - 1];
    (*this)[index] = step;
    return index;
  }
  /// Index of the first step that ends at or after `at_ns`; size() if there is none.
  std::size_t find(HostNs at_ns) const {
    std::size_t index = size_;
    while (index > 0 && (*this)[index - 1].motion.end_ns >= at_ns) --index;
    return index;
  }

 private:
  std::array<Step, kCapacity> steps_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace tp100::estimation
