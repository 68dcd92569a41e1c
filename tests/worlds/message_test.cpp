// The messages between the daemon and a world: their format, and what of a world's is refused.

#include "worlds/message.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/arithmetic.h"

namespace tp100::worlds {
namespace {

using Verdict = Decoded::Verdict;

PoseReport report() {
  PoseReport out;
  out.session = 7;
  out.sequence = 4711;
  out.stamp_s = 12.345678;
  out.run = 1;
  out.source = PoseSource::kOdometry;
  out.pose = {.x_m = 0.612, .y_m = 0.034, .z_m = 0.041, .pitch_rad = -0.483, .yaw_rad = 0.024};
  out.floor[PoseSource::kModel] = {.x_m = 0.64, .y_m = 0.02, .yaw_rad = 0.01};
  out.floor[PoseSource::kOdometry] = {.x_m = 0.65, .y_m = 0.034, .yaw_rad = 0.024};
  out.floor[PoseSource::kFused] = {.x_m = 0.651, .y_m = 0.035, .yaw_rad = 0.025};
  out.twist = {.vx_mps = 0.098, .vy_mps = 0.001, .yaw_rate_radps = 0.31};
  out.left_mps = 0.101;
  out.right_mps = 0.118;
  out.slip_left = 0.17;
  out.slip_right = 0.18;
  out.mode = RunState::kRunning;
  out.desired_yaw_rad = 0.05;
  out.speed_mps = 0.1;
  return out;
}

Hello hello() {
  Hello out;
  out.session = 7;
  out.version = "0.1.0";
  out.course = "3";
  out.setup = "flat";
  return out;
}

const std::string kWorld =
    R"({"v":1,"type":"world","session":7,"seq":933,"ack":4711,"timestamp":12.35,)"
    R"("ground":{"z":0.041,"pitch":-0.489,"roll":0.02,"surface":"tarpaulin"},)"
    R"("contact":{"step":0.037,"blocked":true},)"
    R"("pose":{"pos":[0.61,0.03,0.04],"rpy":[0,-0.48,0.02]},"cmd":{"estop":true}})";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kWorld;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Verdict verdict(const std::string& text) { return decode_world(text, Frame::kRos).verdict; }

// Other programs rely on this format, which WORLD.md documents: a change here breaks them. Unreal's
// frame shows each unit.
TEST(WorldMessage, IsWrittenAsDocumented) {
  EXPECT_EQ(encode(hello()),
            R"({"v":1,"type":"hello","session":7,"name":"tp100d","version":"0.1.0","frame":"ros",)"
            R"("authority":"bridge","rate_hz":100.0,"timeout_s":0.3,"lockstep":false,)"
            R"("course":"3","setup":"flat"})");
  EXPECT_EQ(encode(report(), Frame::kUnreal),
            R"({"v":1,"type":"pose","session":7,"seq":4711,"timestamp":12.345678,"run":1,)"
            R"("frame":"unreal","src":"odometry","pos":[61.2,-3.4,4.1],)"
            R"("quat":[-0.00287,-0.239142,-0.011651,0.97091],"rpy":[0.0,27.673862,-1.375099],)"
            R"("floor":{"pos":[65.0,-3.4,0.0],"yaw":-1.375099},)"
            R"("estimates":{"model":{"pos":[64.0,-2.0,0.0],"yaw":-0.572958},)"
            R"("odometry":{"pos":[65.0,-3.4,0.0],"yaw":-1.375099},)"
            R"("fused":{"pos":[65.1,-3.5,0.0],"yaw":-1.432394}},"vel":[9.8,-0.1,0.0],)"
            R"("omega":[0.0,0.0,-17.761692],"tracks":{"l":10.1,"r":11.8},)"
            R"("slip":{"l":0.17,"r":0.18},"mode":"running",)"
            R"("target":{"yaw":-2.864789,"speed":10.0}})");
}

TEST(WorldMessage, TheLongestFitsADatagram) {
  PoseReport far = report();
  far.session = 4294967295U;
  far.sequence = std::uint64_t{1} << 53;
  far.stamp_s = -1e9 - 0.123456;
  far.pose = {-999.123456, -999.123456, -99.123456, -1.123456, -1.123456, -1234.123456};
  far.floor = same_for_all(far.pose);
  far.twist = {-9.123456, -9.123456, -9.123456};
  far.left_mps = far.right_mps = far.slip_left = far.slip_right = -9.123456;
  for (const Frame frame : {Frame::kRos, Frame::kUnreal, Frame::kUnity})
    EXPECT_LE(encode(far, frame).size(), kMaxWorldDatagram);
  Hello long_hello = hello();
  long_hello.course = long_hello.setup = long_hello.version = std::string(5000, '\x01');
  EXPECT_LE(encode(long_hello).size(), kMaxWorldDatagram);
  EXPECT_LE(encode_error(std::string(5000, '"')).size(), kMaxWorldDatagram);
}

TEST(WorldMessage, SaysWhatTheWorldSaid) {
  const Decoded decoded = decode_world(kWorld, Frame::kRos);
  ASSERT_EQ(decoded.verdict, Verdict::kGood);
  const WorldMessage& m = decoded.message;
  EXPECT_EQ(m.type, WorldMessage::Type::kWorld);
  EXPECT_EQ(m.session, 7u);
  EXPECT_EQ(m.sequence, 933u);
  EXPECT_EQ(m.answers, 4711u);
  EXPECT_EQ(m.stamp_s, 12.35);
  ASSERT_TRUE(m.ground && m.pose);
  EXPECT_EQ(m.ground->surface, "tarpaulin");
  EXPECT_EQ(m.ground->roll_rad, 0.02);
  EXPECT_TRUE(m.blocked && m.stop);
  EXPECT_EQ(m.pose->x_m, 0.61);
}

TEST(WorldMessage, IsReadInTheFrameOfTheWorld) {
  const Decoded unreal = decode_world(
      R"({"v":1,"type":"world","seq":1,"ack":1,"ground":{"z":4.1,"pitch":28,"roll":5},)"
      R"("contact":{"step":3.7},"pose":{"pos":[61,-3,4],"quat":[0,-0.2588190,0,0.9659258]}})",
      Frame::kUnreal);
  ASSERT_EQ(unreal.verdict, Verdict::kGood);
  EXPECT_DOUBLE_EQ(unreal.message.ground->height_m, 0.041);
  EXPECT_DOUBLE_EQ(unreal.message.ground->pitch_rad, -28 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(unreal.message.ground->roll_rad, 5 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(unreal.message.step_height_m, 0.037);
  EXPECT_DOUBLE_EQ(unreal.message.pose->y_m, 0.03);
  EXPECT_NEAR(unreal.message.pose->pitch_rad, -30 * kRadPerDeg, 1e-6);
  const Decoded unity =
      decode_world(R"({"v":1,"type":"world","seq":1,"ack":1,"ground":{"z":0.041,"pitch":-28},)"
                   R"("pose":{"pos":[-0.03,0.04,0.61],"rpy":[0,-30,90]}})",
                   Frame::kUnity);
  ASSERT_EQ(unity.verdict, Verdict::kGood);
  EXPECT_DOUBLE_EQ(unity.message.ground->pitch_rad, -28 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(unity.message.pose->x_m, 0.61);
  EXPECT_DOUBLE_EQ(unity.message.pose->y_m, 0.03);
  EXPECT_DOUBLE_EQ(unity.message.pose->z_m, 0.04);
  EXPECT_DOUBLE_EQ(unity.message.pose->yaw_rad, -kPi / 2);
}

TEST(WorldMessage, OptionalBlocksMayBeMissingAndUnknownFieldsAreIgnored) {
  for (const std::string& text :
       {std::string(R"({"v":1,"type":"world","seq":1,"ack":2})"),
        std::string(R"({"more":[{}],"v":1,"type":"world","seq":1,"ack":2,"ground":null,"x":{}})"),
        std::string(R"({"v":1,"type":"welcome","session":3})"), kWorld + "\n",
        changed("0.037", "1.0")})
    EXPECT_EQ(verdict(text), Verdict::kGood) << text;
}

TEST(WorldMessage, AnotherVersionIsToldApart) {
  const Decoded decoded = decode_world(R"({"v":2,"type":"world"})", Frame::kRos);
  EXPECT_EQ(decoded.verdict, Verdict::kOtherVersion);
  EXPECT_EQ(decoded.version, 2);
}

TEST(WorldMessage, WhatIsNotOfTheFormatOrOutOfRangeIsRefused) {
  for (const char* text :
       {"", "[]", "null", "{}", "{\"v\":\"1\"}", "{\"v\":1}",
        R"({"v":1,"type":"pose","seq":1,"ack":1})", R"({"v":1,"type":"world","seq":1})",
        R"({"v":1,"type":"welcome"})", R"({"v":1,"type":7,"seq":1,"ack":1})"})
    EXPECT_EQ(verdict(text), Verdict::kMalformed) << text;
  for (const char* number : {"1e999", "-1e999", "NaN", "Infinity", "100.001", "-1e300", "\"1\""})
    EXPECT_EQ(verdict(changed("\"z\":0.041", "\"z\":" + std::string(number))), Verdict::kMalformed)
        << number;
  for (const auto& [from, to] : {std::pair{"\"ack\":4711", "\"ack\":-1"},
                                 {"\"ack\":4711", "\"ack\":1.5"},
                                 {"\"ack\":4711", "\"ack\":18446744073709551615"},
                                 {"\"estop\":true", "\"estop\":1"},
                                 {"\"z\":0.041,", ""},
                                 {"[0.61,0.03,0.04]", "[0.61,0.03]"},
                                 {"\"rpy\":[0,-0.48,0.02]", "\"quat\":[0,0,0,0]"},
                                 {"\"rpy\":[0,-0.48,0.02]", "\"quat\":[0,0,0,2]"},
                                 {"\"session\":7", "\"session\":4294967296"},
                                 {"-0.489", "1.6"},
                                 {"\"roll\":0.02", "\"roll\":-1.6"},
                                 {"0.037", "-0.001"},
                                 {"0.037", "1.001"},
                                 {"[0.61", "[1000.1"},
                                 {"}}", "}}}"}})
    EXPECT_EQ(verdict(changed(from, to)), Verdict::kMalformed) << to;
  EXPECT_EQ(verdict(changed("tarpaulin", std::string(65, 'a'))), Verdict::kMalformed);
  EXPECT_EQ(verdict(changed("{\"v\"", "{\"pad\":\"" + std::string(1200, 'x') + "\",\"v\"")),
            Verdict::kMalformed);
  EXPECT_EQ(verdict(std::string(600, '[') + std::string(600, ']')), Verdict::kMalformed);
}

}  // namespace
}  // namespace tp100::worlds
