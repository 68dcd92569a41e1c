#include "server/history.h"

#include <algorithm>
#include <utility>

namespace tp100::server {
namespace {

using messages::Channel;

constexpr std::array<std::pair<Channel, std::string_view>, 7> kKept = {{
    {Channel::kEstimate, "estimate"},
    {Channel::kSample, "sample"},
    {Channel::kCommand, "command"},
    {Channel::kSlip, "slip"},
    {Channel::kLink, "link"},
    {Channel::kLoop, "loop"},
    {Channel::kState, "state"},
}};

std::size_t index(Channel channel) { return static_cast<std::size_t>(channel) - 1; }

}  // namespace

bool History::due(Channel channel, HostNs now) const {
  const bool kept = std::ranges::find(kKept, channel,
                                      &std::pair<Channel, std::string_view>::first) != kKept.end();
  return kept && now >= lines_.at(index(channel)).due_ns;
}

void History::take(Channel channel, HostNs now, std::string_view json) {
  if (!due(channel, now)) return;
  Line& line = lines_.at(index(channel));
  line.due_ns = now + kIntervalNs;
  line.messages.push_back({now, std::string(json)});
  line.bytes += json.size();
  while (!line.messages.empty() &&
         (line.bytes > kMaxBytes || now - line.messages.front().at_ns > kSpanNs)) {
    line.bytes -= line.messages.front().json.size();
    line.messages.pop_front();
  }
}

std::optional<std::string> History::json(std::string_view topic) const {
  const auto kept = std::ranges::find(kKept, topic, &std::pair<Channel, std::string_view>::second);
  if (kept == kKept.end()) return std::nullopt;
  const Line& line = lines_.at(index(kept->first));
  std::string text = "[";
  text.reserve(line.bytes + line.messages.size() + 2);
  for (const Message& each : line.messages) {
    if (text.size() > 1) text += ',';
    text += each.json;
  }
  return text + "]";
}

}  // namespace tp100::server
