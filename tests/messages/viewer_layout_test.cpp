// The bundled layout for Lichtblick and Foxglove must refer only to published fields.

#include <gtest/gtest.h>

#include <fstream>
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

/// The schema of the value at a path such as /sample.gyro_radps[2]; null if there is no such value.
Json schema_at(const std::string& path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  Json at;
  for (const ChannelText& text : channel_texts())
    if (text.topic == path.substr(0, dot)) at = Json::parse(text.schema);
  for (std::size_t begin = dot; begin < path.size() && !at.is_null();) {
    if (path[begin] == '[') {
      at = at.value("items", Json());
      begin = path.find(']', begin) + 1;
      continue;
    }
    const std::size_t end = std::min(path.find_first_of(".[", begin + 1), path.size());
    at = at.value("properties", Json::object())
             .value(path.substr(begin + 1, end - begin - 1), Json());
    begin = end;
  }
  return at;
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

/// Expects of all paths and frames in a panel's configuration that they are published, and of the
/// values that such a panel can show them.
void expect_published(const std::string& panel, const Json& part) {
  if (part.is_string() && part.get<std::string>().starts_with("/")) {
    const std::string type = panel.starts_with("Plot!")   ? "number"
                             : panel.starts_with("State") ? "string"
                                                          : "object";
    EXPECT_EQ(schema_at(part).value("type", "nothing"), type) << panel << " " << part;
  }
  if (!part.is_structured()) return;
  static const std::set<std::string> kFrames = frames();
  for (const auto& [key, inside] : part.items()) {
    if (key == "followTf" || key == "frameId") {
      EXPECT_TRUE(kFrames.contains(inside)) << panel;
    } else if (key.starts_with("frame:")) {
      EXPECT_TRUE(kFrames.contains(key.substr(6))) << panel << key;
    } else if (key.starts_with("/")) {
      EXPECT_TRUE(schema_at(key).value("title", "").starts_with("foxglove.")) << panel << key;
    }
    expect_published(panel, inside);
  }
}

TEST(ViewerLayout, HasEachPanelOnceWithTopicsFieldsAndFramesThatArePublished) {
  const Json layout = Json::parse(std::ifstream(source_path("config/lichtblick.json")));
  std::multiset<std::string> placed, configured;
  collect_panels(layout["layout"], placed);
  for (const auto& [panel, config] : layout["configById"].items()) {
    configured.insert(panel);
    expect_published(panel, config);
  }
  EXPECT_EQ(placed, configured);
}

}  // namespace
}  // namespace tp100::messages
