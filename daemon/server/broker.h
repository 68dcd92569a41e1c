#pragma once
// Connects channels to viewers: subscriptions, a new subscriber's first messages, waiting frames.
// No socket; one thread.

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "messages/channels.h"
#include "messages/figures.h"
#include "server/protocol.h"

namespace tp100::server {

/// One WebSocket message; bodies are shared between clients.
struct WebSocketFrame {
  bool binary = false;
  std::uint8_t head_size = 0;
  std::array<std::uint8_t, 13> head{};
  std::shared_ptr<const std::string> body;

  std::size_t size() const { return head_size + body->size(); }
};

/// Frames waiting for one client: bounded, the oldest data is dropped first.
class Outbox {
 public:
  static constexpr std::size_t kMaxData = 512;  ///< frames
  static constexpr std::size_t kMaxDataBytes = 4 << 20;
  static constexpr std::size_t kMaxReplies = 256;  ///< frames
  static constexpr std::size_t kMaxReplyBytes = 4 << 20;

  /// Queues one data frame; drops older ones, and counts them, if there is no room.
  void push_data(WebSocketFrame frame);
  /// Queues an answer; answers precede data and are never dropped. False: no room, as the client
  /// requests more than it reads.
  [[nodiscard]] bool push_reply(WebSocketFrame frame);

  bool empty() const { return data_.empty() && replies_.empty(); }
  std::size_t size() const { return data_.size() + replies_.size(); }
  /// The next frame to write. Must not be empty.
  WebSocketFrame pop();

  std::uint64_t dropped() const { return dropped_; }

 private:
  std::deque<WebSocketFrame> data_;
  std::deque<WebSocketFrame> replies_;
  std::size_t data_bytes_ = 0;
  std::size_t reply_bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

/// One connected client.
class Viewer {
 public:
  /// `wake`: something waits in the outbox. `fail`: the client requests more than it reads.
  Viewer(std::uint32_t id, std::function<void()> wake, std::function<void()> fail)
      : id_(id), wake_(std::move(wake)), fail_(std::move(fail)) {}

  std::uint32_t id() const { return id_; }
  Outbox& outbox() { return outbox_; }
  const Outbox& outbox() const { return outbox_; }
  const std::map<std::uint32_t, messages::Channel>& subscriptions() const { return subscriptions_; }

  /// A JSON text or whole binary message of the protocol.
  void reply(std::string body, bool binary = false);
  void say(StatusLevel level, std::string_view message) { reply(status(level, message)); }

 private:
  friend class Broker;
  void send(std::uint32_t subscription, std::uint64_t unix_ns,
            const std::shared_ptr<const std::string>& body);

  std::uint32_t id_;
  std::function<void()> wake_;
  std::function<void()> fail_;
  Outbox outbox_;
  std::map<std::uint32_t, messages::Channel> subscriptions_;
};

/// Receives every message of every channel, without a subscription.
using Listener =
    std::function<void(messages::Channel, std::uint64_t unix_ns, std::string_view json)>;

class Broker {
 public:
  explicit Broker(std::vector<messages::ChannelText> channels, Listener listener = {});

  const std::vector<messages::ChannelText>& channels() const { return channels_; }

  /// Whether anyone receives the channel, now or on subscribing later.
  bool wanted(messages::Channel channel) const;
  void publish(messages::Channel channel, std::uint64_t unix_ns, std::string json) {
    publish(channel, unix_ns, std::make_shared<const std::string>(std::move(json)));
  }
  void publish(messages::Channel channel, std::uint64_t unix_ns,
               const std::shared_ptr<const std::string>& body);
  /// Makes the message that a new subscriber of `channel` receives instead of the last messages.
  using Catch = std::function<std::shared_ptr<const std::string>(std::uint64_t& unix_ns)>;
  void catch_up(messages::Channel channel, Catch make);

  void add(const std::shared_ptr<Viewer>& viewer);
  void remove(const std::shared_ptr<Viewer>& viewer);
  void subscribe(Viewer& viewer, const Subscribe& wanted);
  void unsubscribe(Viewer& viewer, const Unsubscribe& unwanted);

  const std::vector<std::shared_ptr<Viewer>>& viewers() const { return viewers_; }

 private:
  struct Message {
    std::uint64_t unix_ns;
    std::shared_ptr<const std::string> body;
  };
  struct Subscriber {
    Viewer* viewer;
    std::uint32_t subscription;
  };
  struct Line {
    std::vector<Subscriber> subscribers;
    std::deque<Message> kept;
    Catch catch_up;
  };
  Line& line(messages::Channel channel) { return lines_[static_cast<std::uint32_t>(channel) - 1]; }
  const Line& line(messages::Channel channel) const {
    return lines_[static_cast<std::uint32_t>(channel) - 1];
  }
  void drop(Viewer& viewer, std::uint32_t subscription, messages::Channel channel);

  std::vector<messages::ChannelText> channels_;
  Listener listener_;
  std::array<Line, messages::kChannelCount> lines_{};
  std::vector<std::shared_ptr<Viewer>> viewers_;
};

}  // namespace tp100::server
