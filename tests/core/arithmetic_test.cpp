#include "core/arithmetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>

#include "core/pose.h"
#include "core/processor.h"
#include "support/sequence.h"

namespace tp100 {
namespace {

TEST(Arithmetic, NamesProcessorLibraryAndFma) {
  EXPECT_THAT(arithmetic(),
              testing::MatchesRegex("(x86_64|aarch64), glibc 2\\.[0-9]+ with(out)? FMA"));
}

TEST(Magnitude, IsNotFused) {
  // The square has a last bit that a fused sum keeps.
  constexpr double kX = 1.0 + 0x1p-30, kY = 0x1p-27;
  const double squares = kX * kX;
  EXPECT_EQ(magnitude(kX, kY), std::sqrt(squares + kY * kY));
}

TEST(Transform2d, TakesOnePoseToTheOtherAndAllThatMoveWithIt) {
  const Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = 0.5};
  const Pose to{.x_m = -0.3, .y_m = 0.4, .yaw_rad = 0.5 + kPi / 2 + 2 * kPi};
  const Transform2d transform = Transform2d::between(from, to);
  const Pose there = transform.of(from);
  EXPECT_NEAR(there.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(there.y_m, to.y_m, 1e-12);
  EXPECT_NEAR(transform.turn_rad, kPi / 2, 1e-12) << "the branch of the robot's own yaw stays";
  const Pose ahead = transform.of({.x_m = 1.1, .y_m = 2.0, .yaw_rad = 0.5});
  EXPECT_NEAR(ahead.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(ahead.y_m, to.y_m + 0.1, 1e-12);
}

/// A hash of the last bits of `function` at 20 000 arguments.
template <class Function>
std::uint64_t last_bits(Function function) {
  std::uint64_t hash = 14695981039346656037u;
  test::Sequence places(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = places.between(-1.0, 1.0), y = places.between(-1.0, 1.0);
    hash = (hash ^ std::bit_cast<std::uint64_t>(function(x, y))) * 1099511628211u;
  }
  return hash;
}

// glibc's functions with FMA give the same bits on both kinds of processor, which are pinned here.
// Those without FMA give other bits.
TEST(Arithmetic, TheTextSaysWhatBitsTheFunctionsGive) {
  volatile double one = 1.0;  // the compiler rounds by rules of its own
  const auto bits = last_bits([&](double x, double y) {
    x *= one;
    return std::sin(9.0 * x) + std::cos(9.0 * y) + std::tan(x) + std::asin(x) + std::acos(y) +
           std::atan(9.0 * x) + std::atan2(x, y) + std::exp(x) + std::log(2.0 + y) +
           std::pow(2.0 + x, y) + std::fmod(9.0 * x, y);
  });
  if (arithmetic().find("glibc 2.36 with FMA") == std::string::npos) {
    if (arithmetic().find("glibc 2.36 ") == std::string::npos)
      GTEST_SKIP() << arithmetic() << ": the bits are those of glibc 2.36";
    EXPECT_NE(bits, 5244883692887111494u);
  } else {
    EXPECT_EQ(bits, 5244883692887111494u);
  }
}

}  // namespace
}  // namespace tp100
