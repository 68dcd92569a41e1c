#include "server/protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tp100::server {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;

std::vector<std::uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

bool malformed(const ClientMessage& message) { return std::holds_alternative<Malformed>(message); }

TEST(SubProtocol, TheNewNameIsPreferredAndTheOldOneTaken) {
  EXPECT_EQ(choose_sub_protocol("foxglove.websocket.v1"), kOldSubProtocol);
  EXPECT_EQ(choose_sub_protocol("foxglove.websocket.v1, foxglove.sdk.v1"), kNewSubProtocol);
  EXPECT_EQ(choose_sub_protocol("chat ,\tfoxglove.sdk.v1"), kNewSubProtocol);
  for (const char* none : {"", ",", "foxglove.sdk.v2", "foxglove.sdk.v1x", "xfoxglove.sdk.v1"})
    EXPECT_EQ(choose_sub_protocol(none), "") << none;
}

TEST(ParseText, RefusesWhatIsNotTheProtocol) {
  for (const char* text :
       {"", "null", "[]", "{", "{}", R"({"op":1})", R"({"op":"dance"})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":{}})", R"({"op":"subscribe","subscriptions":[1]})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})",
        R"({"op":"getParameters","parameterNames":[1]})",
        R"({"op":"setParameters","parameters":[1]})",
        R"({"op":"setParameters","parameters":[{"name":"a","value":1e999}]})",
        "{\"op\":\"getParameters\",\"parameterNames\":[\"\xff\"]}"})
    EXPECT_TRUE(malformed(parse_text(text))) << text;
}

TEST(ParseText, DepthIsBounded) {
  const auto nested = [](std::size_t depth) {
    return R"({"op":"fetchAsset","x":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
  };
  EXPECT_FALSE(malformed(parse_text(nested(15))));
  EXPECT_TRUE(malformed(parse_text(nested(16)))) << "with the object these are 17";
  // Brackets within a string do not count.
  EXPECT_FALSE(malformed(
      parse_text(R"({"op":"getParameters","parameterNames":["[[[[[[[[[[[[[[[[[\"[["]})")));
}

TEST(ParseBinary, AServiceCallComesApart) {
  std::vector<std::uint8_t> data = {2, 3, 0, 0, 0, 0x78, 0x56, 0x34, 0x12, 4, 0, 0, 0};
  for (const char c : std::string("json{}")) data.push_back(static_cast<std::uint8_t>(c));
  const auto call = std::get<ServiceCall>(parse_binary(data));
  EXPECT_EQ(call.service, 3U);
  EXPECT_EQ(call.call, 0x12345678U);
  EXPECT_EQ(call.encoding, "json");
  EXPECT_EQ(call.payload, "{}");
}

TEST(ParseBinary, LengthsThatLieAreRefused) {
  EXPECT_TRUE(malformed(parse_binary({})));
  EXPECT_TRUE(malformed(parse_binary(bytes("\x09"))));
  const std::vector<std::uint8_t> whole = {2, 3, 0, 0, 0, 1, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 'j'};
  for (std::size_t n = 0; n <= whole.size(); ++n)
    EXPECT_TRUE(malformed(parse_binary(std::span(whole).first(n)))) << n;
}

TEST(ServerMessages, HeadsAreLittleEndian) {
  EXPECT_THAT(message_head(0x01020304, 0x1112131415161718),
              ElementsAre(1, 4, 3, 2, 1, 0x18, 0x17, 0x16, 0x15, 0x14, 0x13, 0x12, 0x11));
  EXPECT_THAT(
      bytes(service_response(2, 0x0A0B0C0D, "{}")),
      ElementsAre(3, 2, 0, 0, 0, 0x0D, 0x0C, 0x0B, 0x0A, 4, 0, 0, 0, 'j', 's', 'o', 'n', '{', '}'));
}

}  // namespace
}  // namespace tp100::server
