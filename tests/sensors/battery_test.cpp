#include <gtest/gtest.h>

#include "sim/sensors/drive_train.h"

namespace tp100::sim {
namespace {

TEST(Battery, SagsUnderLoadAndRecovers) {
  Battery battery({});
  battery.step(0.0);
  const double rested = battery.volts();
  battery.step(20.0);
  EXPECT_NEAR(rested - battery.volts(), 0.12 * 0.10 * 20.0, 1e-4);
  battery.step(0.0);
  EXPECT_NEAR(battery.volts(), rested, 1e-4);
}

TEST(Battery, RunsDown) {
  course::EmulatedBattery values;
  values.capacity_as = 1.0;
  Battery battery(values);
  for (int i = 0; i < 10000; ++i) battery.step(10.0);
  EXPECT_LT(battery.volts(), 6.2);
}

}  // namespace
}  // namespace tp100::sim
