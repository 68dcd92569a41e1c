// The server on real sockets, with well-behaved clients.
#include "server/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include "runs/run_folder.h"
#include "server/service.h"
#include "server_rig.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(ServerTest, AnAddressThatIsNoneOrTakenIsAnErrorOfOneLine) {
  const auto refused = [&](const std::string& listen) {
    settings_.listen = listen;
    return test::refusal([&] { start(); });
  };
  for (const char* bad :
       {"", "8765", "here:8765", "127.0.0.1:", "127.0.0.1:70000", "127.0.0.1:80x", "192.0.2.1:0"}) {
    EXPECT_THAT(refused(bad), HasSubstr("--listen")) << bad;
    EXPECT_THAT(refused(bad), Not(HasSubstr("\n"))) << bad;
  }
  EXPECT_EQ(refused("127.0.0.1:0"), "");
  const auto first = std::move(server_);
  EXPECT_NE(refused("127.0.0.1:" + port_), "");
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
  EXPECT_THAT(get("/"), ::testing::AllOf(HasSubstr("200 OK"), HasSubstr("<html>cockpit"),
                                         HasSubstr("frame-ancestors 'none'")));
  EXPECT_THAT(get("/", "HEAD"),
              ::testing::AllOf(HasSubstr("Content-Length: 20"), Not(HasSubstr("<html>"))));
  step();
  EXPECT_TRUE(
      eventually([&] { return get("/healthz").find(R"("run":"running")") != std::string::npos; }));
  // A connection is kept for more requests.
  const std::string request = "GET / HTTP/1.1\r\n" + kHost + "\r\n";
  const std::string last = "GET /none HTTP/1.1\r\n" + kHost + "Connection: close\r\n\r\n";
  const std::string answer = http_get(port_, request + request + last);
  EXPECT_NE(answer.find("<html>"), answer.rfind("<html>"));
  EXPECT_THAT(answer, HasSubstr("404 Not Found"));
}

// A viewer would draw the robot on the old course for a moment, and a recording keep that.
TEST_F(ServerTest, TheFirstStepOfAnotherSetUpIsShownWithThatSetUp) {
  std::promise<void> taken;
  std::vector<std::string> finished;
  settings_.listen = "off";
  settings_.listener = [&, all = taken.get_future().share()](messages::Channel channel,
                                                             std::uint64_t, std::string_view json) {
    if (channel == messages::Channel::kEvent) all.wait();
    const bool is_finished = json.find(R"("run":"finished")") != std::string_view::npos;
    if (channel == messages::Channel::kState && is_finished) finished.emplace_back(json);
  };
  start();
  server_->take(messages::Event{});  // its thread has to do while the rest arrives
  step();
  messages::RunContext other = messages::example_subject();
  other.setup = "terrain";
  server_->exchange(other, {}, {});
  record_.snapshot.run_state = RunState::kFinished;
  step();
  taken.set_value();
  server_->flush();
  ASSERT_FALSE(finished.empty());
  EXPECT_THAT(finished.front(), HasSubstr(R"("setup":"terrain")"));
}

// For want of memory, or by a defect.
TEST_F(ServerTest, ARequestThatThrowsEndsNeitherTheServerNorItsViewer) {
  start();
  WebClient client = connect();
  client.subscribe(messages::Channel::kEvent);
  client.read_until("\"serverInfo\"");
  controls_.no_memory = true;
  client.call(Service::kHold);
  EXPECT_THAT(client.read_until("memory is used up"), HasSubstr("what a viewer asked for"));
  controls_.no_memory = false;
  client.call(Service::kHold);
  EXPECT_TRUE(eventually([&] { return controls_.holds == 2; }));
  EXPECT_THAT(get("/healthz"), HasSubstr("200 OK"));
}

// Whatever a viewer asks for, and however long that takes, must not keep another one from stopping
// the robot, nor itself.
TEST_F(ServerTest, StopIsCarriedOutWhileNothingElseIs) {
  std::promise<void> end;
  controls_.held = end.get_future().share();
  start();
  WebClient asks = connect(), stops = connect();
  asks.call(Service::kHold);
  ASSERT_TRUE(eventually([&] { return controls_.holds == 1; }));
  stops.call(Service::kStop);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  asks.call(Service::kHold);
  asks.call(Service::kStop);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 2; }));
  WebClient late = connect();
  late.call(Service::kStop);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 3; }));
  const std::string stop("\x02\x03\0\0\0", 5);
  late.write_binary(stop);
  late.write_binary(stop + std::string("\x07\0\0\0\xff\xff\xff\xffno JSON", 15));
  EXPECT_TRUE(eventually([&] { return controls_.stops == 5; }));
  EXPECT_EQ(controls_.holds, 1);
  end.set_value();
  EXPECT_TRUE(eventually([&] { return controls_.holds == 2; }));
  server_->stop_answered(monotonic_now());
  for (WebClient* each : {&asks, &stops, &late})
    EXPECT_THAT(each->read_until("\"acknowledged\""), HasSubstr("acknowledged"));
}

// Requests that wait must not fill the memory, and STOP must get past them.
TEST_F(ServerTest, WhoAsksWithoutWaitingIsClosedAndHasBeenAbleToStop) {
  std::promise<void> end;
  controls_.held = end.get_future().share();
  start();
  WebClient asks = connect(), other = connect();
  asks.call(Service::kHold);
  ASSERT_TRUE(eventually([&] { return controls_.holds == 1; }));
  const std::string wish =
      R"({"op":"getParameters","parameterNames":[")" + std::string(20'000, 'x') + R"("],"id":"a"})";
  for (int i = 0; i < 8; ++i) asks.write_text(wish);
  asks.call(Service::kStop);
  EXPECT_TRUE(eventually([&] { return controls_.stops == 1; }));
  EXPECT_TRUE(eventually([&] {
    if (!asks.closed()) asks.write_text(wish);
    return asks.closed();
  }));
  EXPECT_FALSE(other.closed());
  end.set_value();
}

// The page on the same machine as a program that floods the daemon must go on working, and be
// loaded anew.
TEST_F(ServerTest, WhoAsksTooMuchIsClosedAndOthersOfItsAddressAreServed) {
  settings_.units_per_s = 100.0;
  start();
  WebClient polite = connect();
  const auto ask = [](WebClient& client) {
    client.write_text(R"({"op":"getParameters","parameterNames":[],"id":")" +
                      std::string(5'000, 'x') + "\"}");
  };
  for (int i = 1; i <= 20; ++i) {
    WebClient flood = connect();
    EXPECT_TRUE(eventually([&] {
      for (int k = 0; k < 100 && !flood.closed(); ++k) ask(flood);
      return flood.closed();
    }));
    polite.call(Service::kHold);
    EXPECT_TRUE(eventually([&] { return controls_.holds == i; }));
    flood = connect();
    flood.call(Service::kStop);
    EXPECT_TRUE(eventually([&] { return controls_.stops == i; }));
  }
  EXPECT_FALSE(polite.closed());
}

// A program that reads without end must not fill its thread's time, nor close the page's viewers.
TEST_F(ServerTest, WhoReadsTooMuchIsToldToWait) {
  settings_.units_per_s = 10.0;  // fewer than any machine asks for
  start();
  WebClient viewer = connect();
  EXPECT_TRUE(eventually([&] { return get("/healthz").find("429") != std::string::npos; }));
  viewer.call(Service::kHold);
  EXPECT_TRUE(eventually([&] { return controls_.holds == 1; }));
}

TEST_F(ServerTest, StopComesThroughBesideManyWhoReadRuns) {
  test::TemporaryFolder folder;
  settings_.content.runs_folder = folder.path();
  settings_.content.runs = [path = std::string(folder.path())] {
    return "{\"files\":" + std::to_string(runs::list_runs(path).size()) + "}";
  };
  for (int i = 0; i < 200; ++i) {
    const std::string run = folder.file(std::to_string(i));
    std::filesystem::create_directory(run);
    test::write_bytes(run + "/run.mcap", std::string(100'000, 'x'));
  }
  start();
  std::atomic<bool> over{false};
  std::atomic<int> lists{0}, files{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < 8; ++i)
    readers.emplace_back([&, i] {
      while (!over) {
        if (get("/api/runs").find("\"files\"") != std::string::npos) ++lists;
        const std::string run = "/runs/" + std::to_string(i);
        if (get(run + (i % 2 == 0 ? ".zip" : "/run.mcap")).size() > 100'000) ++files;
      }
    });
  WebClient viewer = connect();
  for (int i = 1; i <= 10; ++i) {
    viewer.call(Service::kStop);
    EXPECT_TRUE(eventually([&] { return controls_.stops == i; }));
  }
  EXPECT_TRUE(eventually([&] { return lists > 10 && files > 10; }));
  over = true;
  for (std::thread& reader : readers) reader.join();
}

// A killed process sends no close frame: the kernel closes its socket.
TEST_F(ServerTest, ADriverWhoseProcessIsKilledIsLostAtOnce) {
  record_.snapshot.run_state = RunState::kIdle;
  record_.snapshot.drive_refusal = StartRefusal::kNone;
  start();
  step();
  WebClient other = connect();
  {
    WebClient driver = connect();
    driver.call(Service::kDriveTake);
    driver.read_until("token");
    EXPECT_EQ(controls_.drivers_lost, 0);
  }
  EXPECT_TRUE(eventually([&] { return controls_.drivers_lost == 1; }));
}

}  // namespace
}  // namespace tp100::server
