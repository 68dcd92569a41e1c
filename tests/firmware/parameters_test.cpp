// Tests the ranges of the parameters: a robot must not be driven with others.

#include "firmware/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "../support/wire_host.h"
#include "scripted_hal.h"

namespace tp100::firmware {
namespace {

// The next number up or down, for the bounds of a field.
template <class T>
T beside(T value, int step) {
  if constexpr (std::is_integral_v<T>)
    return static_cast<T>(value + step);
  else
    return std::nextafter(value, step > 0 ? 1e30f : -1e30f);
}

TEST(Parameters, OneOutsideItsRangeIsNamed) {
  using P = wire::Parameters;
  const auto answer = [](auto field, auto value) {
    P parameters = test::good_parameters();
    parameters.*field = value;
    return int{bad_field(parameters)};
  };
  const auto check = [&](int index, auto field, auto low, auto high) {
    SCOPED_TRACE(index);
    EXPECT_EQ(answer(field, low), 0);
    EXPECT_EQ(answer(field, high), 0);
    EXPECT_EQ(answer(field, beside(high, 1)), index);
    EXPECT_EQ(answer(field, beside(low, -1)), index);
  };
  struct Range {
    float P::*field;
    float low, high;
  };
  const Range ranges[] = {
      {&P::counts_per_metre, 100.0f, 1e6f}, {&P::wheelbase_m, 0.05f, 2.0f},
      {&P::wheelbase_tight_m, 0.05f, 2.0f}, {&P::wheelbase_spin_m, 0.05f, 2.0f},
      {&P::turn_slip_share, 0.0f, 1.0f},    {&P::slip_left, -0.5f, 0.9f},
      {&P::slip_right, -0.5f, 0.9f},        {&P::max_track_mps, 0.01f, 2.0f},
      {&P::max_track_mps2, 0.05f, 20.0f},   {&P::feed_forward, 0.0f, 100.0f},
      {&P::dead_band, 0.0f, 0.9f},          {&P::speed_kp, 0.0f, 100.0f},
      {&P::speed_ki, 0.0f, 1000.0f},        {&P::yaw_kp, 0.0f, 50.0f},
      {&P::max_yaw_radps, 0.05f, 10.0f},    {&P::gyro_z_radps_per_lsb, 1e-5f, 1e-2f}};
  int index = 2;
  for (const auto& [field, low, high] : ranges) {
    check(index, field, low, high);
    for (const float bad : {kNan, kInf, -kInf}) EXPECT_EQ(answer(field, bad), index) << bad;
    ++index;
  }
  EXPECT_EQ(answer(&P::gyro_z_radps_per_lsb, -1e-2f), 0) << "the sensor may be upside down";
  EXPECT_EQ(answer(&P::gyro_z_radps_per_lsb, -0.1f), 17);
  using U16 = std::uint16_t;
  EXPECT_EQ(answer(&P::battery_cutoff_mv, U16{65535}), 0);
  check(19, &P::stall_duty, U16{0}, U16{1000});
  check(20, &P::stall_ms, U16{50}, U16{10'000});
  check(21, &P::command_life_ms, U16{20}, U16{200});
  check(22, &P::yaw_window_ms, U16{20}, U16{200});
  check(23, &P::flags, std::uint8_t{0}, std::uint8_t{0x3F});
}

}  // namespace
}  // namespace tp100::firmware
