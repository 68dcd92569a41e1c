#include "record/step_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/arithmetic.h"
#include "random_record.h"

namespace tp100::record {
namespace {

TEST(StepDifference, NamesTheFirstResultThatDiffers) {
  const auto a = random_record(5), b = random_record(5);
  b->snapshot.command.pose.yaw_rad = std::nextafter(b->snapshot.command.pose.yaw_rad, 1.0);
  b->snapshot.faults ^= 1;
  ASSERT_TRUE(first_difference(*a, *b).has_value());
  EXPECT_EQ(first_difference(*a, *b)->field, "snapshot.command.pose.yaw_rad");
  EXPECT_NE(first_difference(*a, *b)->recorded, first_difference(*a, *b)->computed);
}

TEST(StepDifference, InputsAndCountersAreNoResults) {
  const auto a = random_record(5), b = random_record(5);
  b->inputs.clock.drift += 0.1;
  b->link.samples += 1;
  EXPECT_EQ(first_difference(*a, *b), std::nullopt);
}

TEST(LargestDifference, IsTheLargestOfAllRecordsByUnit) {
  const auto recorded = random_record(5);
  LargestDifference largest;
  const auto add = [&](const std::function<void(Snapshot&)>& change) {
    const auto computed = random_record(5);
    change(computed->snapshot);
    largest.add(*recorded, *computed);
  };
  add([](Snapshot&) {});
  EXPECT_TRUE(largest.within(0.0));
  add([](Snapshot& s) { s.estimates[PoseSource::kModel].pose.y_m += 0x1p-40; });
  add([](Snapshot& s) { s.cross_track_m -= 0x1p-38; });
  add([](Snapshot& s) { s.command.pose.x_m += 0x1p-39; });
  EXPECT_NEAR(largest.length_m, 0x1p-38, 1e-16);
  EXPECT_EQ(largest.angle_rad, 0.0);
  EXPECT_EQ(largest.other, 0.0);
  add([](Snapshot& s) { s.estimates[PoseSource::kFused].pose.yaw_rad += 2.0 * kPi + 0x1p-30; });
  EXPECT_NEAR(largest.angle_rad, 0x1p-30, 1e-14);
  add([](Snapshot& s) { s.estimates[PoseSource::kFused].covariance.xx += 0x1p-20; });
  EXPECT_NEAR(largest.other, 0x1p-20, 1e-14);
  EXPECT_TRUE(largest.within(0x1p-19));
  EXPECT_FALSE(largest.within(0x1p-21));
}

TEST(LargestDifference, OfALargeNumberIsRelative) {
  const auto recorded = random_record(5), computed = random_record(5);
  recorded->snapshot.filter.nis_mean = 1e6;
  computed->snapshot.filter.nis_mean = 1e6 + 1.0;
  LargestDifference largest;
  largest.add(*recorded, *computed);
  EXPECT_NEAR(largest.other, 1e-6, 1e-11);
}

TEST(LargestDifference, ADecisionOrACountThatDiffersIsNoRounding) {
  const auto recorded = random_record(5), computed = random_record(5);
  computed->snapshot.command.expiry_us += 1;
  LargestDifference largest;
  largest.add(*recorded, *computed);
  EXPECT_TRUE(largest.decided);
  EXPECT_FALSE(largest.within(HUGE_VAL));
}

TEST(LargestDifference, NoNumberIsFarFromEveryNumberAndNotFromNone) {
  const auto recorded = random_record(5), computed = random_record(5);
  LargestDifference largest;
  // Processors differ in the sign of the NaN of an invalid operation.
  recorded->snapshot.filter.nis = std::nan("");
  computed->snapshot.filter.nis = -std::nan("");
  largest.add(*recorded, *computed);
  EXPECT_TRUE(largest.within(0.0));
  computed->snapshot.filter.nis = 0.0;
  largest.add(*recorded, *computed);
  EXPECT_EQ(largest.other, HUGE_VAL);
  recorded->snapshot.heading_error_rad = HUGE_VAL;
  largest.add(*recorded, *computed);
  EXPECT_EQ(largest.angle_rad, HUGE_VAL);
}

}  // namespace
}  // namespace tp100::record
