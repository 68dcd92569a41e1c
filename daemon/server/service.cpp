#include "server/service.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr std::size_t kMaxShownName = 64;

/// "tp100.FileSave" of "file_save".
std::string type_of(std::string_view name) {
  std::string type = "tp100.";
  bool begins = true;
  for (const char letter : name) {
    if (letter != '_') type += begins ? static_cast<char>(std::toupper(letter)) : letter;
    begins = letter == '_';
  }
  return type;
}

/// What the person saw on /state when acting.
Result<Consent> consent_of(const Arguments& given, const messages::PublishClock& clock,
                           HostNs now) {
  // Counted exactly by a double.
  constexpr double kMaxStops = 1e15, kMaxSeconds = 1e9;
  constexpr HostNs kRounding = kNsPerMs;
  const double stops = given.number("stops").value_or(-1.0),
               t_s = given.number("t_s").value_or(-1.0);
  const bool valid = stops >= 0.0 && stops <= kMaxStops && t_s >= 0.0 && t_s <= kMaxSeconds;
  if (!valid || stops != std::floor(stops))
    return Refusal{
        "stops and t_s are needed: /state.stop.count and /state.t_s as the person saw them when "
        "acting"};
  Consent consent;
  consent.stops_seen = static_cast<std::uint64_t>(stops);
  consent.acted_ns = std::min(clock.start_ns + from_s(t_s), now + kRounding);
  consent.seen_ns = consent.acted_ns;
  if (consent.acted_ns >= now + kRounding)
    return Refusal{"t_s is later than now; send /state.t_s as it was received"};
  return consent;
}

const char* kind_of(const messages::ParameterValue& value) {
  return std::holds_alternative<double>(value) ? " must be a number"
         : std::holds_alternative<bool>(value) ? " must be true or false"
                                               : " must be a string";
}

/// Whether all have names and types of the example.
Result<> check(const ServiceRow& row, const std::vector<NamedValue>& arguments) {
  const std::vector<NamedValue>& known = row.request.fields;
  for (const NamedValue& field : arguments) {
    const auto like = std::ranges::find(known, field.name, &NamedValue::name);
    const bool of_consent = row.rules.consents && (field.name == "stops" || field.name == "t_s");
    if (like == known.end() && !row.rules.more_arguments && !of_consent)
      return no_such("argument", field.name);
    if (like != known.end() && (!field.value || field.value->index() != like->value->index()))
      return Refusal{field.name + kind_of(*like->value)};
  }
  return Done{};
}

}  // namespace

ServiceText text_of(const ServiceRow& row) {
  const std::string type = type_of(row.name);
  std::string request = row.request.json;
  if (row.rules.consents)
    request.insert(1, request == "{}" ? R"("stops":1,"t_s":1.5)" : R"("stops":1,"t_s":1.5,)");
  return {static_cast<std::uint32_t>(row.service), row.name, type,
          messages::schema_of(type + "Request", request),
          messages::schema_of(type + "Response", row.response)};
}

Result<Request> read_request(const ServiceRow& row, std::string_view json, std::uint32_t viewer,
                             const messages::PublishClock& clock,
                             const messages::StateFigures& state, HostNs now) {
  auto fields = parse_request(json);
  if (!fields) return Refusal{"the request must be a JSON object"};
  if (const Result<> checked = check(row, *fields); !checked) return checked.refusal();
  Arguments arguments(std::move(*fields));
  Consent consent;
  if (row.rules.consents) {
    const Result<Consent> given = consent_of(arguments, clock, now);
    if (!given) return given.refusal();
    consent = *given;
  }
  consent.by = {Door::kViewer, viewer};
  return Request{std::move(arguments), consent, to_string(consent.by), now, state};
}

Refusal no_such(const std::string& what, const std::string& name) {
  return {"there is no " + what + " '" + one_line(name, kMaxShownName) + "'"};
}

std::string json_of(std::initializer_list<std::pair<const char*, std::string_view>> texts) {
  return text::json_object([&](text::JsonWriter& json) {
    for (const auto& [name, text] : texts) json.field(name, text);
  });
}

Result<std::string> accepted(const Result<>& done) {
  if (!done) return done.refusal();
  return std::string(kAccepted);
}

}  // namespace tp100::server
