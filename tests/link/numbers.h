#pragma once
// Inputs of the scripted runs that golden traces of the link record.

#include <cstddef>
#include <cstdint>

namespace tp100::link {

/// Numbers that look random, the same with every compiler.
class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed) {}

  std::uint32_t below(std::size_t limit) {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<std::uint32_t>((state_ >> 10U) % limit);
  }

 private:
  std::uint32_t state_;
};

}  // namespace tp100::link
