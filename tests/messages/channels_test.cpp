// The channels: their numbers, and schemas that describe every message.

#include "messages/channels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <utility>
#include <vector>

#include "fixtures.h"
#include "messages/foxglove.h"
#include "messages/status_messages.h"
#include "support/accepted.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

// Expects only what the viewers' readers accept: objects, and arrays of objects or plain values.
void expect_readable(const Json& schema, const std::string& where, bool in_array) {
  ASSERT_TRUE(schema.contains("type")) << where;
  const std::string type = schema["type"];
  if (type == "object") {
    ASSERT_TRUE(schema["properties"].is_object()) << where;
    for (const auto& [name, property] : schema["properties"].items())
      expect_readable(property, where + "." + name, false);
  } else if (type == "array") {
    EXPECT_FALSE(in_array) << where;
    // An example with an empty array would not tell what is in it. Foxglove's own entities have
    // shapes that ours never use.
    const Json nothing = {{"type", "object"}, {"properties", Json::object()}};
    EXPECT_TRUE(where.find(".entities[].") != where.npos || schema["items"] != nothing) << where;
    expect_readable(schema["items"], where + "[]", true);
  } else {
    EXPECT_TRUE(type == "string" || type == "number" || type == "boolean") << where;
  }
}

// Expects that the schema describes all fields of `message`, and that the message validates; with
// numbers that are unknown it may lack what is required.
void expect_described(const Json& schema, const Json& message, const std::string& where,
                      bool complete) {
  const std::string type = schema["type"];
  EXPECT_TRUE(type == message.type_name())
      << where << " is " << message << ", not of type " << type;
  if (schema.contains("enum")) {
    EXPECT_NE(std::ranges::find(schema["enum"], message), schema["enum"].end())
        << where << " is " << message << ", which is none of " << schema["enum"];
  }
  if (complete && schema.contains("required")) {
    for (const std::string name : schema["required"])
      EXPECT_TRUE(message.contains(name)) << where << "." << name;
  }
  if (schema["type"] == "object") {
    for (const auto& [name, content] : message.items()) {
      ASSERT_TRUE(schema["properties"].contains(name)) << where << "." << name;
      expect_described(schema["properties"][name], content, where + "." + name, complete);
    }
  } else if (schema["type"] == "array") {
    for (const Json& element : message)
      expect_described(schema["items"], element, where + "[]", complete);
  }
}

TEST(Channels, IdsFollowTheOrderOfTheTable) {
  const auto texts = channel_texts();
  ASSERT_EQ(texts.size(), kChannelCount);
  std::set<std::string> topics;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(static_cast<std::uint32_t>(texts[i].channel), i + 1);
    EXPECT_TRUE(topics.insert(texts[i].topic).second);
  }
  EXPECT_EQ(texts.back().topic, "/client");
  EXPECT_EQ(static_cast<std::uint32_t>(Channel::kClient), kChannelCount);
}

TEST(Channels, SchemaReadersOfViewersTakeEverySchema) {
  std::map<std::string, std::string> by_name;
  for (const ChannelText& text : channel_texts()) {
    const Json schema = Json::parse(text.schema);
    EXPECT_EQ(schema["title"], text.schema_name);
    EXPECT_EQ(schema["type"], "object");
    expect_readable(schema, text.topic, false);
    // A schema name stands for one schema only.
    const auto [at, fresh] = by_name.emplace(text.schema_name, text.schema);
    EXPECT_TRUE(fresh || at->second == text.schema) << text.topic;
    if (text.topic != "/parameter") continue;
    // The type of a parameter's value depends on the parameter.
    const Json& parameter = schema["properties"]["parameters"]["items"]["properties"];
    EXPECT_TRUE(parameter.contains("name") && !parameter.contains("value"));
    EXPECT_FALSE(parameter.contains("default"));
  }
}

TEST(Channels, MessagesHaveNoFieldThatTheirSchemaDoesNotName) {
  const Messages messages(example_subject(), example_clock());
  const StepRecord record = example_record();
  // Neither a sample, a course, a truth, a robot nor a finite number.
  StepRecord nothing;
  nothing.snapshot.cross_track_m = nothing.snapshot.estimates[PoseSource::kModel].pose.x_m =
      nothing.snapshot.estimates[PoseSource::kFused].covariance.xx =
          std::numeric_limits<double>::quiet_NaN();
  const Messages without({}, {});
  StateFigures paused, driven, asked;
  paused.pause_left_s = 3.0;
  driven.driver.by = asked.driver.by = "viewer 3";
  asked.driver.asked_by = "viewer 4";
  asked.faults = fault_bit(Fault::stop_requested);
  LinkFigures identified;
  identified.port.firmware = "0.1.0";
  ClientsFigures clients;
  clients.clients.emplace_back();
  const std::vector<std::pair<std::string, std::string>> examples = {
      {"/tf", transforms_text(messages, record, std::nullopt)},
      {"/pose/model", pose_text(messages, 0, {})},
      {"/path", path_text(messages, 0)},
      {"/scene", scene_text(messages, 0)},
      {"/log", log_text(messages, {})},
      {"/estimate", messages.estimate(record, std::nullopt)},
      {"/sample", messages.sample(record.snapshot.sample, 0)},
      {"/command", messages.command(record)},
      {"/slip", messages.slip(record)},
      {"/course", messages.course()},
      {"/state", state_message(0, {}, {}, example_subject())},
      {"/state", state_message(0, {}, paused, example_subject())},
      {"/state", state_message(0, {}, driven, example_subject())},
      {"/state", state_message(0, {}, asked, {})},
      {"/link", link_message(0.5, identified)},
      {"/client", clients_message(clients)},
      {"/sample", without.sample({}, 0)},
      {"/command", without.command(nothing)},
      {"/slip", without.slip(nothing)},
      {"/event", messages.event({})},
      {"/link", link_message(0.5, {})},
      {"/loop", loop_message(0.5, {}, {})},
      {"/recording", recording_message({})},
      {"/client", clients_message({})},
      {"/course", without.course()},
      {"/state", state_message(0, {}, {}, {})},
  };
  const std::vector<std::pair<std::string, std::string>> unknown = {
      {"/estimate", without.estimate(nothing, std::nullopt)},
  };
  std::map<std::string, Json> schemas;
  for (const ChannelText& text : channel_texts()) schemas[text.topic] = Json::parse(text.schema);
  for (const auto& [topic, message] : examples)
    expect_described(schemas.at(topic), Json::parse(message), topic, true);
  for (const auto& [topic, message] : unknown)
    expect_described(schemas.at(topic), Json::parse(message), topic, false);
}

// Whoever reads messages in another language makes types of this file; the page does.
TEST(Channels, SchemasStandInAFileForClients) {
  std::string text;
  for (const ChannelText& channel : channel_texts())
    text += (text.empty() ? "{\n" : ",\n") + Json(channel.topic).dump() + ": " + channel.schema;
  test::expect_accepted("daemon/messages/schemas.json", text + "\n}\n");
}

// Topic, schema and what is kept are the code's; the rate is written by hand, for a new channel
// first as that of most of them.
TEST(Channels, StandInThePagesTable) {
  const std::string path = "daemon/messages/CHANNELS.md";
  const std::string head = "| Topic | Schema name | Rate | Kept |\n|---|---|---|---|\n";
  const std::string page = test::read_bytes(source_path(path));
  ASSERT_NE(page.find(head), page.npos);
  const std::size_t begin = page.find(head) + head.size(), end = page.find("\n\n", begin) + 1;
  const std::string table = page.substr(begin, end - begin);
  std::map<std::string, std::string> rates;
  const std::regex row(R"(\| `(\S+)` \| `\S+` \| (.*?) \|.*\n)");
  for (std::sregex_iterator at(table.begin(), table.end(), row), none; at != none; ++at)
    rates[(*at)[1]] = (*at)[2];
  std::string rows;
  for (const ChannelText& text : channel_texts()) {
    const std::string& rate = rates.try_emplace(text.topic, "step").first->second;
    // A newcomer gets the path so far as one message, made for it.
    const bool kept = text.kept > 0 || text.channel == Channel::kPathHistory;
    rows += "| `" + text.topic + "` | `" + text.schema_name + "` | " + rate +
            (kept ? " | yes |\n" : " | |\n");
  }
  test::expect_accepted(path, page.substr(0, begin) + rows + page.substr(end));
}

// 40 steps of 5 ms with two samples each. A recording holds every step itself, and so needs poses
// at a display's rate only.
TEST(StepMessages, SendEachSampleAndATruthOnceAndFewerPosesToARecording) {
  const Messages messages(example_subject(), example_clock());
  for (const bool recorded : {false, true}) {
    StepMessages step_messages(messages, recorded);
    std::map<Channel, std::vector<Json>> sent;
    StepRecord record = example_record();
    step_messages.take_truth({record.now_ns, {.x_m = 0.44}});
    for (std::uint16_t i = 0; i < 40; ++i) {
      record.now_ns += 5 * kNsPerMs;
      Sample samples[2];
      samples[0].sequence = static_cast<std::uint16_t>(2 * i);
      samples[1].sequence = static_cast<std::uint16_t>(2 * i + 1);
      record.inputs.samples.assign(samples);
      step_messages.take(
          record, [](Channel channel) { return channel != Channel::kCommand; },
          [&](Channel channel, HostNs at, const std::string& json) {
            EXPECT_EQ(at, record.now_ns);
            sent[channel].push_back(Json::parse(json));
          });
    }
    ASSERT_EQ(sent[Channel::kSample].size(), 80U);
    for (std::size_t i = 0; i < 80; ++i) EXPECT_EQ(sent[Channel::kSample][i]["sequence"], i);
    EXPECT_EQ(sent[Channel::kEstimate].size(), 40U);
    EXPECT_EQ(sent[Channel::kSlip].size(), 4U);
    EXPECT_EQ(sent[Channel::kTransforms].size(), recorded ? 10U : 40U);
    EXPECT_EQ(sent[pose_channel(PoseSource::kFused)].size(), recorded ? 10U : 40U);
    EXPECT_EQ(sent[Channel::kPoseTruth].size(), 1U);
    EXPECT_TRUE(sent[Channel::kCommand].empty()) << "nobody wants it";
  }
}

}  // namespace
}  // namespace tp100::messages
