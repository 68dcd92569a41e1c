#pragma once
// Channels on one side, viewers on the other: who subscribed to what, what a newcomer gets, what
// waits. No socket; one thread.

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
#include "server/outbox.h"
#include "server/protocol.h"

namespace tp100::server {

/// One connected client.
class Viewer {
 public:
  /// `wake`: something waits in the outbox. `fail`: the client asks more than it reads.
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
  friend class Hub;
  void send(std::uint32_t subscription, std::uint64_t unix_ns,
            const std::shared_ptr<const std::string>& body);

  std::uint32_t id_;
  std::function<void()> wake_;
  std::function<void()> fail_;
  Outbox outbox_;
  std::map<std::uint32_t, messages::Channel> subscriptions_;
};

/// Hears what is said on every channel, without a subscription.
using Listener =
    std::function<void(messages::Channel, std::uint64_t unix_ns, std::string_view json)>;

class Hub {
 public:
  explicit Hub(std::vector<messages::ChannelText> channels, Listener listener = {});

  const std::vector<messages::ChannelText>& channels() const { return channels_; }

  /// Someone would get it, now or later.
  bool wanted(messages::Channel channel) const;
  void publish(messages::Channel channel, std::uint64_t unix_ns, std::string json);
  /// What a new subscriber of `channel` gets, instead of the last messages.
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
