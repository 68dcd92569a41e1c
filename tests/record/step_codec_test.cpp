// Steps as bytes: every field comes back bit for bit, and bytes that are no step are refused. How
// far two computations of a step differ.

#include "record/step_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/arithmetic.h"
#include "random_record.h"
#include "record/step_difference.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

std::vector<std::uint8_t> encoded(const StepRecord& record) {
  std::vector<std::uint8_t> bytes;
  encode_step(record, bytes);
  return bytes;
}

TEST(StepCodec, EveryFieldComesBackBitForBit) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto record = random_record(seed, seed % 2 == 0);
    const auto bytes = encoded(*record);
    auto back = random_record(seed + 1000);
    ASSERT_EQ(decode_step(bytes, *back), std::nullopt) << seed;
    ASSERT_EQ(encoded(*back), bytes) << seed;
    ASSERT_EQ(first_difference(*record, *back), std::nullopt) << seed;
  }
}

TEST(StepCodec, ResultsMayBeAnyDoubleDownToTheSignOfZero) {
  const auto record = random_record(1);
  auto back = random_record(2);
  for (const double value :
       {-0.0, std::numeric_limits<double>::denorm_min(), HUGE_VAL, std::nan("")}) {
    record->snapshot.filter.nis_mean = value;
    ASSERT_EQ(decode_step(encoded(*record), *back), std::nullopt);
    EXPECT_EQ(first_difference(*record, *back), std::nullopt);
  }
  record->snapshot.filter.nis_mean = 0.0;
  back->snapshot.filter.nis_mean = -0.0;
  const auto difference = first_difference(*record, *back);
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->field, "snapshot.filter.nis_mean");
  EXPECT_EQ(difference->recorded, "0");
  EXPECT_EQ(difference->computed, "-0");
}

TEST(StepCodec, RefusesBytesThatAreTooFewOrTooMany) {
  const auto record = random_record(3);
  auto back = random_record(4);
  auto bytes = encoded(*record);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_NE(decode_step(std::span(bytes).first(size), *back), std::nullopt) << size;
  bytes.push_back(0);
  EXPECT_THAT(decode_step(bytes, *back).value_or(""), HasSubstr("1 bytes too many"));
}

TEST(StepCodec, ABlockOfInputsIsTakenStepByStepAndRefusedWhereItIsCut) {
  std::vector<std::uint8_t> block;
  std::set<std::size_t> ends;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    encode_inputs(*random_record(seed), block);
    ends.insert(block.size());
  }
  auto back = random_record(4);
  std::span<const std::uint8_t> rest(block);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ASSERT_EQ(decode_inputs(rest, *back), std::nullopt);
    EXPECT_EQ(back->now_ns, random_record(seed)->now_ns);
  }
  EXPECT_TRUE(rest.empty());
  for (std::size_t size = 1; size < block.size(); ++size) {
    rest = std::span(block).first(size);
    std::optional<std::string> problem;
    while (!problem && !rest.empty()) problem = decode_inputs(rest, *back);
    // A block that is cut between two steps is valid.
    ASSERT_EQ(problem.has_value(), !ends.contains(size)) << size;
  }
}

TEST(StepCodec, RefusesInputsThatNoRobotCanHaveMeasured) {
  auto back = random_record(4);
  const std::pair<const char*, std::function<void(StepInputs&)>> changes[] = {
      {"gyro", [](StepInputs& in) { in.samples[0].gyro_radps[1] = std::nan(""); }},
      {"battery", [](StepInputs& in) { in.samples[0].battery_v = HUGE_VAL; }},
      {"device", [](StepInputs& in) { in.samples[0].device_us = INT64_MAX; }},
      {"drift", [](StepInputs& in) { in.clock.drift = -1.0; }},
      {"state", [](StepInputs& in) { in.samples[0].state = static_cast<RobotState>(99); }}};
  for (const auto& [field, change] : changes) {
    const auto record = random_record(3);
    record->inputs.samples.resize(1);
    record->inputs.clock.valid = true;
    change(record->inputs);
    EXPECT_THAT(decode_step(encoded(*record), *back).value_or(""), HasSubstr(field));
  }
  auto bytes = encoded(*random_record(3));
  bytes[20] = 65;  // number of samples: behind the time, the step's number and that of restarts
  EXPECT_THAT(decode_step(bytes, *back).value_or(""), HasSubstr("samples"));
}

// On a busy machine replies wait in buffers and seem to arrive at the same time, which gives
// extreme drifts.
TEST(StepCodec, TakesTheDriftOfTheFirstExchanges) {
  auto back = random_record(4);
  for (const double drift : {-0.9999, -1.5, 40.0}) {
    const auto record = random_record(3);
    record->inputs.clock.valid = true;
    record->inputs.clock.reference_host_ns = record->now_ns - 10 * kNsPerS;
    record->inputs.camera.clear();
    record->inputs.clock.drift = drift;
    EXPECT_EQ(decode_step(encoded(*record), *back), std::nullopt) << drift;
  }
}

// Without a course, a step that continues a run has no path to follow.
TEST(StepCodec, RefusesARestartWithinARun) {
  for (const RunState state : {RunState::kArming, RunState::kRunning}) {
    const auto record = random_record(3, true);
    record->inputs.restart[0].run_state = state;
    auto back = random_record(4);
    EXPECT_THAT(decode_step(encoded(*record), *back).value_or(""), HasSubstr("run_state"));
    std::vector<std::uint8_t> block;
    encode_inputs(*record, block);
    std::span<const std::uint8_t> rest = block;
    EXPECT_THAT(decode_inputs(rest, *back).value_or(""), HasSubstr("run_state"));
  }
}

TEST(StepDifference, NamesTheFirstResultThatDiffersAndNoInputOrCounter) {
  const auto a = random_record(5), b = random_record(5);
  b->inputs.clock.drift += 0.1;
  b->link.samples += 1;
  EXPECT_EQ(first_difference(*a, *b), std::nullopt);
  b->snapshot.command.pose.yaw_rad = std::nextafter(b->snapshot.command.pose.yaw_rad, 1.0);
  b->snapshot.faults ^= 1;
  ASSERT_TRUE(first_difference(*a, *b).has_value());
  EXPECT_EQ(first_difference(*a, *b)->field, "snapshot.command.pose.yaw_rad");
  EXPECT_NE(first_difference(*a, *b)->recorded, first_difference(*a, *b)->computed);
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

TEST(LargestDifference, OfALargeNumberIsRelativeAndOfACountIsNoRounding) {
  const auto recorded = random_record(5), computed = random_record(5);
  recorded->snapshot.filter.nis_mean = 1e6;
  computed->snapshot.filter.nis_mean = 1e6 + 1.0;
  LargestDifference largest;
  largest.add(*recorded, *computed);
  EXPECT_NEAR(largest.other, 1e-6, 1e-11);
  EXPECT_FALSE(largest.decided);
  computed->snapshot.command.expiry_us += 1;
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
