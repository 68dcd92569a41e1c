#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/battery.h"

namespace tp100::firmware {
namespace {

// The converter's reading of a voltage on a board with this supply.
std::uint16_t steps_of(double volts, double supply_v) {
  return static_cast<std::uint16_t>(std::clamp(volts / supply_v * 1024.0, 0.0, 1023.0));
}
double battery_read_v(double battery_v, double supply_v, double bandgap_v) {
  Supply supply;
  for (int i = 0; i < 20; ++i) supply.update(steps_of(bandgap_v, supply_v));
  return supply.battery_mv(steps_of(battery_v / 3.0, supply_v)) * 1e-3;
}

TEST(Supply, IsFiveVoltsUntilTheBandgapWasMeasured) {
  Supply supply;
  EXPECT_EQ(supply.millivolts(), 5000);
  supply.update(0);
  EXPECT_EQ(supply.millivolts(), 5000);
  EXPECT_EQ(supply.battery_mv(1023), 14985);
}

TEST(Supply, IsFourTimesABandgapOfAQuarterOfTheScale) {
  Supply supply;
  supply.update(256);
  EXPECT_EQ(supply.millivolts(), 4400);
}

TEST(Supply, BatteryReadRightAtAnyUsbVoltageUpToFiveVolts) {
  for (double supply_v = 4.4; supply_v <= 5.0; supply_v += 0.05) {
    for (const double battery_v : {5.4, 6.0, 7.4, 8.4}) {
      EXPECT_NEAR(battery_read_v(battery_v, supply_v, 1.1), battery_v, 0.01 * battery_v)
          << supply_v;
    }
  }
}

TEST(Supply, NoChipReadsTheBatteryHigherThanIfFiveVoltsWereAssumedNorTenPercentTooHigh) {
  for (double supply_v = 4.4; supply_v <= 5.25; supply_v += 0.05) {
    for (double bandgap_v = 1.0; bandgap_v <= 1.2; bandgap_v += 0.02) {
      const double read = battery_read_v(6.0, supply_v, bandgap_v);
      EXPECT_LE(read, 6.0 * 5.0 / supply_v + 1e-9) << supply_v << " " << bandgap_v;
      EXPECT_LE(read, 6.0 * 1.11) << supply_v << " " << bandgap_v;
      EXPECT_GE(read, 6.0 * 0.90) << supply_v << " " << bandgap_v;
    }
  }
}

TEST(Supply, AnOddReadingMovesItByAQuarterAtMost) {
  Supply supply;
  for (int i = 0; i < 20; ++i) supply.update(steps_of(1.1, 4.5));
  const int before = supply.millivolts();
  supply.update(steps_of(1.1, 4.1));
  EXPECT_NEAR(supply.millivolts(), before - 100, 10);
}

}  // namespace
}  // namespace tp100::firmware
