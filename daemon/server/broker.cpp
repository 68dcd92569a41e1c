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

void Outbox::push_data(WebSocketFrame frame) {
  const std::lock_guard lock(mutex_);
  data_bytes_ += counted(frame);
  data_.push_back(std::move(frame));
  while (data_.size() > kMaxData || data_bytes_ > kMaxDataBytes) {
    data_bytes_ -= counted(data_.front());
    data_.pop_front();
    ++dropped_;
  }
}

void Outbox::forget(const std::string* body) {
  const std::lock_guard lock(mutex_);
  std::erase_if(data_, [&](const WebSocketFrame& frame) {
    if (frame.body.get() != body) return false;
    data_bytes_ -= counted(frame);
    return true;
  });
}

bool Outbox::push_reply(WebSocketFrame frame) {
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = reply_bytes_ + frame.size();
  if (replies_.size() >= kMaxReplies || bytes > kMaxReplyBytes) return false;
  reply_bytes_ = bytes;
  replies_.push_back(std::move(frame));
  return true;
}

std::optional<WebSocketFrame> Outbox::pop() {
  const std::lock_guard lock(mutex_);
  if (!replies_.empty()) {
    WebSocketFrame frame = std::move(replies_.front());
    replies_.pop_front();
    reply_bytes_ -= frame.size();
    return frame;
  }
  if (data_.empty()) return std::nullopt;
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
  WebSocketFrame frame;
  frame.binary = binary;
  charge(body.size());
  frame.body = std::make_shared<const std::string>(std::move(body));
  if (outbox_.push_reply(std::move(frame))) {
    wake();
  } else {
    fail_();
  }
}

void Viewer::send(std::uint32_t subscription, std::uint64_t unix_ns,
                  const std::shared_ptr<const std::string>& body) {
  WebSocketFrame frame;
  frame.binary = true;
  frame.head = message_head(subscription, unix_ns);
  frame.head_size = static_cast<std::uint8_t>(frame.head.size());
  frame.body = body;
  outbox_.push_data(std::move(frame));
  wake();
}

Broker::Broker(std::vector<messages::ChannelText> channels, Listener listener)
    : channels_(std::move(channels)), listener_(std::move(listener)) {}

bool Broker::wanted(messages::Channel channel) const {
  return !line(channel).subscribers.empty() ||
         channels_[static_cast<std::uint32_t>(channel) - 1].kept > 0;
}

void Broker::publish(messages::Channel channel, std::uint64_t unix_ns,
                     const std::shared_ptr<const std::string>& body) {
  Line& to = line(channel);
  const std::size_t keep = channels_[static_cast<std::uint32_t>(channel) - 1].kept;
  if (to.subscribers.empty() && keep == 0) return;
  if (listener_) listener_(channel, unix_ns, *body);
  for (const Subscriber& each : to.subscribers) each.viewer->send(each.subscription, unix_ns, body);
  if (keep == 0) return;
  to.kept.push_back({unix_ns, body});
  if (to.kept.size() <= keep) return;
  // Viewers that do not read would keep every course that was ever chosen.
  const std::shared_ptr<const std::string> old = std::move(to.kept.front().body);
  to.kept.pop_front();
  if (keep == 1 && old->size() > Outbox::kMaxCounted)
    for (const auto& viewer : viewers_) viewer->outbox().forget(old.get());
}

void Broker::catch_up(messages::Channel channel, Catch make) {
  line(channel).catch_up = std::move(make);
}

void Broker::add(const std::shared_ptr<Viewer>& viewer) { viewers_.push_back(viewer); }

void Broker::remove(const std::shared_ptr<Viewer>& viewer) {
  for (const auto& [subscription, channel] : viewer->subscriptions_)
    drop(*viewer, subscription, channel);
  viewer->subscriptions_.clear();
  std::erase(viewers_, viewer);
}

void Broker::subscribe(Viewer& viewer, const Subscribe& wanted) {
  for (const Subscribe::One& one : wanted.subscriptions) {
    if (one.channel == 0 || one.channel > messages::kChannelCount) {
      viewer.say(StatusLevel::kWarning, "there is no channel " + std::to_string(one.channel));
      continue;
    }
    if (viewer.subscriptions_.contains(one.subscription)) {
      viewer.say(StatusLevel::kWarning, "subscription " + std::to_string(one.subscription) +
                                            " is in use; choose another id");
      continue;
    }
    const auto channel = static_cast<messages::Channel>(one.channel);
    const bool twice = std::any_of(viewer.subscriptions_.begin(), viewer.subscriptions_.end(),
                                   [&](const auto& each) { return each.second == channel; });
    if (twice) {
      viewer.say(StatusLevel::kWarning,
                 "channel " + std::to_string(one.channel) + " is subscribed to already");
      continue;
    }
    viewer.subscriptions_.emplace(one.subscription, channel);
    Line& from = line(channel);
    from.subscribers.push_back({&viewer, one.subscription});
    for (const Message& message : from.kept) {
      viewer.charge(message.body->size() / kSharedShare);
      viewer.send(one.subscription, message.unix_ns, message.body);
    }
    if (!from.catch_up) continue;
    std::uint64_t unix_ns = 0;
    if (const auto body = from.catch_up(unix_ns)) {
      viewer.charge(body->size() / kSharedShare);
      viewer.send(one.subscription, unix_ns, body);
    }
  }
}

void Broker::unsubscribe(Viewer& viewer, const Unsubscribe& unwanted) {
  for (const std::uint32_t subscription : unwanted.subscriptions) {
    const auto found = viewer.subscriptions_.find(subscription);
    if (found == viewer.subscriptions_.end()) {
      viewer.say(StatusLevel::kWarning, "there is no subscription " + std::to_string(subscription));
      continue;
    }
    drop(viewer, subscription, found->second);
    viewer.subscriptions_.erase(found);
  }
}

void Broker::drop(Viewer& viewer, std::uint32_t subscription, messages::Channel channel) {
  std::erase_if(line(channel).subscribers, [&](const Subscriber& each) {
    return each.viewer == &viewer && each.subscription == subscription;
  });
}

}  // namespace tp100::server
