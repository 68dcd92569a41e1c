#include "messages/channels.h"

#include <nlohmann/json.hpp>

#include "messages/messages.h"
#include "messages/parameter_text.h"
#include "messages/status_messages.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::ordered_json;

/// Adds what `more` has and `schema` lacks: some elements of a list may have fewer fields.
void merge(Json& schema, const Json& more) {
  if (schema["type"] != more["type"]) return;
  if (schema["type"] == "array") merge(schema["items"], more["items"]);
  if (schema["type"] != "object") return;
  for (const auto& [name, property] : more["properties"].items()) {
    Json& known = schema["properties"][name];
    if (known.is_null()) {
      known = property;
    } else {
      merge(known, property);
    }
  }
}

Json schema_of_value(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object: {
      Json properties = Json::object();
      for (const auto& [name, content] : value.items()) properties[name] = schema_of_value(content);
      return {{"type", "object"}, {"properties", properties}};
    }
    case Json::value_t::array: {
      Json items = schema_of_value(value.empty() ? Json::object() : value.front());
      for (const Json& element : value) merge(items, schema_of_value(element));
      return {{"type", "array"}, {"items", items}};
    }
    case Json::value_t::boolean:
      return {{"type", "boolean"}};
    case Json::value_t::string:
      return {{"type", "string"}};
    default:
      // 0.0 is written as 0, so that an example cannot distinguish integers from doubles.
      return {{"type", "number"}};
  }
}

/// A course with one element of each kind.
std::shared_ptr<const course::Course> full_course() {
  course::Course course;
  course.name = "example";
  course.path = {course::Line{0.1}};
  course.disturbances = {{.at_m = 0.1, .sideways_m = 0.01, .yaw_rad = 0.1, .duration_s = 0.1}};
  course.terrain.ramps = {
      {.place = {}, .height_m = 0.1, .up_rad = 0.5, .top_m = 0.1, .down_rad = 0.5, .width_m = 0.4}};
  course.terrain.blocks = {{.place = {}, .height_m = 0.1, .depth_m = 0.1, .width_m = 0.4}};
  course.terrain.surfaces = {{.name = "ice", .place = {}, .length_m = 0.1, .width_m = 0.1}};
  course.fence = {-1, 1, -1, 1};
  return std::make_shared<const course::Course>(std::move(course));
}

/// A record with every value known and none null.
StepRecord full_record() {
  StepRecord record;
  record.command_valid = true;
  record.inputs.clock.valid = true;
  record.snapshot.has_sample = true;
  record.snapshot.sample.faults = fault_bit(Fault::stop_requested);
  record.snapshot.filter.camera_age_us = 1;
  return record;
}

StateFigures full_state() {
  StateFigures state;
  state.robot = RobotState::kArmed;
  state.run_s = 0.5;
  state.length_m = 0.5;
  state.battery_v = 7.5;
  state.faults = fault_bit(Fault::stop_requested);
  state.stop.count = 1;
  state.stop.status = StopFigures::Status::kAcknowledged;
  return state;
}

/// Drops values that may be number, string or boolean: viewers' schema readers have no such type.
std::string without_values(const std::string& text) {
  Json schema = Json::parse(text);
  Json& parameter = schema["properties"]["parameters"]["items"]["properties"];
  for (const char* name : {"value", "default"}) parameter.erase(name);
  return schema.dump();
}

}  // namespace

std::string schema_of(const std::string& title, const std::string& example) {
  Json schema = {{"title", title}};
  schema.update(schema_of_value(Json::parse(example)));
  return schema.dump();
}

std::vector<ChannelText> channel_texts() {
  RunContext run_context;
  run_context.course = full_course();
  const Messages messages(run_context, {});
  const StepRecord record = full_record();
  const std::optional<Truth> truth = Truth{};
  const Sample& sample = record.snapshot.sample;
  LinkFigures link;
  link.clock.valid = true;
  link.port.firmware = "0.1.0";
  const std::string pose = messages.pose(0, {});
  const std::string scene = messages.scene(0);

  std::vector<ChannelText> texts;
  const auto add = [&](const char* topic, const char* schema_name, const std::string& example,
                       std::size_t kept) {
    texts.push_back({static_cast<Channel>(texts.size() + 1), topic, schema_name,
                     schema_of(schema_name, example), kept});
  };
  add("/tf", "foxglove.FrameTransforms", messages.transforms(record, truth), 0);
  for (const char* topic : {"/pose/model", "/pose/odometry", "/pose/fused", "/pose/truth"})
    add(topic, "foxglove.PoseInFrame", pose, 0);
  add("/path", "foxglove.PosesInFrame", messages.path_poses(0), 1);
  add("/scene", "foxglove.SceneUpdate", scene, 1);
  add("/path_history", "foxglove.SceneUpdate", scene, 0);
  add("/log", "foxglove.Log", messages.log({}), 100);
  add("/estimate", "tp100.Estimate", messages.estimate(record, truth), 0);
  add("/sample", "tp100.Sample", messages.sample(sample, 0), 0);
  add("/command", "tp100.Command", messages.command(record), 0);
  add("/slip", "tp100.Slip", messages.slip(record), 1);
  add("/link", "tp100.Link", link_message(0.5, link), 1);
  add("/loop", "tp100.Loop", loop_message(0.5, {}, run_context), 1);
  add("/state", "tp100.State", state_message(0, {}, full_state(), run_context), 1);
  add("/course", "tp100.Course", messages.course(), 1);
  add("/event", "tp100.Event", messages.event({}), 100);
  add("/parameter", "tp100.ParameterList", parameters_message({{{.name = "a", .choices = {"b"}}}}),
      1);
  texts.back().schema = without_values(texts.back().schema);
  add("/recording", "tp100.Recording", recording_message({}), 1);
  ClientsFigures clients;
  clients.clients.emplace_back();
  add("/client", "tp100.ClientList", clients_message(clients), 1);
  return texts;
}

}  // namespace tp100::messages
