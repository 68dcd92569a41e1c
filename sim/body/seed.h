#pragma once
// Pseudo-random numbers that follow from a seed: the source of all random values of the emulator.

#include <cstdint>

namespace tp100::sim {

inline constexpr std::uint64_t kSeedStep = 0x9E3779B97F4A7C15U;

/// SplitMix64 (Steele, Lea, Flood 2014): one step.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += kSeedStep;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

/// The `number`th of the numbers that follow from `seed`.
constexpr std::uint64_t numbered(std::uint64_t seed, std::uint64_t number) {
  return mix(seed + number * kSeedStep);
}

}  // namespace tp100::sim
