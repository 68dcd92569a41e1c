#pragma once
// Connects channels to viewers: subscriptions, a new subscriber's first messages, waiting frames.
// No socket; one thread, the server thread's, but for what is marked for the sockets' thread.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/channels.h"
#include "server/protocol.h"

namespace tp100::server {

/// One WebSocket message; bodies are shared between clients.
struct WebSocketFrame {
  bool binary = false;
  std::size_t head_size = 0;
  MessageHead head{};
  std::shared_ptr<const std::string> body{};
  std::uint64_t unix_ns =
      0;  ///< of data that newer data of its subscription replaces; 0: none does

  std::size_t size() const { return head_size + body->size(); }
};

/// Frames waiting for one client: bounded, the oldest data is dropped first, and what has waited is
/// replaced by newer data, so that a slow link shows the present. Any thread; its lock is held for
/// moments only.
class Outbox {
 public:
  static constexpr std::size_t kMaxData = 512;  ///< frames
  static constexpr std::size_t kMaxDataBytes = 4 << 20;
  /// A larger data frame counts as one of this size: its body is the same for all clients.
  static constexpr std::size_t kMaxCounted = 64 << 10;
  /// Data that is newer by this replaces what waits; large data always does.
  static constexpr std::uint64_t kReplacedAfterNs = 200'000'000;
  static constexpr std::size_t kMaxReplies = 256;  ///< frames
  static constexpr std::size_t kMaxReplyBytes = 1 << 20;

  /// Queues one data frame; drops older ones, and counts them, if there is no room.
  void push_data(WebSocketFrame frame);
  /// Queues an answer; answers precede data and are never dropped. False: no room, as the client
  /// requests more than it reads.
  [[nodiscard]] bool push_reply(WebSocketFrame frame);

  std::size_t size() const;
  /// The next frame to write, or answer if `data` is not wanted; nothing: there is none.
  std::optional<WebSocketFrame> pop(bool data = true);

  std::uint64_t dropped() const;

 private:
  bool replace(WebSocketFrame& frame);

  mutable std::mutex mutex_;
  std::deque<WebSocketFrame> data_;
  std::deque<WebSocketFrame> replies_;
  std::size_t data_bytes_ = 0;
  std::size_t reply_bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

class Viewer {
 public:
  /// `wake`: something waits in the outbox; it is called once until awake(). `fail`: the client
  /// requests more than it reads. Both are called by any thread.
  Viewer(std::uint32_t id, std::function<void()> wake, std::function<void()> fail)
      : id_(id), wake_(std::move(wake)), fail_(std::move(fail)) {}

  std::uint32_t id() const { return id_; }
  Outbox& outbox() { return outbox_; }  ///< any thread
  std::size_t subscriptions() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        subscriptions_, [](const auto& subscription) { return subscription.has_value(); }));
  }

  // Any thread.
  /// A JSON text or whole binary message of the protocol, for which the client is charged.
  void reply(std::string body, bool binary = false);
  void say(StatusLevel level, std::string_view message) { reply(status(level, message)); }
  /// The client's requests made work like `bytes` of an answer.
  void charge(std::size_t bytes) { owed_bytes_ += bytes; }
  /// What it was charged since the last call.
  std::size_t take_owed() { return owed_bytes_.exchange(0); }

  // The sockets' thread.
  /// Call it before taking frames out of the outbox.
  void awake() { woken_ = false; }
  /// A request of so many bytes is on its way to the server thread. False: too many are.
  [[nodiscard]] bool admit(std::size_t bytes);
  // The server thread's.
  /// It is answered.
  void answered(std::size_t bytes) { waiting_bytes_ -= bytes + kRequestBytes; }

 private:
  static constexpr std::size_t kMaxWaitingBytes = 256 << 10;
  static constexpr std::size_t kRequestBytes = 512;  // besides its text

  friend class Broker;
  void wake();
  struct Subscription {
    std::uint32_t id = 0;
    std::uint64_t interval_ns = 0;  // 0: all messages
    std::uint64_t sent = 0;         // the interval of the last one
    // The intervals of all viewers begin alike: they share their messages.
    std::uint64_t interval_of(std::uint64_t unix_ns) const { return unix_ns / interval_ns; }
    bool due(std::uint64_t unix_ns) const {
      return interval_ns == 0 || interval_of(unix_ns) != sent;
    }
  };
  std::optional<Subscription>* subscription(std::uint32_t id);  // null: none has it
  void send(std::uint32_t subscription, std::uint64_t unix_ns,
            const std::shared_ptr<const std::string>& body, bool replaced);

  std::uint32_t id_;
  std::function<void()> wake_;
  std::function<void()> fail_;
  Outbox outbox_;
  std::atomic<bool> woken_{false};
  std::atomic<std::size_t> owed_bytes_{0}, waiting_bytes_{0};
  std::array<std::optional<Subscription>, messages::kChannelCount> subscriptions_{};  // by channel
};

/// Receives every message of every channel, without a subscription.
using Listener =
    std::function<void(messages::Channel, std::uint64_t unix_ns, std::string_view json)>;

class Broker {
 public:
  struct Message {
    std::uint64_t unix_ns;
    std::shared_ptr<const std::string> body;
  };

  explicit Broker(std::vector<messages::ChannelText> channels, Listener listener = {});

  const std::vector<messages::ChannelText>& channels() const { return channels_; }

  /// Whether anyone receives a message of this time, now or on subscribing later.
  bool wanted(messages::Channel channel, std::uint64_t unix_ns) const;
  void publish(messages::Channel channel, std::uint64_t unix_ns, std::string json) {
    publish(channel, unix_ns, std::make_shared<const std::string>(std::move(json)));
  }
  void publish(messages::Channel channel, std::uint64_t unix_ns,
               const std::shared_ptr<const std::string>& body);
  /// `make` makes the message that a new subscriber of `channel` receives besides those kept.
  void catch_up(messages::Channel channel, std::function<Message()> make) {
    line(channel).catch_up = std::move(make);
  }

  void add(const std::shared_ptr<Viewer>& viewer) { viewers_.push_back(viewer); }
  void remove(const std::shared_ptr<Viewer>& viewer) { std::erase(viewers_, viewer); }
  void subscribe(Viewer& viewer, const Subscribe& wanted);
  void unsubscribe(Viewer& viewer, const Unsubscribe& unwanted);

  const std::vector<std::shared_ptr<Viewer>>& viewers() const { return viewers_; }

 private:
  struct Line {
    std::deque<Message> kept;
    std::function<Message()> catch_up;
  };
  static std::size_t index(messages::Channel channel) {
    return static_cast<std::size_t>(channel) - 1;
  }
  /// Whether the newest message tells all.
  bool replaced(std::size_t i) const { return channels_[i].kept <= 1 && !lines_[i].catch_up; }
  Line& line(messages::Channel channel) { return lines_[index(channel)]; }

  std::vector<messages::ChannelText> channels_;
  Listener listener_;
  std::array<Line, messages::kChannelCount> lines_{};
  std::vector<std::shared_ptr<Viewer>> viewers_;
};

}  // namespace tp100::server
