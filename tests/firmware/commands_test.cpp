// Which commands move a robot, and with which parameters it may be driven.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "../support/wire_host.h"
#include "firmware/parameters.h"
#include "rig.h"
#include "scripted_hal.h"

namespace tp100::firmware {
namespace {

using wire::State;

constexpr std::uint32_t kBoot = 77;
constexpr std::uint32_t kNowUs = 0xFFFFFFFFU - 50'000U;  // the clock wraps during some tests

// A gate that has accepted the command 100, and samples every 5 ms up to number 60, now.
class Gate : public testing::Test {
 protected:
  Gate() {
    p.command_life_ms = 110;
    p.yaw_window_ms = 90;
    for (std::uint16_t i = 0; i <= 60; ++i) history.add(i, kNowUs - (60U - i) * 5000U, 0, 0, 0);
    gate.open(kBoot);
    EXPECT_EQ(judge(command()), Verdict::kAccepted);
    next.sequence = 101;
  }
  static wire::Command command() {
    wire::Command c{};
    c.boot_nonce = kBoot;
    c.sequence = 100;
    c.answers = 60;
    c.speed_mps = 0.1f;
    c.expiry_us = kNowUs + 100'000U;
    return c;
  }
  Verdict judge(const wire::Command& c) { return gate.judge(c, kNowUs, history, p); }

  wire::Parameters p = test::good_parameters();
  TurnHistory history;
  CommandGate gate;
  wire::Command next = command();
};

TEST_F(Gate, IsOpenToCommandsOfThisBoot) {
  EXPECT_EQ(judge(next), Verdict::kAccepted);
  ++next.boot_nonce;
  EXPECT_EQ(judge(next), Verdict::kWrongBoot);
}

TEST_F(Gate, IsOpenToANewerSequenceUpToHalfItsRange) {
  for (const int ahead : {0, -1, -500, -32'768}) {
    next.sequence = static_cast<std::uint16_t>(100 + ahead);
    EXPECT_EQ(judge(next), Verdict::kRepeated) << ahead;
  }
  next.sequence = 100;
  for (const int ahead : {1, 32'767}) {
    next.sequence = static_cast<std::uint16_t>(next.sequence + ahead);
    EXPECT_EQ(judge(next), Verdict::kAccepted) << ahead;
  }
  next.sequence = 5;
  gate.open(kBoot);
  EXPECT_EQ(gate.last_sequence(), 0) << "of the session before";
  EXPECT_EQ(judge(next), Verdict::kAccepted) << "the first of a session may have any";
}

TEST_F(Gate, IsOpenToAnExpiryOfUpTo200MsAhead) {
  struct Case {
    int ahead_us;
    Verdict verdict;
  };
  for (const Case& one :
       {Case{-1, Verdict::kExpired}, Case{0, Verdict::kExpired}, Case{1, Verdict::kAccepted},
        Case{200'000, Verdict::kAccepted}, Case{200'001, Verdict::kTooFarAhead}}) {
    next.expiry_us = kNowUs + static_cast<std::uint32_t>(one.ahead_us);
    EXPECT_EQ(judge(next), one.verdict) << one.ahead_us;
    if (one.verdict == Verdict::kAccepted) ++next.sequence;
  }
}

TEST_F(Gate, IsOpenToAnswersToASampleWithinTheWindow) {
  for (const int back : {-1, 19, 60, 64}) {
    next.answers = static_cast<std::uint16_t>(60 - back);
    EXPECT_EQ(judge(next), Verdict::kUnknownSample) << back;
  }
  next.answers = 60 - 18;  // 90 ms
  EXPECT_EQ(judge(next), Verdict::kAccepted);
  EXPECT_EQ(gate.answered().device_us, kNowUs - 90'000U);
}

TEST_F(Gate, IsOpenToFiniteValuesInTheirRanges) {
  using Command = wire::Command;
  const std::vector<std::pair<float Command::*, float>> limits = {
      {&Command::x_m, 1e4f},
      {&Command::y_m, 1e4f},
      {&Command::yaw_rad, 1e3f},
      {&Command::desired_yaw_rad, 1e3f},
      {&Command::yaw_rate_radps, 10.0f},
      {&Command::speed_mps, 2.0f},
      {&Command::gyro_bias_radps, 1.0f}};
  for (std::size_t i = 0; i < limits.size(); ++i) {
    SCOPED_TRACE(i);
    const auto [field, limit] = limits[i];
    const float beyond = std::nextafter(limit, kInf), before = gate.current().*field;
    Command bad = next;
    for (const float value : {kNan, kInf, -kInf, beyond, -beyond}) {
      bad.*field = value;
      EXPECT_EQ(judge(bad), Verdict::kOutOfRange) << value;
      EXPECT_EQ(gate.current().*field, before) << value;
    }
    for (const float value : {limit, -limit}) {
      Command good = next;
      good.*field = value;
      EXPECT_EQ(judge(good), Verdict::kAccepted) << value;
      ++next.sequence;
    }
  }
}

TEST_F(Gate, ACommandIsFreshUntilItsExpiryOrForTheLifeInTheParameters) {
  for (const std::uint32_t ahead_us : {50'000U, 150'000U}) {
    next.expiry_us = kNowUs + ahead_us;
    ++next.sequence;
    ASSERT_EQ(judge(next), Verdict::kAccepted);
    const std::uint32_t life_us = std::min(ahead_us, 110'000U);
    EXPECT_EQ(gate.life_us(), life_us);
    EXPECT_TRUE(gate.fresh(kNowUs + life_us - 1));
    EXPECT_FALSE(gate.fresh(kNowUs + life_us));
    EXPECT_FALSE(gate.fresh(kNowUs + 1)) << "it is fresh again after a turn of the clock";
  }
}

TEST(Commands, EachWishMovesAnArmedRobotAndNoWishDoesNot) {
  Rig rig;
  rig.drive(0.0f);
  rig.streams = false;
  for (float wire::Command::*const wish :
       {&wire::Command::gyro_bias_radps, &wire::Command::speed_mps, &wire::Command::yaw_rate_radps,
        &wire::Command::desired_yaw_rad}) {
    const bool moving = wish != &wire::Command::gyro_bias_radps;
    wire::Command command = rig.command();
    command.*wish = 0.1f;
    rig.send(command);
    rig.run(30);
    EXPECT_EQ(rig.motors_on(), moving);
    EXPECT_EQ(rig.program.state(), moving ? State::kRunning : State::kArmed);
    rig.send(rig.command());
    rig.send(wire::Disarm{1});
    rig.run(5);
    rig.arm();
  }
}

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
