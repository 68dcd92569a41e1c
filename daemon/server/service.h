#pragma once
// A service of the protocol as one row: what a request looks like, what it needs, and what it does.
// Whoever does it provides the row. Requests are treated as hostile. Pure.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/consent.h"
#include "core/result.h"
#include "core/time.h"
#include "messages/figures.h"
#include "messages/messages.h"
#include "server/protocol.h"

namespace tp100::server {

/// Clients call services by these numbers: none may change or be used again.
enum class Service : std::uint32_t {
  kStart = 1,
  kHold,
  kStop,
  kRecordStart,
  kRecordStop,
  kDriveTake,
  kDrive,
  kDriveRelease,
  kChoose,
  kPlace,
  kFileSave,
  kFileDelete,
  kFileCheck,
  kPause,
  kResume,
  kParametersSave,
  kParametersRestore,
  kRunNote,
  kRunDelete,
  kRunReport,
  kRunCompare,
  kDoctor,
  kRunIdentify,
  kWheelsUpBegin,
  kWheelsUpWatch,
  kWatch,
  kMark,
};

enum class Permission : std::uint8_t {
  kCommand,
  kStopOnly,  ///< view, and STOP
};

class Arguments {
 public:
  Arguments(std::vector<NamedValue> fields = {}) : fields_(std::move(fields)) {}

  bool empty() const { return fields_.empty(); }
  const std::vector<NamedValue>& fields() const { return fields_; }
  // Nothing: there is none of that name and type.
  std::optional<std::string> text(std::string_view name) const { return get<std::string>(name); }
  std::optional<double> number(std::string_view name) const { return get<double>(name); }
  std::optional<bool> flag(std::string_view name) const { return get<bool>(name); }

 private:
  template <class T>
  std::optional<T> get(std::string_view name) const {
    for (const NamedValue& field : fields_)
      if (field.name == name && field.value)
        if (const T* value = std::get_if<T>(&*field.value)) return *value;
    return std::nullopt;
  }
  std::vector<NamedValue> fields_;
};

/// A request whose arguments have the names and types of the row's example.
struct Request {
  Arguments arguments;
  Consent consent;  ///< of a row that needs one
  std::string by;   ///< the client, which no other one is called: "viewer 3"
  HostNs now = 0;
  const messages::StateFigures& state;  ///< as published last

  bool under_way() const { return tp100::under_way(state.run); }
};

/// Receives why the request failed, in one line, or nothing; and its answer as JSON. Called once,
/// from any thread.
using Answer = std::function<void(const std::string& why, const std::string& json)>;

/// What a service does, in the server's thread (server.h), where it must not block: neither on a
/// disk nor on a lock that is held by a thread waiting for one.
using AtOnce = std::function<Result<std::string>(const Request&)>;     ///< returns the answer
using Later = std::function<Result<>(const Request&, const Answer&)>;  ///< answers or refuses

/// A JSON object that has the names and types of a request's arguments.
struct RequestExample {
  RequestExample(const char* text) : json(text), fields(parse_request(text).value()) {}

  const char* json;
  std::vector<NamedValue> fields;
};

struct ServiceRow {
  struct Rules {
    bool consents = false;        ///< sets the robot in motion, and so carries what the person saw
    bool more_arguments = false;  ///< takes others than those of the example
    Permission permission = Permission::kCommand;  ///< kStopOnly: taken from everybody
    bool at_rest = false;  ///< refused while a run is under way or somebody drives by hand
  };

  Service service{};
  const char* name = "";
  // Examples, from which the schemas are made; without a consent's arguments.
  RequestExample request = "{}";
  const char* response = "{}";
  std::variant<std::monostate, AtOnce, Later> does{};  ///< nothing: STOP, which waits for nothing
  Rules rules{};
};

/// Refusal of requests that need a robot at rest.
inline constexpr const char* kUnderWay =
    "a run is under way, or somebody drives by hand; stop it first";

/// As it is advertised.
ServiceText text_of(const ServiceRow& row);
/// Reads a request for `row` by `viewer`, with a consent as of host time `now`.
Result<Request> read_request(const ServiceRow& row, std::string_view json, std::uint32_t viewer,
                             const messages::PublishClock& clock,
                             const messages::StateFigures& state, HostNs now);

/// Refuses an argument of another name, cut off and in one line.
Refusal no_such(const std::string& what, const std::string& name);
/// A JSON object of texts.
std::string json_of(std::initializer_list<std::pair<const char*, std::string_view>> texts);
/// The answer of most requests that are carried out at once.
inline constexpr const char* kAccepted = R"({"accepted":true})";
Result<std::string> accepted(const Result<>& done);

}  // namespace tp100::server
