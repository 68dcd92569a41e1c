#pragma once
// The messages of the channels of figures over the last minutes, at a reduced rate, for pages that
// are opened later. No socket; one thread; time is passed in.

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "core/time.h"
#include "messages/channels.h"

namespace tp100::server {

class History {
 public:
  static constexpr HostNs kIntervalNs = 200 * kNsPerMs;
  static constexpr HostNs kSpanNs = 300 * kNsPerS;
  /// Limit of one channel; its oldest messages are dropped first.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

  /// Whether the channel is kept at all, and a message of it is due.
  bool due(messages::Channel channel, HostNs now) const;
  /// Keeps the message if it is due.
  void take(messages::Channel channel, HostNs now, std::string_view json);
  /// The messages of a topic without its slash, oldest first, as a JSON array; nothing: no such
  /// topic is kept.
  std::optional<std::string> json(std::string_view topic) const;

 private:
  struct Message {
    HostNs at_ns;
    std::string json;
  };
  struct Line {
    std::deque<Message> messages;
    std::size_t bytes = 0;
    HostNs due_ns = 0;
  };
  std::array<Line, messages::kChannelCount> lines_{};
};

}  // namespace tp100::server
