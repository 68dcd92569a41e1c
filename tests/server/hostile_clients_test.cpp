// The server on real sockets against clients that are hostile, foreign or too many.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <malloc.h>
#include <net/if.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/service.h"
#include "server/sockets.h"
#include "server_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;

TEST_F(ServerTest, WhatIsNoRequestIsRefusedOrClosed) {
  start();
  const std::string endless(20'000, 'a');
  for (const std::string& request :
       {std::string("\r\n\r\n"), std::string("nonsense\r\n\r\n"), std::string(4096, '\xff'),
        "GET /" + endless + " HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: " + endless + "\r\n\r\n",
        std::string("POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100000000\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 5\r\n\r\nhello")})
    EXPECT_THAT(http_get(port_, request), Not(HasSubstr("200 OK")));
  EXPECT_THAT(http_get(port_, "GET / HTTP/1.0\r\nHost: 127.0.0.1\r\n\r\n"), HasSubstr("200 OK"));
}

TEST_F(ServerTest, AForeignHostOrOriginIsRefusedForPageAndViewers) {
  settings_.access.origins = {"https://app.example"};
  start();
  const std::string host = "Host: 127.0.0.1:" + port_ + "\r\n";
  const std::string viewer = kUpgrade + "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n";
  for (const std::string& rest : {std::string(), viewer}) {
    const char* good = rest == viewer ? "101 Switching" : "200 OK";
    EXPECT_THAT(head_of("/", host + rest), HasSubstr(good));
    for (const std::string& own : {"http://127.0.0.1:" + port_, std::string("https://app.example")})
      EXPECT_THAT(head_of("/", host + "Origin: " + own + "\r\n" + rest), HasSubstr(good));
    for (const char* foreign : {"http://evil.example", "null"})
      EXPECT_THAT(head_of("/", host + "Origin: " + foreign + "\r\n" + rest), HasSubstr("403"));
    EXPECT_THAT(head_of("/", "Host: evil.example\r\n" + rest), HasSubstr("403"));
    EXPECT_THAT(head_of("/", rest), HasSubstr("403"));
  }
}

TEST_F(ServerTest, WhoMayNotCommandWatchesAndStopsAndDoesNothingElse) {
  start();
  // The page of another daemon of the machine, or any viewer if nobody may command.
  const std::string origin = "Origin: http://127.0.0.1:" + port_ + "\r\n";
  std::unique_ptr<Server> other = std::move(server_);
  for (const bool page : {false, true}) {
    settings_.commands = page ? config::CommandsFrom::kLocal : config::CommandsFrom::kNone;
    start();
    WebClient client(port_, "127.0.0.1", page ? origin : "");
    EXPECT_THAT(client.read_until("\"serverInfo\""), HasSubstr("\"commands\":\"stop\""));
    client.subscribe(messages::Channel::kState);
    client.read_until("\"run\"");
    client.call(Service::kHold);
    EXPECT_THAT(client.read_until("serviceCallFailure"), HasSubstr("only stop"));
    client.call(Service::kStop);
    EXPECT_TRUE(eventually([&] { return controls_.stops == (page ? 2 : 1); }));
    EXPECT_EQ(controls_.holds, 0);
  }
  // A page from another origin has no reason to request anything else.
  EXPECT_THAT(head_of("/api/runs", kHost + origin), HasSubstr("403"));
  EXPECT_THROW(WebClient(port_, "127.0.0.1", "Origin: http://127.0.0.1:1\r\n"), std::runtime_error);
  EXPECT_THROW(WebClient(port_, "127.0.0.1", "Origin: http://evil.example:" + port_ + "\r\n"),
               std::runtime_error);
  other.reset();
  EXPECT_THROW(WebClient(port_, "127.0.0.1", origin), std::runtime_error);
}

TEST_F(ServerTest, MoreViewersThanAllowedAreTurnedAway) {
  settings_.max_clients = 3;
  start();
  std::vector<WebClient> clients;
  for (int i = 0; i < 3; ++i) clients.push_back(connect());
  EXPECT_THROW(connect(), std::runtime_error);
  clients.pop_back();
  EXPECT_TRUE(eventually([&] {
    try {
      connect();
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  }));
}

/// An address of this machine other than loopback; empty if there is none.
std::string other_address() {
  std::string found;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return found;
  for (const ifaddrs* at = all; at != nullptr && found.empty(); at = at->ifa_next) {
    if (at->ifa_addr == nullptr || at->ifa_addr->sa_family != AF_INET) continue;
    if ((at->ifa_flags & IFF_LOOPBACK) != 0 || (at->ifa_flags & IFF_UP) == 0) continue;
    char text[INET_ADDRSTRLEN];
    const auto* address = reinterpret_cast<const sockaddr_in*>(at->ifa_addr);
    found = ::inet_ntop(AF_INET, &address->sin_addr, text, sizeof text);
  }
  ::freeifaddrs(all);
  return found;
}

TEST_F(ServerTest, StrangersCannotTakeThePlacesOfThisMachine) {
  const std::string address = other_address();
  if (address.empty()) GTEST_SKIP() << "this machine has no address but loopback";
  settings_.listen = "0.0.0.0:0";
  settings_.max_clients = 16;
  start();
  std::vector<WebClient> strangers;
  EXPECT_THROW(for (int i = 0; i < 100; ++i) strangers.emplace_back(port_, address),
               std::runtime_error);
  EXPECT_EQ(strangers.size(), 16 - SharedState::kKeptForLocal);
  // The same must hold for connections that send no request.
  std::vector<int> idle;
  for (std::size_t i = 0; i < 2 * SharedState::kMaxConnections; ++i)
    idle.push_back(dial(port_, address));
  WebClient local = connect();
  local.call(Service::kStop);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  for (const int fd : idle) ::close(fd);
}

TEST_F(ServerTest, APageOfAnotherSiteCannotLoadWhatItMayNotSee) {
  settings_.content.runs = [] { return std::string("{}"); };
  start();
  for (const char* target : {"/", "/healthz", "/api/runs"}) {
    EXPECT_THAT(head_of(target, kHost), HasSubstr("200 OK"))
        << "programs other than browsers send no Sec-Fetch-Site";
    for (const auto& [site, answer] :
         {std::pair("same-origin", "200 OK"), std::pair("none", "200 OK"),
          std::pair("cross-site", "403 Forbidden"), std::pair("same-site", "403 Forbidden")})
      EXPECT_THAT(head_of(target, kHost + "Sec-Fetch-Site: " + site + "\r\n"), HasSubstr(answer));
  }
  const std::string link = kHost +
                           "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\n"
                           "Sec-Fetch-Dest: document\r\n";
  EXPECT_THAT(head_of("/", link), HasSubstr("200 OK")) << "a link to the page must work";
  EXPECT_THAT(head_of("/api/runs", link), HasSubstr("403 Forbidden"));
}

// The thread sanitizer makes this test about twenty times slower.
#ifdef __SANITIZE_THREAD__
constexpr int kGoodViewers = 5, kStepsAtATime = 2;
#else
constexpr int kGoodViewers = 47, kStepsAtATime = 20;
#endif

// One viewer never reads, one sends garbage, one sends frames of 100 MB.
TEST_F(ServerTest, FiftyViewersOfWhichThreeAreHostile) {
  start();
  std::vector<WebClient> good;
  for (int i = 0; i < kGoodViewers; ++i) good.push_back(connect());
  for (WebClient& client : good) client.subscribe(messages::pose_channel(PoseSource::kOdometry));
  WebClient deaf = connect();
  for (std::uint32_t channel = 1; channel <= messages::kChannelCount; ++channel)
    deaf.subscribe(static_cast<messages::Channel>(channel));

  std::atomic<bool> over{false};
  std::atomic<int> closed[2] = {0, 0};
  std::vector<std::thread> hostile;
  for (const int large : {0, 1})
    hostile.emplace_back([&, large] {
      while (!over) {
        try {
          WebClient client(port_);
          while (!over && !client.closed()) {
            large ? client.write_raw_header(100'000'000) : client.write_text("[[[[{{{{");
            for (int i = 0; i < 20; ++i) client.write_raw(std::string(65'536, '\xa5'));
          }
          if (client.closed()) ++closed[large];
        } catch (const std::runtime_error&) {
        }
        std::this_thread::sleep_for(1ms);
      }
    });

  // The good viewers receive their poses, the messages dropped for the deaf viewer are counted, and
  // both hostile viewers are disconnected again and again.
  WebClient watcher = connect();
  watcher.subscribe(messages::Channel::kClient);
  std::size_t before = 0, most = 0;
  std::uint64_t dropped = 0;
  const bool seen = eventually([&] {
    step(kStepsAtATime);
    const std::size_t heap_bytes = mallinfo2().uordblks;
    if (before == 0) before = heap_bytes;
    most = std::max(most, heap_bytes);
    dropped = std::max(dropped, watcher.number_after("\"dropped_total\":"));
    std::size_t least = SIZE_MAX;
    for (WebClient& client : good) {
      client.drain();
      least = std::min(least, client.received());
    }
    return dropped > 50U * kStepsAtATime && least > 20 && closed[0] > 1 && closed[1] > 1;
  });
  over = true;
  for (std::thread& each : hostile) each.join();
  EXPECT_TRUE(seen) << dropped << " dropped, closed " << closed[0] << " and " << closed[1];
  for (WebClient& client : good) EXPECT_GT(client.received(), 20U);
  // The limit covers 4 MiB of queues for the deaf viewer and the memory of 50 sockets and of
  // messages in transit.
  EXPECT_LT(most - std::min(before, most), 64U << 20U);
}

}  // namespace
}  // namespace tp100::server
