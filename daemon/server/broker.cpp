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
  charge(body.size());
  const bool room = outbox_.push_reply(
      {.binary = binary, .body = std::make_shared<const std::string>(std::move(body))});
  room ? wake() : fail_();
}

void Viewer::send(std::uint32_t subscription, std::uint64_t unix_ns,
                  const std::shared_ptr<const std::string>& body) {
  const MessageHead head = message_head(subscription, unix_ns);
  outbox_.push_data({.binary = true, .head_size = head.size(), .head = head, .body = body});
  wake();
}

Broker::Broker(std::vector<messages::ChannelText> channels, Listener listener)
    : channels_(std::move(channels)), listener_(std::move(listener)) {}

bool Broker::wanted(messages::Channel channel) const {
  const std::size_t i = index(channel);
  return channels_[i].kept > 0 || std::ranges::any_of(viewers_, [&](const auto& viewer) {
           return viewer->subscriptions_[i].has_value();
         });
}

void Broker::publish(messages::Channel channel, std::uint64_t unix_ns,
                     const std::shared_ptr<const std::string>& body) {
  if (!wanted(channel)) return;
  if (listener_) listener_(channel, unix_ns, *body);
  for (const auto& viewer : viewers_)
    if (const auto subscription = viewer->subscriptions_[index(channel)])
      viewer->send(*subscription, unix_ns, body);
  const std::size_t keep = channels_[index(channel)].kept;
  if (keep == 0) return;
  std::deque<Message>& kept = line(channel).kept;
  kept.push_back({unix_ns, body});
  if (kept.size() <= keep) return;
  // Viewers that do not read would keep every course that was ever chosen.
  const std::shared_ptr<const std::string> old = std::move(kept.front().body);
  kept.pop_front();
  if (keep == 1 && old->size() > Outbox::kMaxCounted)
    for (const auto& viewer : viewers_) viewer->outbox().forget(old.get());
}

void Broker::subscribe(Viewer& viewer, const Subscribe& wanted) {
  for (const Subscribe::One& one : wanted.subscriptions) {
    const std::string number = std::to_string(one.channel);
    if (one.channel == 0 || one.channel > messages::kChannelCount) {
      viewer.say(StatusLevel::kWarning, "there is no channel " + number);
      continue;
    }
    if (std::ranges::count(viewer.subscriptions_, std::optional(one.subscription)) > 0) {
      viewer.say(StatusLevel::kWarning, "subscription " + std::to_string(one.subscription) +
                                            " is in use; choose another id");
      continue;
    }
    const auto channel = static_cast<messages::Channel>(one.channel);
    if (viewer.subscriptions_[index(channel)]) {
      viewer.say(StatusLevel::kWarning, "channel " + number + " is subscribed to already");
      continue;
    }
    viewer.subscriptions_[index(channel)] = one.subscription;
    std::deque<Message> first = line(channel).kept;
    if (line(channel).catch_up) first.push_back(line(channel).catch_up());
    for (const Message& message : first) {
      viewer.charge(message.body->size() / kSharedShare);
      viewer.send(one.subscription, message.unix_ns, message.body);
    }
  }
}

void Broker::unsubscribe(Viewer& viewer, const Unsubscribe& unwanted) {
  for (const std::uint32_t subscription : unwanted.subscriptions) {
    const auto found = std::ranges::find(viewer.subscriptions_, std::optional(subscription));
    if (found != viewer.subscriptions_.end()) {
      found->reset();
    } else {
      viewer.say(StatusLevel::kWarning, "there is no subscription " + std::to_string(subscription));
    }
  }
}

}  // namespace tp100::server
