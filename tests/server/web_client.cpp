#include "web_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "server/service.h"

namespace tp100::server {

int dial(const std::string& port, const std::string& to) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  ::inet_pton(AF_INET, to.c_str(), &address.sin_addr);
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
  if (fd < 0 || ::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error("cannot connect");
  // Browsers do the same: a second message must not wait for the acknowledgement of the first one.
  const int at_once = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
  return fd;
}

namespace {

constexpr std::size_t kKept = 200;
// Subscription of WebClient::consent(), unlike every channel's number.
constexpr char kConsent = 99;
constexpr std::size_t kDataHead = 13;

/// The number after `key`, as text.
std::string number_text(const std::string& json, const std::string& key) {
  const std::size_t at = json.find(key) + key.size();
  return json.substr(at, json.find_first_of(",}", at) - at);
}

// Writes `bytes` until the peer accepts no more for 100 ms.
bool send_all(int fd, const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t n =
        ::send(fd, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n > 0) {
      sent += static_cast<std::size_t>(n);
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) return false;
    pollfd wait{fd, POLLOUT, 0};
    if (::poll(&wait, 1, 100) == 0) return true;
  }
  return true;
}

/// The response to `request`: whole, or only its header.
std::string ask(const std::string& port, const std::string& request, bool only_head) {
  const int fd = dial(port);
  send_all(fd, request);
  std::string text;
  char buffer[4096];
  std::size_t end = std::string::npos;
  for (ssize_t n = 1; n > 0 && !(only_head && end != std::string::npos);
       end = text.find("\r\n\r\n")) {
    n = ::recv(fd, buffer, sizeof buffer, 0);
    if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
  }
  ::close(fd);
  return only_head && end != std::string::npos ? text.substr(0, end + 4) : text;
}

/// A message that subscribes to a channel.
std::string subscription(std::uint32_t id, messages::Channel channel) {
  return R"({"op":"subscribe","subscriptions":[{"id":)" + std::to_string(id) + R"(,"channelId":)" +
         std::to_string(static_cast<std::uint32_t>(channel)) + "}]}";
}

}  // namespace

std::string http_get(const std::string& port, const std::string& request) {
  return ask(port, request, false);
}
std::string http_head(const std::string& port, const std::string& request) {
  return ask(port, request, true);
}

WebClient::WebClient(const std::string& port, const std::string& address,
                     const std::string& headers)
    : fd_(dial(port, address)) {
  send_all(fd_,
           "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
           "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n" +
               headers + "\r\n");
  // The head is read byte by byte because frames may follow at once.
  std::string head;
  char byte = 0;
  while (!head.ends_with("\r\n\r\n") && ::recv(fd_, &byte, 1, 0) == 1) head += byte;
  if (head.find(" 101 ") == std::string::npos) {
    ::close(fd_);
    throw std::runtime_error("refused: " + head);
  }
}

WebClient::~WebClient() {
  if (fd_ >= 0) ::close(fd_);
}

WebClient::WebClient(WebClient&& other) noexcept { *this = std::move(other); }

WebClient& WebClient::operator=(WebClient&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(in_, other.in_);
  std::swap(messages_, other.messages_);
  std::swap(number_, other.number_);
  std::swap(received_, other.received_);
  std::swap(closed_, other.closed_);
  std::swap(state_, other.state_);
  std::swap(watches_state_, other.watches_state_);
  return *this;
}

void WebClient::write_raw(const std::string& bytes) {
  if (!closed_ && !send_all(fd_, bytes)) closed_ = true;
}

void WebClient::frame(std::uint8_t opcode, const std::string& payload) {
  std::string bytes = {static_cast<char>(0x80U | opcode)};
  // A mask of zeros leaves the payload unchanged.
  if (payload.size() < 126) {
    bytes += static_cast<char>(0x80U | payload.size());
  } else {
    bytes += static_cast<char>(0xFEU);
    bytes += static_cast<char>(payload.size() >> 8U);
    bytes += static_cast<char>(payload.size() & 0xFFU);
  }
  bytes.append(4, '\0');
  write_raw(bytes + payload);
}

void WebClient::write_text(const std::string& text) { frame(1, text); }
void WebClient::write_binary(const std::string& bytes) { frame(2, bytes); }

void WebClient::write_raw_header(std::uint64_t size) {
  std::string bytes = {'\x82', '\xff'};
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(size >> shift);
  bytes.append(4, '\0');
  write_raw(bytes);
}

void WebClient::subscribe(messages::Channel channel) {
  watches_state_ = watches_state_ || channel == messages::Channel::kState;
  write_text(subscription(static_cast<std::uint32_t>(channel), channel));
}

bool sets_in_motion(Service service) {
  return service == Service::kStart || service == Service::kResume ||
         service == Service::kDriveTake || service == Service::kWheelsUpBegin;
}

void WebClient::call(Service service, const std::string& request, char number) {
  const std::string head = {'\x02', static_cast<char>(service), 0, 0, 0, number, 0, 0, 0, 4, 0, 0,
                            0};
  // Whoever starts it by this program has put it there.
  const std::string where = service == Service::kStart ? R"("from":"start",)" : "";
  const std::string usual = "{" + (sets_in_motion(service) ? where + consent() : "") + "}";
  write_binary(head + "json" + (request.empty() ? usual : request));
}

std::string WebClient::consent() {
  if (!std::exchange(watches_state_, true))
    write_text(subscription(kConsent, messages::Channel::kState));
  drain();
  state_.clear();
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (state_.empty()) {
    if (closed_ || std::chrono::steady_clock::now() > end) throw std::runtime_error("no /state");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    drain();
  }
  return "\"stops\":" + number_text(state_, "\"stop\":{\"count\":") +
         ",\"t_s\":" + number_text(state_, "\"t_s\":");
}

void WebClient::drain() {
  char buffer[65536];
  while (!closed_) {
    const ssize_t n = ::recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT);
    if (n > 0) {
      in_.append(buffer, static_cast<std::size_t>(n));
    } else {
      if (n == 0 || (errno != EAGAIN && errno != EINTR)) closed_ = true;
      break;
    }
  }
  take_frames();
}

void WebClient::take_frames() {
  std::size_t at = 0;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(in_[at + i]); };
  for (;;) {
    if (in_.size() - at < 2) break;
    std::size_t size = byte(1), head = 2;
    const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (in_.size() - at < head + more) break;
    if (more > 0) size = 0;
    for (std::size_t i = 0; i < more; ++i) size = size << 8U | byte(2 + i);
    head += more;
    if (in_.size() - at < head + size) break;
    const unsigned opcode = byte(0) & 0xFU;
    std::string payload = in_.substr(at + head, size);
    at += head + size;
    if (opcode == 8) closed_ = true;
    if (opcode == 9) frame(10, payload);
    if (opcode != 1 && opcode != 2) continue;
    const bool data = opcode == 2 && payload.size() > kDataHead && payload[0] == 1;
    if (data && payload.find("\"stop\":{\"count\":") != std::string::npos)
      state_ = payload.substr(kDataHead);
    if (data && payload[1] == kConsent) continue;
    ++received_;
    messages_.push_back(std::move(payload));
    if (messages_.size() > kKept) messages_.erase(messages_.begin());
  }
  in_.erase(0, at);
}

bool WebClient::closed() {
  drain();
  return closed_;
}

std::string WebClient::read_until(const std::string& part) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  std::string others;
  while (std::chrono::steady_clock::now() < limit) {
    drain();
    while (!messages_.empty()) {
      const std::string message = std::move(messages_.front());
      messages_.erase(messages_.begin());
      if (message.find(part) != std::string::npos) return message;
      if (others.size() < 2000) others += "\n" + message.substr(0, 200);
    }
    if (closed_) break;
    pollfd wait{fd_, POLLIN, 0};
    ::poll(&wait, 1, 100);
  }
  throw std::runtime_error("nothing came with " + part + ", but" + others);
}

std::vector<std::string> WebClient::take() {
  drain();
  return std::exchange(messages_, {});
}

std::uint64_t WebClient::number_after(const std::string& key) {
  drain();
  for (const std::string& message : messages_) {
    const std::size_t at = message.find(key);
    if (at != std::string::npos) number_ = std::stoull(message.substr(at + key.size()));
  }
  messages_.clear();
  return number_;
}

}  // namespace tp100::server
