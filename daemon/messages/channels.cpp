#include "messages/channels.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/board.h"
#include "messages/foxglove.h"
#include "messages/messages.h"
#include "messages/parameter_text.h"
#include "messages/status_messages.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::ordered_json;

/// Adds what `more` has and `schema` lacks: some messages, and some elements of a list, have fewer
/// fields. Those that all have are required.
void merge(Json& schema, const Json& more) {
  if (schema.is_null()) schema = more;
  if (more.is_null() || schema["type"] != more["type"]) return;
  if (schema["type"] == "array") merge(schema["items"], more["items"]);
  if (schema["type"] != "object") return;
  for (const auto& [name, property] : more["properties"].items())
    merge(schema["properties"][name], property);
  Json required = Json::array();
  for (const Json& name : schema["required"])
    if (more["properties"].contains(name)) required.push_back(name);
  schema["required"] = required;
}

Json schema_of_value(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object: {
      Json properties = Json::object(), required = Json::array();
      for (const auto& [name, content] : value.items()) {
        properties[name] = schema_of_value(content);
        required.push_back(name);
      }
      return {{"type", "object"}, {"properties", properties}, {"required", required}};
    }
    case Json::value_t::array: {
      Json items;  // null: no element tells
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

/// Completes a schema: a list of which no element is known is one of objects. `required`: what all
/// examples have is, and is left out where nothing is.
void finish(Json& schema, bool required) {
  if (!required || schema["required"].empty()) schema.erase("required");
  if (schema["type"] == "array") {
    Json& items = schema["items"];
    if (items.is_null()) items = {{"type", "object"}, {"properties", Json::object()}};
    finish(items, required);
  } else if (schema["type"] == "object") {
    for (Json& property : schema["properties"]) finish(property, required);
  }
}

Json schema_json(const std::string& title, const std::vector<std::string>& examples,
                 bool required) {
  Json body;
  for (const std::string& example : examples) merge(body, schema_of_value(Json::parse(example)));
  finish(body, required);
  Json schema = {{"title", title}};
  schema.update(body);
  return schema;
}

template <class Names>
Json names_of(const Names& names) {
  Json all = Json::array();
  for (const auto& one : names) all.push_back(one.name);
  return all;
}

/// A field of a message with one of these values.
struct ChoiceField {
  const char* schema_name;
  std::vector<const char*> path;  ///< within the message; lists have no name
  Json values;
};

const std::vector<ChoiceField>& choice_fields() {
  static const std::vector<ChoiceField> fields = {
      {"tp100.Estimate", {"steering"}, names_of(kPoseSourceNames)},
      {"tp100.Estimate", {"pitch_source"}, names_of(kPitchSourceNames)},
      {"tp100.Estimate", {"imu", "slope"}, names_of(kSlopeNames)},
      {"tp100.Estimate", {"imu", "obstacle_class"}, names_of(kObstacleClassNames)},
      {"tp100.Estimate", {"terrain_contact", "obstacle"}, names_of(kObstacleClassNames)},
      {"tp100.Estimate", {"terrain_contact", "traction"}, names_of(kTractionNames)},
      {"tp100.Sample", {"state"}, names_of(kRobotStateNames)},
      {"tp100.Link", {"session"}, names_of(kSessionStateNames)},
      {"tp100.Link", {"quality"}, {"good", "poor", "lost"}},
      {"tp100.Link", {"kind"}, names_of(kRobotKindNames)},
      {"tp100.State", {"run"}, names_of(kRunStateNames)},
      {"tp100.State", {"session"}, names_of(kSessionStateNames)},
      {"tp100.State", {"robot_state"}, names_of(kRobotStateNames)},
      {"tp100.State", {"steering"}, names_of(kPoseSourceNames)},
      {"tp100.State", {"faults", "from"}, {"robot", "daemon"}},
      {"tp100.State", {"stop", "status"}, names_of(kStopStatusNames)},
      {"tp100.Event", {"level"}, names_of(kLevelNames)},
      {"tp100.ParameterList", {"parameters", "type"}, names_of(kParameterTypeNames)},
      {"tp100.ParameterList", {"parameters", "when"}, {"always", "not running"}},
  };
  return fields;
}

void set_choices(Json& schema, const ChoiceField& field) {
  Json* at = &schema;
  for (const char* name : field.path) {
    at = &at->at("properties").at(name);
    if (at->contains("items")) at = &at->at("items");
  }
  (*at)["enum"] = field.values;
}

// An older truth does not describe the present.
constexpr HostNs kTruthHoldsNs = kNsPerS;

/// Inputs of the messages of a step.
struct StepView {
  const Messages& messages;
  const StepRecord& record;
  const std::optional<Truth>& truth;
  bool truth_is_new;
};

/// A channel whose messages follow from steps.
struct StepChannel {
  Channel channel;
  std::string topic;
  const char* schema_name;
  std::size_t kept;
  HostNs period_ns;           ///< 0: every step
  HostNs recorded_period_ns;  ///< in a recording
  /// Its messages of one step.
  std::function<std::vector<std::string>(const StepView&)> texts;
};

std::vector<std::string> truth_text(const StepView& of) {
  if (!of.truth || !of.truth_is_new) return {};
  return {pose_text(of.messages, of.truth->at_ns, of.truth->pose)};
}

std::vector<std::string> sample_texts(const StepView& of) {
  std::vector<std::string> texts;
  for (std::uint32_t i = 0; i < of.record.inputs.samples.size(); ++i)
    texts.push_back(of.messages.sample(of.record.inputs.samples[i], of.record.now_ns));
  return texts;
}

std::vector<std::string> command_text(const StepView& of) {
  if (!of.record.command_valid) return {};
  return {of.messages.command(of.record)};
}

std::vector<StepChannel> make_step_channels() {
  // Every step is on /estimate; channels for 3-D display only need a display's rate.
  constexpr HostNs kPoses = 20 * kNsPerMs, kSlip = 50 * kNsPerMs;
  const char* const pose = "foxglove.PoseInFrame";
  std::vector<StepChannel> channels = {
      {Channel::kTransforms, "/tf", "foxglove.FrameTransforms", 0, 0, kPoses,
       [](const StepView& of) {
         return std::vector{transforms_text(of.messages, of.record, of.truth)};
       }},
      {Channel::kPoseTruth, "/pose/truth", pose, 0, 0, kPoses, truth_text},
      {Channel::kEstimate, "/estimate", "tp100.Estimate", 0, 0, 0,
       [](const StepView& of) { return std::vector{of.messages.estimate(of.record, of.truth)}; }},
      {Channel::kSample, "/sample", "tp100.Sample", 0, 0, 0, sample_texts},
      {Channel::kCommand, "/command", "tp100.Command", 0, 0, 0, command_text},
      {Channel::kSlip, "/slip", "tp100.Slip", 1, kSlip, kSlip,
       [](const StepView& of) { return std::vector{of.messages.slip(of.record)}; }},
  };
  for (const PoseSource source : kPoseSources) {
    channels.push_back({pose_channel(source), "/pose/" + std::string(to_string(source)), pose, 0, 0,
                        kPoses, [source](const StepView& of) {
                          const Pose& at = of.record.snapshot.estimates[source].pose;
                          return std::vector{pose_text(of.messages, of.record.now_ns, at)};
                        }});
  }
  return channels;
}

const std::vector<StepChannel>& step_channels() {
  static const std::vector<StepChannel> channels = make_step_channels();
  return channels;
}

/// A course with one element in each list.
std::shared_ptr<const course::Course> full_course() {
  course::Course course;
  course.name = "example";
  course.path = {course::Line{0.1}};
  course.disturbances = {{.at_m = 0.1, .sideways_m = 0.01, .yaw_rad = 0.1, .duration_s = 0.1}};
  course.terrain.obstacles = {
      course::Block{.place = {}, .height_m = 0.1, .depth_m = 0.1, .width_m = 0.4}};
  course.terrain.surfaces = {{.name = "ice", .place = {}, .length_m = 0.1, .width_m = 0.1}};
  course.fence = {-1, 1, -1, 1, {}, {{{0, 0}, {1, 0}, {0, 1}}}};
  return std::make_shared<const course::Course>(std::move(course));
}

/// A record with every value known and none null.
StepRecord full_record() {
  StepRecord record;
  record.command_valid = true;
  record.inputs.clock.valid = true;
  Sample sample;
  sample.faults = fault_bit(Fault::stop_requested);
  record.inputs.samples.push(sample);
  record.snapshot.has_sample = true;
  record.snapshot.sample = sample;
  record.snapshot.filter.camera_age_us = 1;
  return record;
}

/// A record of which as little as possible is known; of a command, only that there is one.
StepRecord least_record(Channel channel) {
  StepRecord record;
  record.command_valid = channel == Channel::kCommand;
  record.inputs.samples.push({});
  return record;
}

StateFigures full_state() {
  StateFigures state;
  state.robot = RobotState::kArmed;
  state.run_s = 0.5;
  state.length_m = 0.5;
  state.pose = Pose{};
  state.start_places.unsaid = StartRefusal::kWhere;
  state.onward_m = 0.5;
  state.battery_v = 7.5;
  state.pause_left_s = 0.5;
  state.driver = {.by = "viewer 3", .asked_by = "viewer 4"};
  state.faults = fault_bit(Fault::stop_requested);
  state.stop.count = 1;
  state.stop.status = StopFigures::Status::kAcknowledged;
  return state;
}

/// Drops values that may be number, string or boolean: viewers' schema readers have no such type.
void drop_values(Json& schema) {
  Json& parameter = schema["properties"]["parameters"]["items"];
  for (const char* name : {"value", "default"}) {
    parameter["properties"].erase(name);
    Json& required = parameter["required"];
    required.erase(std::find(required.begin(), required.end(), name));
  }
}

/// Whether a schema is ours, and so tells what is required and which names a text may be.
bool is_ours(std::string_view schema_name) { return schema_name.starts_with("tp100."); }

/// `examples`: one with every field; of our own schemas also such as lack what may be left out.
std::string channel_schema(const std::string& name, const std::vector<std::string>& examples) {
  Json schema = schema_json(name, examples, is_ours(name));
  for (const ChoiceField& field : choice_fields())
    if (name == field.schema_name) set_choices(schema, field);
  if (name == "tp100.ParameterList") drop_values(schema);
  return schema.dump();
}

}  // namespace

std::string schema_of(const std::string& title, const std::string& example) {
  return schema_json(title, {example}, false).dump();
}

void StepMessages::take(const StepRecord& record, const Wanted& wanted, const Send& send) {
  if (truth_ && record.now_ns - truth_->at_ns > kTruthHoldsNs) truth_.reset();
  const StepView view{messages_, record, truth_, truth_is_new_};
  for (const StepChannel& channel : step_channels()) {
    HostNs& due_ns = due_ns_[static_cast<std::uint32_t>(channel.channel) - 1];
    if (record.now_ns < due_ns || !wanted(channel.channel)) continue;
    due_ns = record.now_ns + (recorded_ ? channel.recorded_period_ns : channel.period_ns);
    for (std::string& text : channel.texts(view))
      send(channel.channel, record.now_ns, std::move(text));
    if (channel.channel == Channel::kPoseTruth) truth_is_new_ = false;
  }
}

SharedMessages setup_messages(const Messages& messages, HostNs at) {
  const auto shared = [](std::string text) {
    return std::make_shared<const std::string>(std::move(text));
  };
  return {{Channel::kCourse, shared(messages.course())},
          {Channel::kPath, shared(path_text(messages, at))},
          {Channel::kScene, shared(scene_text(messages, at))}};
}

std::vector<ChannelText> channel_texts() {
  RunContext run_context;
  run_context.course = full_course();
  const Messages messages(run_context, {}), empty({}, {});
  const std::optional<Truth> truth = Truth{}, no_truth;
  LinkFigures link;
  link.clock.valid = true;
  link.port.firmware = "0.1.0";
  ClientsFigures clients;
  clients.clients.emplace_back();
  using ParameterList = std::vector<ParameterText>;
  const ParameterList number{{{.name = "a", .choices = {"b"}}}},
      text{{{.type = ParameterText::Type::kText}}};

  std::vector<ChannelText> texts(kChannelCount);
  const auto add = [&](Channel channel, const std::string& topic, const char* schema_name,
                       const std::vector<std::string>& examples, std::size_t kept) {
    texts.at(static_cast<std::uint32_t>(channel) - 1) = {
        channel, topic, schema_name, channel_schema(schema_name, examples), kept};
  };
  for (const StepChannel& one : step_channels()) {
    std::vector<std::string> examples = one.texts({messages, full_record(), truth, true});
    if (is_ours(one.schema_name))
      examples.push_back(one.texts({empty, least_record(one.channel), no_truth, false}).front());
    add(one.channel, one.topic, one.schema_name, examples, one.kept);
  }
  const std::string scene = scene_text(messages, 0);
  add(Channel::kPath, "/path", "foxglove.PosesInFrame", {path_text(messages, 0)}, 1);
  add(Channel::kScene, "/scene", "foxglove.SceneUpdate", {scene}, 1);
  add(Channel::kPathHistory, "/path_history", "foxglove.SceneUpdate", {scene}, 0);
  add(Channel::kLog, "/log", "foxglove.Log", {log_text(messages, {})}, 100);
  add(Channel::kLink, "/link", "tp100.Link", {link_message(0.5, link), link_message(0.5, {})}, 1);
  add(Channel::kLoop, "/loop", "tp100.Loop", {loop_message(0.5, {}, run_context)}, 1);
  StateFigures driven;
  driven.driver.by = "viewer 3";
  add(Channel::kState, "/state", "tp100.State",
      {state_message(0, {}, full_state(), run_context), state_message(0, {}, driven, {}),
       state_message(0, {}, {}, {})},
      1);
  add(Channel::kCourse, "/course", "tp100.Course", {messages.course(), empty.course()}, 1);
  add(Channel::kEvent, "/event", "tp100.Event", {messages.event({})}, 100);
  add(Channel::kParameter, "/parameter", "tp100.ParameterList",
      {parameters_message(number), parameters_message(text)}, 1);
  add(Channel::kRecording, "/recording", "tp100.Recording", {recording_message({})}, 1);
  add(Channel::kCameraImage, "/camera/image", "foxglove.CompressedImage",
      {image_text(messages, 0, "\xff")}, 1);
  add(Channel::kClient, "/client", "tp100.ClientList",
      {clients_message(clients), clients_message({})}, 1);
  return texts;
}

}  // namespace tp100::messages
