#include "ros2/message_type.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "ros2/inputs.h"
#include "ros2/message_types.h"
#include "ros2/topics.h"

namespace tp100::ros2 {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

// As rosidl prints them (`ros2 topic info --verbose` shows them).
const std::map<const MessageType*, std::string_view>& published_hashes() {
  static const std::map<const MessageType*, std::string_view> kPublished = {
      {&nav_msgs::Odometry::kType,
       "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
      {&sensor_msgs::Imu::kType,
       "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"},
      {&tf2_msgs::TFMessage::kType,
       "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
      {&geometry_msgs::Twist::kType,
       "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"},
      {&rosgraph_msgs::Clock::kType,
       "RIHS01_692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"},
      {&geometry_msgs::PoseStamped::kType,
       "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
      {&nav_msgs::Path::kType,
       "RIHS01_1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b"},
      {&sensor_msgs::BatteryState::kType,
       "RIHS01_4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741"},
      {&sensor_msgs::JointState::kType,
       "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
      {&std_msgs::String::kType,
       "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
      {&std_msgs::Empty::kType,
       "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312"},
      {&rmw_dds_common::ParticipantEntitiesInfo::kType,
       "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e"},
      {&geometry_msgs::PoseWithCovarianceStamped::kType,
       "RIHS01_26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e"},
      {&geometry_msgs::TwistStamped::kType,
       "RIHS01_5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64"},
      {&std_msgs::Bool::kType,
       "RIHS01_feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9"},
      {&diagnostic_msgs::DiagnosticArray::kType,
       "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
  };
  return kPublished;
}

TEST(MessageType, HashesAreThoseOfRos2) {
  for (const auto& [type, hash] : published_hashes()) EXPECT_EQ(type->hash, hash) << type->name;
}

TEST(MessageType, TheHashOfEveryTopicIsCompared) {
  for (const TopicText& topic : topics())
    EXPECT_TRUE(published_hashes().contains(topic.type)) << topic.name;
  for (const InputText& input : inputs())
    EXPECT_TRUE(published_hashes().contains(input.type)) << input.name;
}

TEST(MessageType, NamesAreThoseOfRos2AndOfDds) {
  EXPECT_EQ(nav_msgs::Odometry::kType.name, "nav_msgs/msg/Odometry");
  EXPECT_EQ(nav_msgs::Odometry::kType.dds_name, "nav_msgs::msg::dds_::Odometry_");
}

TEST(MessageType, ASchemaHasEveryMessageWithinItOnce) {
  const std::string schema(tf2_msgs::TFMessage::kType.schema);
  for (const char* inner :
       {"builtin_interfaces/Time", "std_msgs/Header", "geometry_msgs/TransformStamped",
        "geometry_msgs/Transform", "geometry_msgs/Vector3", "geometry_msgs/Quaternion"}) {
    const std::string head = "\nMSG: " + std::string(inner) + "\n";
    const std::size_t at = schema.find(head);
    ASSERT_NE(at, std::string::npos) << inner;
    EXPECT_EQ(schema.find(head, at + 1), std::string::npos) << inner;
  }
}

TEST(Cdr, AlignsEachNumberToItsSize) {
  Bytes out;
  CdrWriter cdr(out);
  cdr.put(std::uint8_t{1});
  cdr.put(std::uint32_t{2});
  cdr.put(true);
  cdr.put(1.0);
  EXPECT_THAT(out, ElementsAreArray({1, 0, 0, 0, 2, 0, 0,    0,   1, 0, 0, 0, 0, 0, 0, 0,  //
                                     0, 0, 0, 0, 0, 0, 0xF0, 0x3F}));
}

TEST(Cdr, TextHasItsLengthWithTheFinalZero) {
  Bytes out;
  CdrWriter(out).put(std::string("map"));
  EXPECT_THAT(out, ElementsAreArray(Bytes{4, 0, 0, 0, 'm', 'a', 'p', 0}));
}

TEST(Cdr, ASequenceHasItsLengthAndAnArrayHasNot) {
  Bytes out;
  CdrWriter cdr(out);
  cdr.put(std::vector<std::uint8_t>{7, 8});
  cdr.put(std::array<std::uint8_t, 2>{9, 10});
  cdr.put(std::vector<double>{});
  EXPECT_THAT(out, ElementsAreArray({2, 0, 0, 0, 7, 8, 9, 10, 0, 0, 0, 0}));
}

// The alignment counts from the end of the header.
TEST(Cdr, AMessageBeginsWithTheEncoding) {
  const Bytes bytes = serialized(geometry_msgs::Point{.x = 1.0});
  ASSERT_EQ(bytes.size(), 4u + 3 * 8u);
  EXPECT_THAT(Bytes(bytes.begin(), bytes.begin() + 4), ElementsAreArray({0, 1, 0, 0}));
  EXPECT_EQ(bytes[11], 0x3F);
}

TEST(Topics, AreInTheOrderOfTheirEnum) {
  std::size_t i = 0;
  for (const TopicText& topic : topics()) EXPECT_EQ(static_cast<std::size_t>(topic.topic), i++);
}

}  // namespace
}  // namespace tp100::ros2
