// The types of what goes over ROS 2's topics; their encoding: tests/npm/ros2_bag_test.mjs.
#include "ros2/message_type.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "ros2/inputs.h"
#include "ros2/message_types.h"
#include "ros2/topics.h"

namespace tp100::ros2 {
namespace {

// As rosidl prints them (`ros2 topic info --verbose` shows them after "RIHS01_"). With another
// hash, ROS 2 would say that the types differ, and show nothing.
constexpr const char* kHashes = R"(
diagnostic_msgs/msg/DiagnosticArray 5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e
geometry_msgs/msg/PoseStamped 10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8
geometry_msgs/msg/PoseWithCovarianceStamped 26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e
geometry_msgs/msg/Twist 9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a
geometry_msgs/msg/TwistStamped 5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64
nav_msgs/msg/Odometry 3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0
nav_msgs/msg/Path 1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b
rmw_dds_common/msg/ParticipantEntitiesInfo 91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e
rosgraph_msgs/msg/Clock 692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564
sensor_msgs/msg/BatteryState 4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741
sensor_msgs/msg/Imu 7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b
sensor_msgs/msg/JointState a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e
std_msgs/msg/Bool feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9
std_msgs/msg/Empty 20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312
std_msgs/msg/String df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18
tf2_msgs/msg/TFMessage e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087
)";

TEST(MessageType, HashesOfAllTopicsAreThoseOfRos2) {
  std::set<std::string> types;
  const auto add = [&](const MessageType& type) {
    types.insert(std::string(type.name) + " " + std::string(type.hash.substr(7)) + "\n");
  };
  for (const TopicText& topic : topics()) add(*topic.type);
  for (const InputText& input : inputs()) add(*input.type);
  add(rmw_dds_common::ParticipantEntitiesInfo::kType);
  std::string text = "\n";
  for (const std::string& type : types) text += type;
  EXPECT_EQ(text, kHashes);
}

}  // namespace
}  // namespace tp100::ros2
