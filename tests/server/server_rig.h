#pragma once
// A server on a real socket, whose steps the test makes. No test depends on the speed of the
// machine: tests wait for conditions.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "../messages/fixtures.h"
#include "../support/eventually.h"
#include "core/clock.h"
#include "fake_controls.h"
#include "server/server.h"
#include "web/bundle.h"
#include "web_client.h"

namespace tp100::server {

using test::eventually;

inline constexpr unsigned char kHtml[] = "<html>cockpit</html>";
inline constexpr web::File kPage = {"/", "text/html", "\"1\"", {kHtml, sizeof kHtml - 1}};
inline const std::string kHost = "Host: 127.0.0.1\r\n";
/// Header lines of a viewer, but for the sub-protocol.
inline const std::string kUpgrade =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    settings_.listen = "127.0.0.1:0";
    settings_.content.page = [](std::string_view path) { return path == "/" ? &kPage : nullptr; };
  }
  void start() {
    const messages::PublishClock clock{monotonic_now(), 1'700'000'000 * kNsPerS};
    server_ = std::make_unique<Server>(
        settings_, messages::Messages(messages::example_subject(), clock),
        std::vector<messages::ParameterText>{
            {{.name = "control.gain", .value = 16.0, .standard = 16.0, .range = {0.0, 200.0}},
             true}},
        controls_);
    server_->start();
    if (server_->url().empty()) return;
    port_ = server_->url().substr(server_->url().rfind(':') + 1);
    port_.pop_back();
  }
  WebClient connect() { return WebClient(port_); }
  /// The whole response to a request of one connection.
  std::string get(const std::string& target, const std::string& method = "GET") const {
    return http_get(port_, method + " " + target + " HTTP/1.0\r\nHost: localhost\r\n\r\n");
  }
  /// The header of the response to a request with these header lines.
  std::string head_of(const std::string& target, const std::string& lines) const {
    return http_head(port_, "GET " + target + " HTTP/1.1\r\n" + lines + "\r\n");
  }
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      record_.now_ns = record_.snapshot.now_ns = monotonic_now();
      ++record_.step;
      server_->take(record_);
    }
  }

  ServerSettings settings_;
  FakeControls controls_;
  std::unique_ptr<Server> server_;
  std::string port_;
  StepRecord record_ = messages::example_record();
};

}  // namespace tp100::server
