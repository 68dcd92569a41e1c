#pragma once
// The server's side of the Foxglove WebSocket protocol: converts text and bytes from and to plain
// data. Pure. Treats everything that a client sends as hostile. Little-endian, as the protocol.

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "messages/channels.h"
#include "messages/parameter_text.h"

namespace tp100::server {

inline constexpr std::string_view kNewSubProtocol = "foxglove.sdk.v1";
inline constexpr std::string_view kOldSubProtocol = "foxglove.websocket.v1";
/// The sub-protocol for the reply to a Sec-WebSocket-Protocol header; empty: none of ours is
/// offered.
std::string_view choose_sub_protocol(std::string_view offered);

// Messages from a client.
struct Subscribe {
  struct One {
    std::uint32_t subscription, channel;
    std::uint32_t interval_ms = 0;  ///< at most one message in each; 0: all
  };
  std::vector<One> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
struct GetParameters {
  std::vector<std::string> names;  ///< empty: all
  std::string id;                  ///< returned with the answer; empty: none
};
/// A parameter to set, or a field of a service request.
struct NamedValue {
  std::string name;
  std::optional<messages::ParameterValue> value;  ///< nothing: none, null, a list or an object
};
struct SetParameters {
  std::vector<NamedValue> parameters;
  std::string id;
};
struct ParameterSubscription {
  std::vector<std::string> names;  ///< empty: all
  bool watch = true;               ///< false: unsubscribe
};
struct ServiceCall {
  std::uint32_t service = 0, call = 0;
  std::string encoding;
  std::string payload;
};
/// A valid message that this server does not support.
struct Unserved {
  std::string what;
};
/// Not a message of the protocol.
struct Malformed {
  std::string why;
};
using ClientMessage = std::variant<Subscribe, Unsubscribe, GetParameters, SetParameters,
                                   ParameterSubscription, ServiceCall, Unserved, Malformed>;

/// The call's number if a binary message begins as a call of `service`, whatever follows; 0 if it
/// is cut off before the number.
std::optional<std::uint32_t> call_of(std::uint32_t service, std::span<const std::uint8_t> bytes);

ClientMessage parse_text(std::string_view text);
ClientMessage parse_binary(std::span<const std::uint8_t> bytes);

/// Fields of a JSON object, for service requests; nothing if `text` is no object.
std::optional<std::vector<NamedValue>> parse_request(std::string_view text);

// Messages from the server.
enum class StatusLevel : std::uint8_t { kInfo = 0, kWarning = 1, kError = 2 };

struct ServiceText {
  std::uint32_t id = 0;
  std::string name, type, request_schema, response_schema;
};

std::string server_info(std::string_view session_id,
                        std::initializer_list<std::pair<const char*, std::string_view>> metadata);
std::string advertise(std::span<const messages::ChannelText> channels);
std::string advertise_services(std::span<const ServiceText> services);
std::string status(StatusLevel level, std::string_view message);
std::string parameter_values(std::span<const messages::ParameterText* const> parameters,
                             std::string_view id);
std::string service_failure(std::uint32_t service, std::uint32_t call, std::string_view message);

/// Head of a message-data frame; the payload follows.
using MessageHead = std::array<std::uint8_t, 13>;
MessageHead message_head(std::uint32_t subscription, std::uint64_t unix_ns);
/// A whole service response with a JSON payload.
std::string service_response(std::uint32_t service, std::uint32_t call, std::string_view json);

}  // namespace tp100::server
