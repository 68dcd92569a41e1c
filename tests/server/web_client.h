#pragma once
// A minimal WebSocket client on a plain socket, so that it can also misbehave.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "messages/channels.h"

namespace tp100::server {

enum class Service : std::uint32_t;
/// Whether its requests carry a consent.
bool sets_in_motion(Service service);

/// Connects to that port; the caller closes the descriptor. Throws std::runtime_error.
int dial(const std::string& port, const std::string& address = "127.0.0.1");
/// Sends `request` and returns everything until the server closes the connection.
std::string http_get(const std::string& port, const std::string& request);
/// Sends `request` and returns the header of the response.
std::string http_head(const std::string& port, const std::string& request);

class WebClient {
 public:
  /// Connects and upgrades. Throws std::runtime_error if it is refused.
  explicit WebClient(const std::string& port, const std::string& address = "127.0.0.1",
                     const std::string& headers = "");
  ~WebClient();
  WebClient(WebClient&& other) noexcept;
  WebClient& operator=(WebClient&& other) noexcept;

  void write_text(const std::string& text);
  void write_binary(const std::string& bytes);
  /// Writes the header of a binary frame that announces this size.
  void write_raw_header(std::uint64_t size);
  void write_raw(const std::string& bytes);
  void subscribe(messages::Channel channel);
  /// Calls a service with that request as JSON, for the call of that number. Without a request, one
  /// that sets the robot in motion gets the consent of a person who looks at the page now.
  void call(Service service, const std::string& request = "", char number = 1);
  /// `"stops":N,"t_s":T` of the next /state; without a subscription to it from one of its own,
  /// whose messages are not among those below. Throws if none arrives within a minute.
  std::string consent();

  /// Reads the available bytes without waiting. The last 200 messages are kept.
  void drain();
  /// Messages received since the last call.
  std::vector<std::string> take();
  /// Number of messages received.
  std::size_t received() const { return received_; }
  /// Waits for the first unread message that contains `part` and returns it. Throws after a minute.
  std::string read_until(const std::string& part);
  /// The number after the last received `key`; 0 if there is none yet.
  std::uint64_t number_after(const std::string& key);
  bool closed();

 private:
  void frame(std::uint8_t opcode, const std::string& payload);
  void take_frames();

  int fd_ = -1;
  std::string in_;
  std::vector<std::string> messages_;
  std::string state_;  // the newest of consent()
  bool watches_state_ = false;
  std::uint64_t number_ = 0;
  std::size_t received_ = 0;
  bool closed_ = false;
};

}  // namespace tp100::server
