#include "record/step_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

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
    ASSERT_EQ(back->inputs.samples.size(), record->inputs.samples.size());
    for (std::uint32_t i = 0; i < record->inputs.samples.size(); ++i)
      ASSERT_EQ(back->inputs.samples[i].accel_mps2, record->inputs.samples[i].accel_mps2);
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
  for (std::uint64_t seed = 1; seed <= 3; ++seed) encode_inputs(*random_record(seed), block);
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
    std::size_t at = 0;
    bool between = false;
    while (at < size) {
      std::uint32_t length = 0;
      std::memcpy(&length, block.data() + at, sizeof length);
      at += sizeof length + length;
      between = at == size;
    }
    ASSERT_EQ(problem.has_value(), !between) << size;
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

TEST(StepCodec, TheSchemaListsTheLayout) {
  const auto schema = nlohmann::json::parse(step_schema());
  EXPECT_EQ(schema["fields"][0], nlohmann::json({"now_ns", "i64"}));
  EXPECT_EQ(schema["fields"][2][0], "restart");
  EXPECT_EQ(schema["fields"][3][0], "samples");
  EXPECT_EQ(schema["fields"][3][1][0], nlohmann::json({"count", "u32"}));
  EXPECT_EQ(schema["fields"].back()[0], "snapshot");
}

}  // namespace
}  // namespace tp100::record
