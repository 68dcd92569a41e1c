// The check of the tracks from the page: the real daemon hands over its port, the emulated robot's
// tracks run, and every way to stop them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "../server/service_call.h"
#include "process.h"
#include "server/service.h"

namespace tp100::test {
namespace {

using nlohmann::json;
using server::Service;
using ::testing::HasSubstr;
using ::testing::Not;

/// A viewer that calls services.
class Caller {
 public:
  explicit Caller(const std::string& port) : client_(port) {
    client_.read_until("advertiseServices");
    client_.take();
  }

  /// The answer, or the reason of a refusal as text.
  json call(Service service, json request) {
    if (server::sets_in_motion(service)) request.update(json::parse("{" + client_.consent() + "}"));
    const std::string text = server::ask(client_, service, request.dump());
    const json answer = json::parse(text.substr(text.front() == '{' ? 0 : server::kResponseHead));
    return answer.contains("op") ? answer["message"] : answer;
  }

 private:
  server::WebClient client_;
};

class WheelsUpFromThePage : public testing::Test {
 protected:
  void start(const Words& robot = {}) {
    robot_ = start_robot(port(), robot);
    daemon_ = std::make_unique<Process>(
        std::vector<std::string>{"tp100d", "run", "--port", port(), "--stay", "--wait", "--listen",
                                 "127.0.0.1:0", "--setup", "stand"});
    page_ = page_port(*daemon_);
    ASSERT_TRUE(daemon_->wait_for("-> ready")) << daemon_->output();
    caller_ = std::make_unique<Caller>(page_);
  }
  /// Begins a check as soon as the robot is at rest.
  void begin() {
    json answer;
    ASSERT_TRUE(eventually([&] {
      answer = caller_->call(Service::kWheelsUpBegin, {{"tracks", "free"}});
      return answer.is_object();
    })) << answer;
    token_ = answer["token"];
    begun_ = robot_->output().size();
  }
  /// Sends one watch request; `more`: with an answer.
  json watch(const json& more = json::object()) {
    const std::chrono::duration<double, std::milli> now =
        std::chrono::steady_clock::now().time_since_epoch();
    json request = {{"token", token_}, {"input_ms", now.count()}};
    request.update(more);
    return caller_->call(Service::kWheelsUpWatch, request);
  }
  /// Watches until the check has ended; questions are answered by the first choice.
  json watched() {
    json answer, reply = json::object();
    EXPECT_TRUE(eventually([&] {
      answer = watch(std::exchange(reply, json::object()));
      if (answer.contains("question"))
        reply = {{"question", answer["question"]["number"]},
                 {"answer", answer["question"]["choices"][0]["answer"]}};
      return answer.is_string() || answer.contains("result");
    })) << answer;
    return answer;
  }
  /// The robot's output since the check began.
  std::string robot_output() { return robot_->output().substr(begun_); }
  /// The robot's reason why the motors are off; empty: they run.
  std::string last_cause() {
    if (robot_ == nullptr) return {};
    const std::string all = robot_->output();
    const std::size_t off = all.rfind("motors off: "), on = all.rfind("motors on");
    if (off == std::string::npos || (on != std::string::npos && on > off)) return {};
    const std::size_t begin = off + std::strlen("motors off: ");
    return all.substr(begin, all.find_first_of(";\n", begin) - begin);
  }
  /// Watches until a track runs.
  void run_tracks() {
    ASSERT_TRUE(eventually([&] {
      return watch().contains("result") || robot_output().find("motors on") != std::string::npos;
    })) << robot_->output();
  }
  /// The result of a check in which `meanwhile` happens. On a busy machine the firmware may stop
  /// the tracks before, or no watch request may arrive for too long: then the check is begun again.
  json checked(const std::function<json()>& meanwhile) {
    json result;
    for (int tries = 0; tries < 5; ++tries) {
      begin();
      const json answer = meanwhile();
      // The check had ended before anybody watched.
      if (!answer.is_object() || !answer.contains("result")) continue;
      result = answer["result"];
      const std::string why = line(result, "wheels-up");
      const auto because = [&](const char* of) { return why.find(of) != std::string::npos; };
      if (!because("by itself") && !because("silent") && !because("no session") &&
          !because("not connected") && (!because("nobody watched") || alone_))
        break;
    }
    return result;
  }
  static std::string line(const json& result, const std::string& name) {
    for (const json& row : result["findings"])
      if (row["name"] == name)
        return row["severity"].get<std::string>() + ": " + row["seen"].get<std::string>();
    return result.dump();
  }
  std::string port() const { return folder_.file("tp100"); }

  TemporaryFolder folder_;
  std::unique_ptr<Process> robot_, daemon_;
  std::unique_ptr<Caller> caller_;
  std::string page_, token_;
  std::size_t begun_ = 0;
  bool alone_ = false;  // the test stops watching on purpose
};

TEST_F(WheelsUpFromThePage, MovesNothingBeforeItIsConfirmedAndFindsAGoodRobotWell) {
  start();
  EXPECT_THAT(caller_->call(Service::kWheelsUpBegin, json::object()).get<std::string>(),
              HasSubstr("tracks = \"free\""));
  EXPECT_THAT(watch().get<std::string>(), HasSubstr("no check has this token"));
  EXPECT_THAT(robot_->output(), Not(HasSubstr("motors on")));
  const json result = checked([&] { return watched(); });
  EXPECT_EQ(result["errors"], 0) << result;
  EXPECT_THAT(line(result, "left-track"), HasSubstr("ok: "));
  EXPECT_THAT(line(result, "right-track"), HasSubstr("ok: "));
  EXPECT_THAT(robot_output(), HasSubstr("motors off: disarm"));
  // The daemon has the robot again, and starts nothing.
  EXPECT_THAT(daemon_->output(), HasSubstr("handed over to the check of the tracks"));
  EXPECT_TRUE(eventually([&] {
    const std::string output = daemon_->output();
    return output.find("-> ready", output.find("handed over to the check")) != std::string::npos;
  })) << daemon_->output();
  EXPECT_THAT(daemon_->output(), Not(HasSubstr("-> arming")));
  EXPECT_EQ(checked([&] { return watched(); })["errors"], 0) << "a second check, confirmed anew";
}

TEST_F(WheelsUpFromThePage, AsksOnAStand) {
  start({"--setup", "stand"});
  const json result = checked([&] { return watched(); });
  EXPECT_THAT(line(result, "left-track"), HasSubstr("ok: "));
  // Nobody turns the emulated robot by hand.
  EXPECT_THAT(line(result, "gyro"), HasSubstr("error: "));
}

TEST_F(WheelsUpFromThePage, StopOfAnyViewerStopsTheTracksAndIsAcknowledged) {
  start();
  json result, stop = json::object();
  // On a busy machine the answer may come too late.
  for (int tries = 0; tries < 5 && stop.value("acknowledged", false) == false; ++tries) {
    result = checked([&] {
      run_tracks();
      stop = Caller(page_).call(Service::kStop, json::object());
      return watched();
    });
  }
  EXPECT_THAT(line(result, "wheels-up"), HasSubstr("error: stopped before it was complete"));
  EXPECT_THAT(robot_output(), HasSubstr("motors off: disarm"));
  EXPECT_TRUE(stop["acknowledged"]) << stop << "; the robot has stopped, whoever has its port";
}

TEST_F(WheelsUpFromThePage, TracksStandStillWhenNobodyWatches) {
  start();
  alone_ = true;
  const json result = checked([&] {
    run_tracks();
    EXPECT_TRUE(robot_->wait_for("motors off")) << "the check ends by itself";
    return watched();
  });
  EXPECT_THAT(line(result, "wheels-up"), HasSubstr("error: nobody watched"));
}

TEST_F(WheelsUpFromThePage, TheLossOfItsViewerStopsTheTracks) {
  start();
  const std::string lost = "the check of the tracks has ended: its viewer has disconnected";
  // On a busy machine the check may end for another reason before.
  for (int tries = 0; tries < 5 && daemon_->output().find(lost) == std::string::npos; ++tries) {
    const std::size_t before = daemon_->output().size();
    begin();
    run_tracks();
    caller_.reset();
    ASSERT_TRUE(eventually([&] {
      return daemon_->output().find("the check of the tracks has ended: ", before) !=
             std::string::npos;
    })) << daemon_->output();
    caller_ = std::make_unique<Caller>(page_);
  }
  EXPECT_THAT(daemon_->output(), HasSubstr(lost));
  EXPECT_EQ(last_cause(), "disarm") << robot_->output();
}

TEST_F(WheelsUpFromThePage, TheEndOfTheDaemonStopsTheTracks) {
  // On a busy machine the firmware may be faster.
  for (int tries = 0; tries < 5 && last_cause() != "disarm"; ++tries) {
    start();
    begin();
    run_tracks();
    daemon_->signal(SIGTERM);
    daemon_->wait();
    ASSERT_TRUE(eventually([&] { return !last_cause().empty(); })) << robot_->output();
  }
  EXPECT_EQ(last_cause(), "disarm") << robot_->output();
}

}  // namespace
}  // namespace tp100::test
