#include "server/protocol.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/bytes.h"
#include "server/access.h"

namespace tp100::server {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;  // keeps the order; parsed, it would take too long

constexpr int kMaxDepth = 16;
constexpr std::size_t kMaxList = 1024;
constexpr std::size_t kMaxFieldName = 256;
constexpr std::uint8_t kClientData = 1, kServiceCall = 2;
constexpr std::uint8_t kMessageData = 1, kServiceResponse = 3;

struct Refused {
  std::string why;
};

std::optional<Json> parse(std::string_view text) {
  using Event = Json::parse_event_t;
  bool too_deep = false;
  const auto within_depth = [&](int depth, Event event, const Json&) {
    if (event == Event::object_start || event == Event::array_start)
      too_deep = too_deep || depth >= kMaxDepth;
    return !too_deep;
  };
  Json json = Json::parse(text, within_depth, false);
  if (too_deep || !json.is_object()) return std::nullopt;
  return json;
}

/// What `read` makes of each element of a list.
template <class Read>
auto all(const Json& json, const char* name, Read read) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array())
    throw Refused{std::string(name) + " must be a list"};
  if (found->size() > kMaxList) throw Refused{std::string(name) + " is too long"};
  std::vector<decltype(read(*found))> values;
  for (const Json& each : *found) values.push_back(read(each));
  return values;
}

std::uint32_t number(const Json& json) {
  if (!json.is_number_unsigned()) throw Refused{"an id must be a whole number"};
  const auto value = json.get<std::uint64_t>();
  if (value > std::numeric_limits<std::uint32_t>::max()) throw Refused{"an id is too large"};
  return static_cast<std::uint32_t>(value);
}

std::uint32_t number_of(const Json& json, const char* name) {
  if (!json.is_object() || !json.contains(name)) throw Refused{std::string(name) + " is missing"};
  return number(json[name]);
}

std::string text(const Json& json) {
  if (!json.is_string()) throw Refused{"a name must be a text"};
  const auto& value = json.get_ref<const std::string&>();
  if (value.size() > kMaxFieldName) throw Refused{"a name is too long"};
  return value;
}

std::string optional_text(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found == json.end() || found->is_null() ? std::string() : text(*found);
}

std::optional<messages::ParameterValue> parameter_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

NamedValue parameter(const Json& json) {
  if (!json.is_object()) throw Refused{"a parameter must be an object"};
  const auto value = json.find("value");
  return {optional_text(json, "name"),
          value == json.end() ? std::nullopt : parameter_value(*value)};
}

ClientMessage message(const Json& json) {
  const std::string op = optional_text(json, "op");
  const auto names = [&] { return all(json, "parameterNames", text); };
  if (op == "subscribe")
    return Subscribe{all(json, "subscriptions", [](const Json& each) {
      return Subscribe::One{number_of(each, "id"), number_of(each, "channelId"),
                            each.contains("interval_ms") ? number_of(each, "interval_ms") : 0};
    })};
  if (op == "unsubscribe") return Unsubscribe{all(json, "subscriptionIds", number)};
  if (op == "getParameters") return GetParameters{names(), optional_text(json, "id")};
  if (op == "setParameters")
    return SetParameters{all(json, "parameters", parameter), optional_text(json, "id")};
  if (op == "subscribeParameterUpdates") return ParameterSubscription{names(), true};
  if (op == "unsubscribeParameterUpdates") return ParameterSubscription{names(), false};
  for (const char* known : {"advertise", "unadvertise", "subscribeConnectionGraph",
                            "unsubscribeConnectionGraph", "fetchAsset"})
    if (op == known) return Unserved{op};
  return Malformed{"unknown op"};
}

std::string text_of(const Written& json) {
  return json.dump(-1, ' ', false, Written::error_handler_t::replace);
}

Written schema_of(const std::string& name, const std::string& schema) {
  return {{"encoding", "json"},
          {"schemaName", name},
          {"schemaEncoding", "jsonschema"},
          {"schema", schema}};
}

}  // namespace

std::string_view choose_sub_protocol(std::string_view offered) {
  const std::vector<std::string> names = words(offered);
  for (const std::string_view ours : {kNewSubProtocol, kOldSubProtocol})
    if (std::ranges::find(names, ours) != names.end()) return ours;
  return {};
}

ClientMessage parse_text(std::string_view text) {
  const std::optional<Json> json = parse(text);
  if (!json) return Malformed{"not a JSON object"};
  try {
    return message(*json);
  } catch (const Refused& refused) {
    return Malformed{refused.why};
  }
}

std::optional<std::uint32_t> call_of(std::uint32_t service, std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  if (in.number<std::uint8_t>() != kServiceCall || in.number<std::uint32_t>() != service ||
      !in.ok())
    return std::nullopt;
  return in.number<std::uint32_t>();
}

ClientMessage parse_binary(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Malformed{"an empty binary message"};
  if (bytes[0] == kClientData) return Unserved{"client message data"};
  if (bytes[0] != kServiceCall) return Malformed{"a binary message of an unknown kind"};
  ByteReader in(bytes.subspan(1));
  if (in.left() < 12) return Malformed{"a service call that is too short"};
  ServiceCall out;
  out.service = in.number<std::uint32_t>();
  out.call = in.number<std::uint32_t>();
  out.encoding = in.text();
  if (!in.ok()) return Malformed{"a service call whose encoding is cut off"};
  const auto payload = in.bytes(in.left());
  out.payload.assign(payload.begin(), payload.end());
  return out;
}

std::optional<std::vector<NamedValue>> parse_request(std::string_view text) {
  std::vector<NamedValue> fields;
  if (text.empty()) return fields;
  const std::optional<Json> json = parse(text);
  if (!json) return std::nullopt;
  for (const auto& [name, content] : json->items())
    fields.push_back({name, parameter_value(content)});
  return fields;
}

std::string server_info(std::string_view session_id,
                        std::initializer_list<std::pair<const char*, std::string_view>> metadata) {
  Written entries = Written::object();
  for (const auto& [name, value] : metadata) entries[name] = value;
  return text_of({{"op", "serverInfo"},
                  {"name", "tp100d"},
                  {"capabilities", {"parameters", "parametersSubscribe", "services"}},
                  {"supportedEncodings", Written::array({"json"})},
                  {"metadata", entries},
                  {"sessionId", session_id}});
}

std::string advertise(std::span<const messages::ChannelText> channels) {
  Written all = Written::array();
  for (const messages::ChannelText& channel : channels) {
    all.push_back({{"id", static_cast<std::uint32_t>(channel.channel)}, {"topic", channel.topic}});
    all.back().update(schema_of(channel.schema_name, channel.schema));
  }
  return text_of({{"op", "advertise"}, {"channels", all}});
}

std::string advertise_services(std::span<const ServiceText> services) {
  Written all = Written::array();
  for (const ServiceText& service : services)
    all.push_back({{"id", service.id},
                   {"name", service.name},
                   {"type", service.type},
                   // Both spellings that clients use.
                   {"requestSchema", service.request_schema},
                   {"responseSchema", service.response_schema},
                   {"request", schema_of(service.type + "Request", service.request_schema)},
                   {"response", schema_of(service.type + "Response", service.response_schema)}});
  return text_of({{"op", "advertiseServices"}, {"services", all}});
}

std::string status(StatusLevel level, std::string_view message) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}});
}

std::string parameter_values(std::span<const messages::ParameterText* const> parameters,
                             std::string_view id) {
  Written all = Written::array();
  for (const messages::ParameterText* parameter : parameters) {
    Written& one = all.emplace_back(Written{{"name", parameter->name}});
    std::visit([&](const auto& content) { one["value"] = content; }, parameter->value);
    // Declares that 16 may become 16.5.
    if (std::holds_alternative<double>(parameter->value)) one["type"] = "float64";
  }
  Written message = {{"op", "parameterValues"}, {"parameters", all}};
  if (!id.empty()) message["id"] = id;
  return text_of(message);
}

std::string service_failure(std::uint32_t service, std::uint32_t call, std::string_view message) {
  return text_of({{"op", "serviceCallFailure"},
                  {"serviceId", service},
                  {"callId", call},
                  {"message", message}});
}

MessageHead message_head(std::uint32_t subscription, std::uint64_t unix_ns) {
  MessageHead head{};
  head[0] = kMessageData;
  std::memcpy(head.data() + 1, &subscription, sizeof subscription);
  std::memcpy(head.data() + 5, &unix_ns, sizeof unix_ns);
  return head;
}

std::string service_response(std::uint32_t service, std::uint32_t call, std::string_view json) {
  Bytes bytes;
  ByteWriter out(bytes);
  out.number(kServiceResponse);
  out.number(service);
  out.number(call);
  out.text("json");
  out.bytes(bytes_of(json));
  return {bytes.begin(), bytes.end()};
}

}  // namespace tp100::server
