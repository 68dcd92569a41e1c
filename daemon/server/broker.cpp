#include "server/broker.h"

#include <algorithm>
#include <utility>

namespace tp100::server {

namespace {

/// Of a body that others have too.
constexpr std::size_t kSharedShare = 64;

std::size_t counted(const WebSocketFrame& data) {
  return std::min(data.size(), Outbox::kMaxCounted);
}

}  // namespace

bool Outbox::replace(WebSocketFrame& frame) {
  if (frame.unix_ns == 0) return false;
  constexpr std::size_t kName = 5;  // of the message: its kind and subscription
  const auto same = [&](const WebSocketFrame& other) {
    return other.unix_ns != 0 &&
           std::equal(frame.head.begin(), frame.head.begin() + kName, other.head.begin());
  };
  const auto oldest = std::ranges::find_if(data_, same);
  if (oldest == data_.end()) return false;
  if (oldest->size() <= kMaxCounted && frame.unix_ns < oldest->unix_ns + kReplacedAfterNs)
    return false;
  // At the place of the oldest, so that no channel waits for ever behind another one.
  std::swap(*oldest, frame);
  dropped_ += 1 + std::erase_if(data_, [&](const WebSocketFrame& other) {
                return &other != &*oldest && same(other);
              });
  data_bytes_ = 0;
  for (const WebSocketFrame& each : data_) data_bytes_ += counted(each);
  return true;
}

void Outbox::push_data(WebSocketFrame frame) {
  const std::lock_guard lock(mutex_);
  if (replace(frame)) return;
  data_bytes_ += counted(frame);
  data_.push_back(std::move(frame));
  while (data_.size() > kMaxData || data_bytes_ > kMaxDataBytes) {
    data_bytes_ -= counted(data_.front());
    data_.pop_front();
    ++dropped_;
  }
}

bool Outbox::push_reply(WebSocketFrame frame) {
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = reply_bytes_ + frame.size();
  if (replies_.size() >= kMaxReplies || bytes > kMaxReplyBytes) return false;
  reply_bytes_ = bytes;
  replies_.push_back(std::move(frame));
  return true;
}

std::optional<WebSocketFrame> Outbox::pop(bool data) {
  const std::lock_guard lock(mutex_);
  if (!replies_.empty()) {
    WebSocketFrame frame = std::move(replies_.front());
    replies_.pop_front();
    reply_bytes_ -= frame.size();
    return frame;
  }
  if (!data || data_.empty()) return std::nullopt;
  WebSocketFrame frame = std::move(data_.front());
  data_.pop_front();
  data_bytes_ -= counted(frame);
  return frame;
}

std::size_t Outbox::size() const {
  const std::lock_guard lock(mutex_);
  return data_.size() + replies_.size();
}

std::uint64_t Outbox::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

bool Viewer::admit(std::size_t bytes) {
  bytes += kRequestBytes;
  if (waiting_bytes_ + bytes > kMaxWaitingBytes) return false;
  waiting_bytes_ += bytes;
  return true;
}

void Viewer::wake() {
  if (!woken_.exchange(true)) wake_();
}

void Viewer::reply(std::string body, bool binary) {
  charge(body.size());
  const bool room = outbox_.push_reply(
      {.binary = binary, .body = std::make_shared<const std::string>(std::move(body))});
  room ? wake() : fail_();
}

void Viewer::send(std::uint32_t subscription, std::uint64_t unix_ns,
                  const std::shared_ptr<const std::string>& body, bool replaced) {
  const MessageHead head = message_head(subscription, unix_ns);
  outbox_.push_data({.binary = true,
                     .head_size = head.size(),
                     .head = head,
                     .body = body,
                     .unix_ns = replaced ? unix_ns : 0});
  wake();
}

std::optional<Viewer::Subscription>* Viewer::subscription(std::uint32_t id) {
  const auto found = std::ranges::find_if(
      subscriptions_, [id](const auto& each) { return each && each->id == id; });
  return found == subscriptions_.end() ? nullptr : &*found;
}

Broker::Broker(std::vector<messages::ChannelText> channels, Listener listener)
    : channels_(std::move(channels)), listener_(std::move(listener)) {}

bool Broker::wanted(messages::Channel channel, std::uint64_t unix_ns) const {
  const std::size_t i = index(channel);
  return channels_[i].kept > 0 || std::ranges::any_of(viewers_, [&](const auto& viewer) {
           return viewer->subscriptions_[i] && viewer->subscriptions_[i]->due(unix_ns);
         });
}

void Broker::publish(messages::Channel channel, std::uint64_t unix_ns,
                     const std::shared_ptr<const std::string>& body) {
  if (!wanted(channel, unix_ns)) return;
  if (listener_) listener_(channel, unix_ns, *body);
  const std::size_t i = index(channel);
  for (const auto& viewer : viewers_) {
    auto& subscription = viewer->subscriptions_[i];
    if (!subscription || !subscription->due(unix_ns)) continue;
    if (subscription->interval_ns > 0) subscription->sent = subscription->interval_of(unix_ns);
    viewer->send(subscription->id, unix_ns, body, replaced(i));
  }
  const std::size_t keep = channels_[i].kept;
  if (keep == 0) return;
  std::deque<Message>& kept = line(channel).kept;
  kept.push_back({unix_ns, body});
  if (kept.size() > keep) kept.pop_front();
}

void Broker::subscribe(Viewer& viewer, const Subscribe& wanted) {
  for (const Subscribe::One& one : wanted.subscriptions) {
    const std::string number = std::to_string(one.channel);
    if (one.channel == 0 || one.channel > messages::kChannelCount) {
      viewer.say(StatusLevel::kWarning, "there is no channel " + number);
      continue;
    }
    if (viewer.subscription(one.subscription) != nullptr) {
      viewer.say(StatusLevel::kWarning, "subscription " + std::to_string(one.subscription) +
                                            " is in use; choose another id");
      continue;
    }
    const auto channel = static_cast<messages::Channel>(one.channel);
    if (viewer.subscriptions_[index(channel)]) {
      viewer.say(StatusLevel::kWarning, "channel " + number + " is subscribed to already");
      continue;
    }
    viewer.subscriptions_[index(channel)] =
        Viewer::Subscription{one.subscription, std::uint64_t{one.interval_ms} * 1'000'000};
    std::deque<Message> first = line(channel).kept;
    if (line(channel).catch_up) first.push_back(line(channel).catch_up());
    for (const Message& message : first) {
      viewer.charge(message.body->size() / kSharedShare);
      viewer.send(one.subscription, message.unix_ns, message.body, replaced(index(channel)));
    }
  }
}

void Broker::unsubscribe(Viewer& viewer, const Unsubscribe& unwanted) {
  for (const std::uint32_t subscription : unwanted.subscriptions) {
    if (auto* found = viewer.subscription(subscription)) {
      found->reset();
    } else {
      viewer.say(StatusLevel::kWarning, "there is no subscription " + std::to_string(subscription));
    }
  }
}

}  // namespace tp100::server
