#pragma once
// What waits for one client: bounded, the oldest data goes first. No socket.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace tp100::server {

/// One WebSocket message; bodies are shared between clients.
struct Frame {
  bool binary = false;
  std::uint8_t head_size = 0;
  std::array<std::uint8_t, 13> head{};
  std::shared_ptr<const std::string> body;

  std::size_t size() const { return head_size + body->size(); }
};

class Outbox {
 public:
  static constexpr std::size_t kMaxData = 512;  ///< frames
  static constexpr std::size_t kMaxDataBytes = 4 << 20;
  static constexpr std::size_t kMaxReplies = 256;  ///< frames
  static constexpr std::size_t kMaxReplyBytes = 4 << 20;

  /// Queues one data frame; drops older ones, and counts them, if there is no room.
  void push_data(Frame frame);
  /// Queues an answer; answers go before data and are never dropped. False: the client asks more
  /// than it reads.
  [[nodiscard]] bool push_reply(Frame frame);

  bool empty() const { return data_.empty() && replies_.empty(); }
  std::size_t size() const { return data_.size() + replies_.size(); }
  /// The next frame to write. Must not be empty.
  Frame pop();

  std::uint64_t dropped() const { return dropped_; }

 private:
  std::deque<Frame> data_;
  std::deque<Frame> replies_;
  std::size_t data_bytes_ = 0;
  std::size_t reply_bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace tp100::server
