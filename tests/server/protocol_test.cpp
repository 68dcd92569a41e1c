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

TEST(ParseText, TakesEveryMessageThatItServes) {
  const auto subscribe = std::get<Subscribe>(parse_text(
      R"({"op":"subscribe","subscriptions":[{"id":7,"channelId":3},{"id":8,"channelId":4}]})"));
  ASSERT_EQ(subscribe.subscriptions.size(), 2U);
  EXPECT_EQ(subscribe.subscriptions[1].subscription, 8U);
  EXPECT_EQ(subscribe.subscriptions[1].channel, 4U);
  EXPECT_THAT(std::get<Unsubscribe>(parse_text(R"({"op":"unsubscribe","subscriptionIds":[7,8]})"))
                  .subscriptions,
              ElementsAre(7U, 8U));
  const auto get = std::get<GetParameters>(
      parse_text(R"({"op":"getParameters","parameterNames":["a"],"id":"x"})"));
  EXPECT_THAT(get.names, ElementsAre("a"));
  EXPECT_EQ(get.id, "x");
  const auto set = std::get<SetParameters>(parse_text(
      R"({"op":"setParameters","parameters":[{"name":"a","value":1.5},{"name":"b","value":true},)"
      R"({"name":"c","value":"d"},{"name":"e","value":[1]},{"name":"f"}]})"));
  ASSERT_EQ(set.parameters.size(), 5U);
  EXPECT_EQ(set.parameters[0].value, messages::ParameterValue(1.5));
  EXPECT_EQ(set.parameters[1].value, messages::ParameterValue(true));
  EXPECT_EQ(set.parameters[2].value, messages::ParameterValue(std::string("d")));
  EXPECT_FALSE(set.parameters[3].value.has_value());
  EXPECT_FALSE(set.parameters[4].value.has_value());
  EXPECT_TRUE(std::get<ParameterSubscription>(
                  parse_text(R"({"op":"subscribeParameterUpdates","parameterNames":[]})"))
                  .watch);
  // Valid, but of no use here.
  EXPECT_EQ(std::get<Unserved>(parse_text(R"({"op":"fetchAsset","uri":"x","requestId":1})")).what,
            "fetchAsset");
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
  EXPECT_TRUE(malformed(parse_text("{\"op\":" + std::string(30'000, '['))));
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

TEST(ParseRequest, AnEmptyOneIsAnEmptyObject) {
  EXPECT_TRUE(parse_request("")->empty());
  EXPECT_TRUE(parse_request("{}")->empty());
  EXPECT_FALSE(parse_request("[]").has_value());
  EXPECT_EQ(parse_request(R"({"name":"x","more":{}})")->size(), 2U);
}

TEST(ServerMessages, HeadsAreLittleEndian) {
  EXPECT_THAT(message_head(0x01020304, 0x1112131415161718),
              ElementsAre(1, 4, 3, 2, 1, 0x18, 0x17, 0x16, 0x15, 0x14, 0x13, 0x12, 0x11));
  EXPECT_THAT(
      bytes(service_response(2, 0x0A0B0C0D, "{}")),
      ElementsAre(3, 2, 0, 0, 0, 0x0D, 0x0C, 0x0B, 0x0A, 4, 0, 0, 0, 'j', 's', 'o', 'n', '{', '}'));
}

TEST(ServerMessages, EveryTextIsJsonWithItsOp) {
  const std::vector<Metadata> metadata = {{"a\"", "b"}};
  const std::vector<ServiceText> services = {{1, "stop", "tp100.Stop", "{}", "{}"}};
  const messages::ParameterText parameter{{.name = "a", .value = 16.0}};
  const std::vector<const messages::ParameterText*> parameters = {&parameter};
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"serverInfo", server_info("id", metadata)},
      {"advertise", advertise(messages::channel_texts())},
      {"advertiseServices", advertise_services(services)},
      {"status", status(StatusLevel::kWarning, "\"\n")},
      {"parameterValues", parameter_values(parameters, "x")},
      {"serviceCallFailure", service_failure(1, 2, "no")}};
  for (const auto& [op, text] : texts) EXPECT_EQ(Json::parse(text)["op"], op);
}

}  // namespace
}  // namespace tp100::server
