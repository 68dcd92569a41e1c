#include "server/protocol.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace tp100::server {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;  // keeps the order; parsed, it would take too long

constexpr std::size_t kMaxDepth = 16;
constexpr std::size_t kMaxList = 1024;
constexpr std::size_t kMaxFieldName = 256;
constexpr std::uint8_t kClientData = 1, kServiceCall = 2;
constexpr std::uint8_t kMessageData = 1, kServiceResponse = 3;

struct Refused {
  std::string why;
};

/// Whether brackets outside of strings are nested too deeply.
bool too_deep(std::string_view text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) return true;
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

std::optional<Json> parse(std::string_view text) {
  if (too_deep(text)) return std::nullopt;
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return std::nullopt;
  return json;
}

const Json& list(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array())
    throw Refused{std::string(name) + " must be a list"};
  if (found->size() > kMaxList) throw Refused{std::string(name) + " is too long"};
  return *found;
}

std::uint32_t number(const Json& json) {
  if (!json.is_number_unsigned()) throw Refused{"an id must be a whole number"};
  const auto value = json.get<std::uint64_t>();
  if (value > std::numeric_limits<std::uint32_t>::max()) throw Refused{"an id is too large"};
  return static_cast<std::uint32_t>(value);
}

std::uint32_t number(const Json& json, const char* name) {
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

std::vector<std::uint32_t> numbers(const Json& json, const char* name) {
  std::vector<std::uint32_t> values;
  for (const Json& each : list(json, name)) values.push_back(number(each));
  return values;
}

std::vector<std::string> names(const Json& json) {
  std::vector<std::string> values;
  for (const Json& each : list(json, "parameterNames")) values.push_back(text(each));
  return values;
}

std::optional<messages::ParameterValue> parameter_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

ClientMessage message(const Json& json) {
  const std::string op = optional_text(json, "op");
  if (op == "subscribe") {
    Subscribe out;
    for (const Json& each : list(json, "subscriptions"))
      out.subscriptions.push_back({number(each, "id"), number(each, "channelId")});
    return out;
  }
  if (op == "unsubscribe") return Unsubscribe{numbers(json, "subscriptionIds")};
  if (op == "getParameters") return GetParameters{names(json), optional_text(json, "id")};
  if (op == "setParameters") {
    SetParameters out;
    out.id = optional_text(json, "id");
    for (const Json& each : list(json, "parameters")) {
      if (!each.is_object()) throw Refused{"a parameter must be an object"};
      const auto value = each.find("value");
      out.parameters.push_back({optional_text(each, "name"),
                                value == each.end() ? std::nullopt : parameter_value(*value)});
    }
    return out;
  }
  if (op == "subscribeParameterUpdates") return ParameterSubscription{names(json), true};
  if (op == "unsubscribeParameterUpdates") return ParameterSubscription{names(json), false};
  for (const char* known : {"advertise", "unadvertise", "subscribeConnectionGraph",
                            "unsubscribeConnectionGraph", "fetchAsset"})
    if (op == known) return Unserved{op};
  return Malformed{"unknown op"};
}

std::uint32_t little(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U |
         static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
}

template <class Byte, class Out>
void put_little(Out out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) *out++ = static_cast<Byte>(value >> (8 * i));
}

std::string characters(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

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
  bool old = false;
  while (!offered.empty()) {
    const std::size_t end = std::min(offered.find(','), offered.size());
    std::string_view name = offered.substr(0, end);
    offered.remove_prefix(std::min(end + 1, offered.size()));
    while (!name.empty() && (name.front() == ' ' || name.front() == '\t')) name.remove_prefix(1);
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
    if (name == kNewSubProtocol) return kNewSubProtocol;
    old = old || name == kOldSubProtocol;
  }
  return old ? kOldSubProtocol : std::string_view();
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
  if (bytes.size() < 5 || bytes[0] != kServiceCall || little(bytes.subspan(1)) != service)
    return std::nullopt;
  return bytes.size() < 9 ? 0 : little(bytes.subspan(5));
}

ClientMessage parse_binary(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Malformed{"an empty binary message"};
  if (bytes[0] == kClientData) return Unserved{"client message data"};
  if (bytes[0] != kServiceCall) return Malformed{"a binary message of an unknown kind"};
  bytes = bytes.subspan(1);
  if (bytes.size() < 12) return Malformed{"a service call that is too short"};
  ServiceCall out;
  out.service = little(bytes);
  out.call = little(bytes.subspan(4));
  const std::size_t encoding = little(bytes.subspan(8));
  bytes = bytes.subspan(12);
  if (encoding > bytes.size()) return Malformed{"a service call whose encoding is cut off"};
  out.encoding = characters(bytes.first(encoding));
  out.payload = characters(bytes.subspan(encoding));
  return out;
}

std::optional<std::vector<RequestField>> parse_request(std::string_view text) {
  std::vector<RequestField> fields;
  if (text.empty()) return fields;
  const std::optional<Json> json = parse(text);
  if (!json) return std::nullopt;
  for (const auto& [name, content] : json->items()) {
    fields.push_back({name, RequestField::Other{}});
    if (auto value = parameter_value(content))
      std::visit([&](auto& plain) { fields.back().value = std::move(plain); }, *value);
  }
  return fields;
}

std::string server_info(std::string_view session_id, std::span<const Metadata> metadata) {
  Written entries = Written::object();
  for (const Metadata& each : metadata) entries[each.name] = each.value;
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

std::array<std::uint8_t, 13> message_head(std::uint32_t subscription, std::uint64_t unix_ns) {
  std::array<std::uint8_t, 13> head{};
  head[0] = kMessageData;
  put_little<std::uint8_t>(head.begin() + 1, subscription, 4);
  put_little<std::uint8_t>(head.begin() + 5, unix_ns, 8);
  return head;
}

std::string service_response(std::uint32_t service, std::uint32_t call, std::string_view json) {
  static constexpr std::string_view kEncoding = "json";
  std::string out(1, static_cast<char>(kServiceResponse));
  put_little<char>(std::back_inserter(out), service, 4);
  put_little<char>(std::back_inserter(out), call, 4);
  put_little<char>(std::back_inserter(out), kEncoding.size(), 4);
  out += kEncoding;
  out += json;
  return out;
}

}  // namespace tp100::server
