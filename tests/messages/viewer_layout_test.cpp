// The bundled layout for Lichtblick and Foxglove must refer only to published fields.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "fixtures.h"
#include "messages/channels.h"
#include "messages/foxglove.h"
#include "support/paths.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

Json bundled_layout() {
  std::ifstream file(source_path("config/lichtblick.json"));
  return Json::parse(file);
}

std::map<std::string, Json> schemas() {
  std::map<std::string, Json> by_topic;
  for (const ChannelText& text : channel_texts()) by_topic[text.topic] = Json::parse(text.schema);
  return by_topic;
}

/// The type of the value at a path such as /sample.gyro_radps[2], or why the path is wrong.
std::string type_at(const std::string& path) {
  static const std::map<std::string, Json> kSchemas = schemas();
  const std::size_t dot = std::min(path.find('.'), path.size());
  const auto topic = kSchemas.find(path.substr(0, dot));
  if (topic == kSchemas.end()) return "no such topic";
  Json at = topic->second;
  for (std::size_t begin = dot; begin < path.size();) {
    if (path[begin] == '[') {
      if (at["type"] != "array") return "not a list";
      at = Json(at["items"]);
      begin = path.find(']', begin) + 1;
      continue;
    }
    const std::size_t end = std::min(path.find_first_of(".[", begin + 1), path.size());
    const std::string field = path.substr(begin + 1, end - begin - 1);
    if (at["type"] != "object" || !at["properties"].contains(field)) return "no field " + field;
    at = Json(at["properties"][field]);
    begin = end;
  }
  return at["type"];
}

std::set<std::string> frames() {
  std::set<std::string> names;
  const Messages messages(example_subject(), example_clock());
  const Json transforms = Json::parse(transforms_text(messages, example_record(), Truth{}));
  for (const Json& each : transforms["transforms"]) {
    names.insert(each["parent_frame_id"]);
    names.insert(each["child_frame_id"]);
  }
  return names;
}

void collect_panels(const Json& layout, std::multiset<std::string>& panels) {
  if (layout.is_string()) {
    panels.insert(layout);
    return;
  }
  EXPECT_TRUE(layout["direction"] == "row" || layout["direction"] == "column") << layout;
  collect_panels(layout["first"], panels);
  collect_panels(layout["second"], panels);
}

void expect_scene(const std::string& panel, const Json& config) {
  const std::set<std::string> known = frames();
  EXPECT_TRUE(known.contains(config["followTf"])) << panel;
  for (const auto& [name, layer] : config["layers"].items())
    EXPECT_TRUE(known.contains(layer["frameId"])) << panel << " " << name;
  for (const auto& [name, settings] : config["transforms"].items())
    EXPECT_TRUE(known.contains(name.substr(std::string("frame:").size()))) << panel << " " << name;
  EXPECT_FALSE(config["topics"].empty());
  const std::map<std::string, Json> by_topic = schemas();
  for (const auto& [topic, settings] : config["topics"].items()) {
    ASSERT_TRUE(by_topic.contains(topic)) << panel << " " << topic;
    const std::string schema = by_topic.at(topic)["title"];
    EXPECT_TRUE(schema.starts_with("foxglove.")) << topic << " cannot be drawn: " << schema;
  }
}

void expect_published(const std::string& panel, const Json& config) {
  const std::string kind = panel.substr(0, panel.find('!'));
  if (kind == "3D") {
    expect_scene(panel, config);
  } else if (kind == "Plot" || kind == "StateTransitions") {
    EXPECT_FALSE(config["paths"].empty()) << panel;
    for (const Json& path : config["paths"])
      EXPECT_EQ(type_at(path["value"]), kind == "Plot" ? "number" : "string")
          << panel << " " << path["value"];
  } else if (kind == "Image") {
    EXPECT_EQ(type_at(config["imageMode"]["imageTopic"]), "object") << panel;
  } else if (kind == "RosOut") {
    EXPECT_EQ(type_at(config["topicToRender"]), "object") << panel;
  } else if (kind == "RawMessages") {
    EXPECT_EQ(type_at(config["topicPath"]), "object") << panel;
  } else {
    ADD_FAILURE() << panel << ": this test does not know what such a panel shows";
  }
}

TEST(ViewerLayout, NamesOnlyTopicsFieldsAndFramesThatArePublished) {
  const Json layout = bundled_layout();
  for (const auto& [panel, config] : layout["configById"].items()) expect_published(panel, config);
}

TEST(ViewerLayout, HasEachPanelOnce) {
  const Json layout = bundled_layout();
  std::multiset<std::string> placed, configured;
  collect_panels(layout["layout"], placed);
  for (const auto& [panel, config] : layout["configById"].items()) configured.insert(panel);
  EXPECT_EQ(placed, configured);
}

TEST(ViewerLayout, AWrongFieldIsFound) {
  EXPECT_EQ(type_at("/estimate.cross_track_m"), "number");
  EXPECT_EQ(type_at("/sample.gyro_radps[2]"), "number");
  EXPECT_EQ(type_at("/estimate.cross_track"), "no field cross_track");
  EXPECT_EQ(type_at("/estimate.tracks[0]"), "not a list");
  EXPECT_EQ(type_at("/estimates.cross_track_m"), "no such topic");
  EXPECT_EQ(type_at("/state.run.x"), "no field x");
}

}  // namespace
}  // namespace tp100::messages
