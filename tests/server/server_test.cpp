// The server on real sockets, with well-behaved and hostile clients. No test depends on the speed
// of the machine: tests wait for conditions.
#include "server/server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <malloc.h>
#include <net/if.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <thread>

#include "../messages/fixtures.h"
#include "core/clock.h"
#include "core/error.h"
#include "fake_controls.h"
#include "runs/run_folder.h"
#include "server/connection.h"
#include "support/temporary_folder.h"
#include "web_client.h"

namespace tp100::server {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr unsigned char kPage[] = "<html>cockpit</html>";

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    settings_.listen = "127.0.0.1:0";
    settings_.page = [](std::string_view path) {
      return path == "/"
                 ? std::optional(PageFile{"text/html", {kPage, sizeof kPage - 1}, "\"1\"", ""})
                 : std::nullopt;
    };
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
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      record_.now_ns = record_.snapshot.now_ns = monotonic_now();
      ++record_.step;
      server_->take(record_);
    }
  }
  static bool eventually(const std::function<bool()>& condition) {
    for (int i = 0; i < 3000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }

  ServerSettings settings_;
  FakeControls controls_;
  std::unique_ptr<Server> server_;
  std::string port_;
  StepRecord record_ = messages::example_record();
};

TEST_F(ServerTest, AnAddressThatIsNoneOrTakenIsAnErrorOfOneLine) {
  for (const char* bad :
       {"", "8765", "here:8765", "127.0.0.1:", "127.0.0.1:70000", "127.0.0.1:80x", "192.0.2.1:0"}) {
    settings_.listen = bad;
    try {
      start();
      ADD_FAILURE() << bad;
    } catch (const SetupError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--listen")) << bad;
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    }
  }
  settings_.listen = "127.0.0.1:0";
  start();
  const auto first = std::move(server_);
  settings_.listen = "127.0.0.1:" + port_;
  EXPECT_THROW(start(), SetupError);
}

TEST_F(ServerTest, ItsListenerHearsAllOfItAlsoWhenNobodyIsServed) {
  for (const char* listen : {"127.0.0.1:0", "off"}) {
    std::map<messages::Channel, std::string> received;
    settings_.listen = listen;
    settings_.listener = [&](messages::Channel channel, std::uint64_t, std::string_view json) {
      received[channel] = json;
    };
    start();
    EXPECT_EQ(server_->url().empty(), std::string(listen) == "off");
    step();
    server_->take(messages::Event{.at_ns = monotonic_now(), .text = "something"});
    server_->flush();
    server_.reset();  // this also ends the thread that writes to `received`
    EXPECT_THAT(received[messages::Channel::kParameter], HasSubstr("control.gain")) << listen;
    EXPECT_THAT(received[messages::Channel::kEvent], HasSubstr("something")) << listen;
    EXPECT_THAT(received[messages::Channel::kLog], HasSubstr("something")) << listen;
    EXPECT_THAT(received[messages::Channel::kState], HasSubstr("\"run\":\"running\"")) << listen;
    for (const messages::Channel channel : {messages::Channel::kLink, messages::Channel::kLoop})
      EXPECT_NE(received[channel], "") << listen;
  }
}

TEST_F(ServerTest, ByItselfItTakesAnotherPortIfTheUsualOneIsTaken) {
  settings_.listen = "auto";
  start();
  const auto first = std::move(server_);
  start();
  EXPECT_NE(server_->url(), first->url());
  for (const Server* server : {first.get(), server_.get()}) {
    EXPECT_THAT(server->url(), HasSubstr("http://127.0.0.1:"));
    const bool usual = server->url() == "http://127.0.0.1:8765/";
    EXPECT_THAT(server->note(), HasSubstr(usual ? "" : "127.0.0.1:8765 is taken"));
    EXPECT_EQ(server->note().empty(), usual);
  }
}

TEST_F(ServerTest, ServesThePageAndSaysHowItIs) {
  start();
  EXPECT_THAT(http_get(port_, "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"),
              ::testing::AllOf(HasSubstr("200 OK"), HasSubstr("<html>cockpit"),
                               HasSubstr("frame-ancestors 'none'")));
  EXPECT_THAT(http_get(port_, "HEAD / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"),
              ::testing::AllOf(HasSubstr("Content-Length: 20"), Not(HasSubstr("<html>"))));
  step();
  EXPECT_TRUE(eventually([&] {
    return http_get(port_, "GET /healthz HTTP/1.0\r\nHost: localhost\r\n\r\n")
               .find(R"("run":"running")") != std::string::npos;
  }));
  EXPECT_THAT(http_get(port_, "GET /metrics HTTP/1.0\r\nHost: localhost\r\n\r\n"),
              ::testing::AllOf(HasSubstr("version=0.0.4"),
                               HasSubstr("tp100_run_state{state=\"running\"} 1\n")));
}

TEST_F(ServerTest, KeepsAConnectionForMoreRequests) {
  start();
  const std::string request = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";
  const std::string last = "GET /none HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n";
  const std::string answer = http_get(port_, request + request + last);
  std::size_t pages = 0;
  for (std::size_t at = 0; (at = answer.find("<html>", at)) != std::string::npos; ++at) ++pages;
  EXPECT_EQ(pages, 2U);
  EXPECT_THAT(answer, HasSubstr("404 Not Found"));
}

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
  const std::string upgrade =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";
  for (const std::string& rest : {std::string("Connection: close\r\n\r\n"), upgrade}) {
    const auto ask = [&](const std::string& head) {
      return http_head(port_, "GET / HTTP/1.1\r\n" + head + rest);
    };
    const char* good = rest == upgrade ? "101 Switching" : "200 OK";
    EXPECT_THAT(ask(host), HasSubstr(good));
    EXPECT_THAT(ask(host + "Origin: http://127.0.0.1:" + port_ + "\r\n"), HasSubstr(good));
    EXPECT_THAT(ask(host + "Origin: https://app.example\r\n"), HasSubstr(good));
    EXPECT_THAT(ask(host + "Origin: http://evil.example\r\n"), HasSubstr("403"));
    EXPECT_THAT(ask(host + "Origin: null\r\n"), HasSubstr("403"));
    EXPECT_THAT(ask("Host: evil.example\r\n"), HasSubstr("403"));
    EXPECT_THAT(ask(""), HasSubstr("403"));
  }
}

TEST_F(ServerTest, PagesOfOtherDaemonsOfTheMachineWatchAndStopAndDoNothingElse) {
  start();
  const std::string origin = "Origin: http://127.0.0.1:" + port_ + "\r\n";
  std::unique_ptr<Server> other = std::move(server_);
  start();
  WebClient client(port_, "127.0.0.1", origin);
  EXPECT_THAT(client.read_until("\"serverInfo\""), HasSubstr("\"commands\":\"stop\""));
  client.subscribe(messages::Channel::kState);
  client.read_until("\"run\"");
  client.call(2);
  EXPECT_THAT(client.read_until("serviceCallFailure"), HasSubstr("only stop"));
  client.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  EXPECT_EQ(controls_.holds, 0);
  // Such a page has no reason to ask for anything else.
  const std::string get = "GET /api/runs HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  EXPECT_THAT(http_head(port_, get + origin + "\r\n"), HasSubstr("403"));
  EXPECT_THROW(WebClient(port_, "127.0.0.1", "Origin: http://127.0.0.1:1\r\n"), std::runtime_error);
  EXPECT_THROW(WebClient(port_, "127.0.0.1", "Origin: http://evil.example:" + port_ + "\r\n"),
               std::runtime_error);
  other.reset();
  EXPECT_THROW(WebClient(port_, "127.0.0.1", origin), std::runtime_error);
}

TEST_F(ServerTest, ListsTheRobotsOfTheMachineAndTheNamedOnes) {
  start();
  const std::string url = server_->url();
  std::unique_ptr<Server> other = std::move(server_);
  settings_.name = "left";
  settings_.robots = {"http://10.0.0.7:8765/"};
  start();
  const auto list = [&] {
    return http_get(port_, "GET /api/robots HTTP/1.1\r\nHost: 127.0.0.1:" + port_ +
                               "\r\nConnection: close\r\n\r\n");
  };
  EXPECT_THAT(list(), HasSubstr("{\"robots\":[{\"url\":\"" + server_->url() + "\","));
  EXPECT_THAT(list(), HasSubstr("\"" + url + "\""));
  EXPECT_THAT(list(), HasSubstr("{\"url\":\"http://10.0.0.7:8765/\"}]}"));
  other.reset();
  EXPECT_THAT(list(), Not(HasSubstr(url)));
  WebClient client = connect();
  EXPECT_THAT(client.read_until("\"serverInfo\""), HasSubstr("\"name\":\"left\""));
}

TEST_F(ServerTest, BothSubProtocolsAreSpokenAndNoOther) {
  start();
  const auto upgrade = [&](const std::string& protocol) {
    return http_head(port_,
                     "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\n"
                     "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                     "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                         protocol + "\r\n");
  };
  EXPECT_THAT(upgrade("Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n"),
              HasSubstr("Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n"));
  EXPECT_THAT(upgrade("Sec-WebSocket-Protocol: foxglove.websocket.v1, foxglove.sdk.v1\r\n"),
              HasSubstr("Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n"));
  EXPECT_THAT(upgrade("Sec-WebSocket-Protocol: chat\r\n"), HasSubstr("400 Bad Request"));
  EXPECT_THAT(upgrade(""), HasSubstr("400 Bad Request"));
}

TEST_F(ServerTest, AViewerSeesStepsAndStops) {
  start();
  WebClient client = connect();
  EXPECT_THAT(client.read_until("\"serverInfo\""), HasSubstr("tp100d"));
  client.subscribe(messages::Channel::kEstimate);
  ASSERT_TRUE(eventually([&] {
    step();
    return client.has_data();
  }));
  EXPECT_THAT(client.read_until("\"odometry\""), HasSubstr("\"x_m\":0.22"));
  client.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  server_->stop_answered(monotonic_now());
  EXPECT_THAT(client.read_until("\"acknowledged\""), HasSubstr("true"));
}

TEST_F(ServerTest, CommandsComeOnlyFromWhereTheyMay) {
  settings_.commands = config::CommandsFrom::kNone;
  start();
  WebClient client = connect();
  client.call(2);
  EXPECT_THAT(client.read_until("serviceCallFailure"), HasSubstr("only stop"));
  client.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  EXPECT_EQ(controls_.holds, 0);
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
  EXPECT_EQ(strangers.size(), 16 - kKeptForLocal);
  // The same must hold for connections that send no request.
  std::vector<int> idle;
  for (std::size_t i = 0; i < 2 * kMaxConnections; ++i) idle.push_back(dial(port_, address));
  WebClient local = connect();
  local.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  for (const int fd : idle) ::close(fd);
}

TEST_F(ServerTest, StopDoesNotWaitForADiskThatEndsARecording) {
  controls_.slow_disk = true;
  start();
  WebClient recorder = connect(), watcher = connect();
  recorder.call(5);
  ASSERT_TRUE(eventually([&] {
    const std::lock_guard lock(controls_.mutex);
    return controls_.unanswered != nullptr;
  }));
  watcher.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  recorder.call(3);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 2; }));
  messages::RecordingFigures late;
  late.run = "late";
  controls_.unanswered("", late);
  EXPECT_THAT(recorder.read_until("\"bytes\""), HasSubstr("late"));
}

TEST_F(ServerTest, APageOfAnotherSiteCannotLoadWhatItMayNotSee) {
  settings_.runs = [] { return std::string("{}"); };
  start();
  const auto ask = [&](const std::string& target, const std::string& head) {
    return http_head(port_, "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + head +
                                "Connection: close\r\n\r\n");
  };
  for (const char* target : {"/", "/healthz", "/api/runs"}) {
    EXPECT_THAT(ask(target, ""), HasSubstr("200 OK"))
        << "programs other than browsers send no Sec-Fetch-Site";
    EXPECT_THAT(ask(target, "Sec-Fetch-Site: same-origin\r\n"), HasSubstr("200 OK"));
    EXPECT_THAT(ask(target, "Sec-Fetch-Site: none\r\n"), HasSubstr("200 OK"));
    for (const char* site : {"cross-site", "same-site"})
      EXPECT_THAT(ask(target, std::string("Sec-Fetch-Site: ") + site + "\r\n"),
                  HasSubstr("403 Forbidden"));
  }
  const std::string link =
      "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document\r\n";
  EXPECT_THAT(ask("/", link), HasSubstr("200 OK")) << "a link to the page must work";
  EXPECT_THAT(ask("/api/runs", link), HasSubstr("403 Forbidden"));
}

TEST_F(ServerTest, StopComesThroughBesideManyWhoReadRuns) {
  test::TemporaryFolder folder;
  settings_.runs_folder = folder.path();
  settings_.runs = [path = std::string(folder.path())] {
    return "{\"files\":" + std::to_string(runs::list_runs(path).size()) + "}";
  };
  for (int i = 0; i < 200; ++i) {
    const std::string run = folder.file(std::to_string(i));
    std::filesystem::create_directory(run);
    std::ofstream(run + "/run.mcap") << std::string(100'000, 'x');
  }
  start();
  std::atomic<bool> over{false};
  std::atomic<int> lists{0}, files{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < 8; ++i)
    readers.emplace_back([&, i] {
      const std::string run = "/runs/" + std::to_string(i) + "/run.mcap";
      const std::string rest = " HTTP/1.0\r\nHost: localhost\r\n\r\n";
      while (!over) {
        if (http_get(port_, "GET /api/runs" + rest).find("\"files\"") != std::string::npos) ++lists;
        if (http_get(port_, "GET " + run + rest).size() > 100'000) ++files;
      }
    });
  WebClient viewer = connect();
  for (int i = 1; i <= 10; ++i) {
    viewer.call(3);
    EXPECT_TRUE(eventually([&] { return controls_.stops == i; }));
  }
  EXPECT_TRUE(eventually([&] { return lists > 10 && files > 10; }));
  over = true;
  for (std::thread& reader : readers) reader.join();
}

TEST_F(ServerTest, ARunIsDownloadedWholeAsOneArchive) {
  test::TemporaryFolder folder;
  settings_.runs_folder = folder.path();
  std::filesystem::create_directory(folder.file("a"));
  test::write_bytes(folder.file("a/run.mcap"), std::string(500'000, 'x'));
  test::write_bytes(folder.file("a/poses.csv"), "t_s\n");
  start();
  const auto ask = [&](const std::string& method) {
    return http_get(port_, method + " /runs/a.zip HTTP/1.0\r\nHost: localhost\r\n\r\n");
  };
  const std::uint64_t bytes = runs::RunZip(folder.path(), "a").size();
  EXPECT_THAT(ask("HEAD"), HasSubstr("Content-Length: " + std::to_string(bytes)));
  const std::string answer = ask("GET");
  EXPECT_EQ(answer.size() - answer.find("PK"), bytes);
  EXPECT_THAT(answer, HasSubstr("a/poses.csvt_s\n"));
}

TEST_F(ServerTest, AMessageThatIsTooLongEndsTheClientBeforeItIsSent) {
  start();
  WebClient client = connect();
  client.write_raw_header(100'000'000);
  EXPECT_TRUE(eventually([&] {
    client.write_raw(std::string(64 * 1024, 'x'));
    return client.closed();
  }));
}

TEST_F(ServerTest, WhoSendsGarbageIsClosed) {
  start();
  WebClient client = connect();
  EXPECT_TRUE(eventually([&] {
    client.write_text("{\"op\":\"garbage\"}");
    return client.closed();
  }));
  WebClient broken = connect();
  EXPECT_TRUE(eventually([&] {
    broken.write_raw(std::string(1000, '\xff'));
    return broken.closed();
  }));
}

// A process that is killed says no goodbye: its socket is closed by the kernel.
TEST_F(ServerTest, ADriverWhoseProcessIsKilledIsLostAtOnce) {
  record_.snapshot.run_state = RunState::kIdle;
  record_.snapshot.drive_refusal = StartRefusal::kNone;
  start();
  step();
  WebClient other = connect();
  {
    WebClient driver = connect();
    driver.call(6);
    driver.read_until("token");
    EXPECT_EQ(controls_.drivers_lost, 0);
  }
  EXPECT_TRUE(eventually([&] { return controls_.drivers_lost == 1; }));
}

TEST_F(ServerTest, EndsWithViewersConnected) {
  start();
  WebClient polite = connect(), silent = connect();
  silent.subscribe(messages::Channel::kEstimate);
  step(10);
  server_.reset();
  EXPECT_TRUE(eventually([&] { return polite.closed(); }));
}

// Number of bytes that the program holds on the heap.
std::size_t heap() { return mallinfo2().uordblks; }

// Three of the 50 viewers are the hostile ones that the daemon must withstand: one never reads, one
// sends garbage, one sends frames of 100 MB. The thread sanitizer makes this test about twenty
// times slower.
#ifdef __SANITIZE_THREAD__
constexpr int kGoodViewers = 5, kStepsAtATime = 2;
#else
constexpr int kGoodViewers = 47, kStepsAtATime = 20;
#endif

TEST_F(ServerTest, FiftyViewersOfWhichThreeAreHostile) {
  start();
  std::vector<WebClient> good;
  for (int i = 0; i < kGoodViewers; ++i) good.push_back(connect());
  for (WebClient& client : good) client.subscribe(messages::pose_channel(PoseSource::kOdometry));
  WebClient deaf = connect();
  for (std::uint32_t channel = 1; channel <= messages::kChannelCount; ++channel)
    deaf.subscribe(static_cast<messages::Channel>(channel));

  std::atomic<bool> over{false};
  std::atomic<int> closed_garbage{0}, closed_large{0};
  const auto hostile = [&](std::atomic<int>& closed, const std::function<void(WebClient&)>& once) {
    return std::thread([&over, &closed, once, this] {
      while (!over) {
        try {
          WebClient client(port_);
          while (!over && !client.closed()) once(client);
          if (client.closed()) ++closed;
        } catch (const std::runtime_error&) {
        }
        std::this_thread::sleep_for(1ms);
      }
    });
  };
  std::thread garbage = hostile(closed_garbage, [](WebClient& client) {
    client.write_text("[[[[{{{{");
    client.write_raw(std::string(500, '\xa5'));
  });
  std::thread large = hostile(closed_large, [](WebClient& client) {
    client.write_raw_header(100'000'000);
    for (int i = 0; i < 100 && !client.closed(); ++i) client.write_raw(std::string(65536, 'x'));
  });

  // The good viewers receive their poses, the messages dropped for the deaf viewer are counted, and
  // both hostile viewers are disconnected again and again.
  WebClient watcher = connect();
  watcher.subscribe(messages::Channel::kClient);
  std::size_t before = 0, most = 0;
  std::uint64_t dropped = 0;
  const bool seen = eventually([&] {
    step(kStepsAtATime);
    if (before == 0) before = heap();
    most = std::max(most, heap());
    dropped = std::max(dropped, watcher.number_after("\"dropped_total\":"));
    std::size_t least = SIZE_MAX;
    for (WebClient& client : good) {
      client.drain();
      least = std::min(least, client.received());
    }
    return dropped > 50U * kStepsAtATime && least > 20 && closed_garbage > 1 && closed_large > 1;
  });
  over = true;
  garbage.join();
  large.join();
  EXPECT_TRUE(seen) << dropped << " dropped, closed " << closed_garbage << " and " << closed_large;
  for (std::size_t i = 0; i < good.size(); ++i)
    EXPECT_GT(good[i].received(), 20U) << "viewer " << i << (good[i].closed() ? ", closed" : "");
  // The limit covers 4 MiB of queues for the deaf viewer and the memory of 50 sockets and of
  // messages in transit.
  EXPECT_LT(most - std::min(before, most), 64U << 20U);
}

}  // namespace
}  // namespace tp100::server
