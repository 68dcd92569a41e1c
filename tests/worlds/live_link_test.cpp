#include <gtest/gtest.h>

#include "worlds/message.h"

namespace tp100::worlds {
namespace {

const Pose kPose{.x_m = 0.612, .y_m = 0.034, .z_m = 0.041, .pitch_rad = -0.483, .yaw_rad = 0.024};

TEST(LiveLink, BonesAreWhatTheJsonSourceParses) {
  EXPECT_EQ(encode_live_link("TP100", kPose, LiveLinkDialect::kBones),
            R"({"TP100":[{"Name":"root","Parent":-1,"Location":[61.2,-3.4,4.1],)"
            R"("Rotation":[-0.00287,-0.239142,-0.011651,0.97091],"Scale":[1,1,1]}]})");
}

TEST(LiveLink, ATransformIsOneObject) {
  EXPECT_EQ(encode_live_link("TP100", kPose, LiveLinkDialect::kTransform),
            R"({"TP100":{"Location":[61.2,-3.4,4.1],)"
            R"("Rotation":[-0.00287,-0.239142,-0.011651,0.97091],"Scale":[1,1,1]}})");
}

}  // namespace
}  // namespace tp100::worlds
