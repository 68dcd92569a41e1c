// Worlds that write text files: the encoders' text, and orientations in many writings.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "../support/corrupted.h"
#include "core/arithmetic.h"
#include "core/error.h"
#include "worlds/text_files.h"

namespace tp100::worlds {
namespace {

std::unique_ptr<StepRecord> record() {
  auto out = std::make_unique<StepRecord>();
  out->step = 17;
  out->now_ns = 2'500'000'000;
  out->snapshot.left_mps = 0.1;
  out->snapshot.right_mps = 0.11;
  out->snapshot.sample.left_counts = -5;
  out->snapshot.world = {.x_m = 1.0, .y_m = 0.5, .pitch_rad = -0.1, .yaw_rad = kPi / 2};
  out->snapshot.run_state = RunState::kRunning;
  return out;
}

TEST(EncoderText, FillsTheTemplateInTheFrame) {
  EXPECT_EQ(encoder_text("{seq} {left} {right}", *record(), Frame::kRos), "17 0.100000 0.110000\n");
  EXPECT_EQ(encoder_text("{left},{right},{y},{yaw} {mode}\n", *record(), Frame::kUnreal),
            "10.000000,11.000000,-50.000000,-90.000000 running\n");
  EXPECT_EQ(encoder_text("{t_s}\t{left_count}", *record(), Frame::kRos), "2.500000\t-5\n");
}

TEST(OrientationText, UnrealsOwnTextsAreUnderstood) {
  const auto both = orientation_of(
      "X=120.000 Y=80.000 Z=3.700\nP=28.000000 Y=-90.000000 R=2.000000\n", Frame::kUnreal);
  ASSERT_TRUE(both && both->has_place && both->has_turn);
  EXPECT_DOUBLE_EQ(both->pose.x_m, 1.2);
  EXPECT_DOUBLE_EQ(both->pose.y_m, -0.8);
  EXPECT_DOUBLE_EQ(both->pose.z_m, 0.037);
  EXPECT_DOUBLE_EQ(both->pose.pitch_rad, -28 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(both->pose.yaw_rad, kPi / 2);
  EXPECT_DOUBLE_EQ(both->pose.roll_rad, 2 * kRadPerDeg);
  const auto other = orientation_of("P=1 Y=2 R=3, X=4 Y=5 Z=6", Frame::kUnreal);
  ASSERT_TRUE(other && other->has_place);
  EXPECT_DOUBLE_EQ(other->pose.y_m, -0.05);
  const auto turn = orientation_of("P=-1.5 Y=2 R=0.3", Frame::kRos);
  ASSERT_TRUE(turn);
  EXPECT_FALSE(turn->has_place);
  EXPECT_DOUBLE_EQ(turn->pose.pitch_rad, -1.5);
}

TEST(OrientationText, PlainNumbersAreInARotatorsOrder) {
  const auto one = orientation_of("28.0\n", Frame::kUnreal);
  ASSERT_TRUE(one);
  EXPECT_FALSE(one->has_turn);
  EXPECT_DOUBLE_EQ(one->pose.pitch_rad, -28 * kRadPerDeg);
  const auto marked = orientation_of(
      "\xef\xbb\xbf"
      "28.0\n",
      Frame::kUnreal);
  ASSERT_TRUE(marked);
  EXPECT_DOUBLE_EQ(marked->pose.pitch_rad, -28 * kRadPerDeg);
  const auto three = orientation_of("0.1, 0.2, 0.3", Frame::kRos);
  ASSERT_TRUE(three && three->has_turn);
  EXPECT_DOUBLE_EQ(three->pose.pitch_rad, 0.1);
  EXPECT_DOUBLE_EQ(three->pose.yaw_rad, 0.2);
  EXPECT_DOUBLE_EQ(three->pose.roll_rad, 0.3);
  const auto six = orientation_of("(1 2 3 0.1 0.2 0.3)", Frame::kRos);
  ASSERT_TRUE(six && six->has_place);
  EXPECT_DOUBLE_EQ(six->pose.z_m, 3);
  EXPECT_DOUBLE_EQ(six->pose.yaw_rad, 0.2);
}

TEST(WorldText, ABadTemplateIsAnErrorAtTheStart) {
  EXPECT_NO_THROW(require_encoder_template("{seq} {left} {right} end", "k"));
  for (const std::string& bad :
       {std::string("{wheel}"), std::string("{left"), std::string(501, 'x')})
    EXPECT_THROW(require_encoder_template(bad, "k"), UserError) << bad;
}

TEST(OrientationText, WhatIsIncompleteOrOutOfRangeIsRefused) {
  for (const char* text : {"", "   ", "1 2", "1 2 3 4", "1 2 3 4 5 6 7", "0.1.2", "0x10", "up"})
    EXPECT_FALSE(orientation_of(text, Frame::kRos)) << text;
  for (const char* text : {"nan", "inf", "1e999", "2.0", "0 0 0 2001 0 0", "1001 0 0 0 0 0"})
    EXPECT_FALSE(orientation_of(text, Frame::kRos)) << text;
  for (const char* text : {"P=", "P=1 Y=2", "P=1 Y=2 R=", "P=1 Y=2 R=3 X=1", "P=1 Y=2 R=3 R=4",
                           "P=0 Y=1e9 R=0", "X=1 Y=2 Z=3"})
    EXPECT_FALSE(orientation_of(text, Frame::kRos)) << text;
  std::string long_text(5001, ' ');
  long_text.back() = '1';
  EXPECT_FALSE(orientation_of(long_text, Frame::kRos));
}

TEST(OrientationText, SurvivesGarbage) {
  std::mt19937 random(5);
  const std::string good = "X=120.0 Y=80.0 Z=3.7 P=28.0 Y=-90.0 R=2.0\n";
  for (int i = 0; i < 20'000; ++i) {
    const std::string bad = test::corrupted(good, i, 3, random);
    const auto read = orientation_of(bad, Frame::kUnreal);
    if (!read) continue;
    EXPECT_LE(std::abs(read->pose.pitch_rad), 1.5708);
    EXPECT_LE(std::abs(read->pose.x_m), 1000.0);
  }
}

}  // namespace
}  // namespace tp100::worlds
