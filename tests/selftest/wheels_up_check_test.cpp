// The check of the tracks without a robot: who may begin and watch it, and the port that it is
// handed over. With a robot: tests/programs.
#include "selftest/wheels_up_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "core/clock.h"

namespace tp100::selftest {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;
using ::testing::HasSubstr;

TEST(PortHandover, IsGivenOnceItWasAskedForAndUntilItsEnd) {
  PortHandover handover;
  EXPECT_FALSE(handover.give("/dev/a")) << "nobody asked";
  EXPECT_FALSE(handover.given());
  handover.ask();
  EXPECT_FALSE(handover.given());
  std::thread holder([&] { EXPECT_TRUE(handover.give("/dev/a")); });
  EXPECT_EQ(handover.wait(60s), "/dev/a");
  holder.join();
  EXPECT_TRUE(handover.given());
  EXPECT_FALSE(handover.give("/dev/a")) << "it is given already";
  handover.end();
  EXPECT_FALSE(handover.given());
  EXPECT_FALSE(handover.give("/dev/a"));
  handover.ask();
  EXPECT_EQ(handover.wait(1ms), std::nullopt);
  EXPECT_FALSE(handover.give("/dev/a")) << "nobody waits any longer";
}

class WheelsUpCheckTest : public ::testing::Test {
 protected:
  std::string begin(const std::string& viewer = "viewer 3", HostNs now = monotonic_now()) {
    const Result<std::string> token = check_.begin(viewer, now);
    EXPECT_EQ(token.why(), "");
    return token ? *token : "";
  }
  Result<std::string> watch(const std::string& token, double input_ms, HostNs now) {
    return check_.watch({.arguments = {{{"token", token}, {"input_ms", input_ms}}},
                         .consent = {},
                         .by = {},
                         .now = now,
                         .state = {}});
  }
  Result<std::string> watch(const std::string& token) {
    return watch(token, input_ms_ += 1.0, monotonic_now());
  }
  /// Watches until the check has ended.
  Json result(const std::string& token) {
    const auto until = std::chrono::steady_clock::now() + 60s;
    while (std::chrono::steady_clock::now() < until) {
      const Result<std::string> seen = watch(token);
      EXPECT_EQ(seen.why(), "");
      const Json answer = Json::parse(*seen);
      if (answer.contains("result")) return answer["result"];
      std::this_thread::sleep_for(1ms);
    }
    return {};
  }

  double input_ms_ = 0.0;
  messages::EventQueue events_;
  WheelsUpCheck check_{{}, {}, events_};
};

TEST_F(WheelsUpCheckTest, EndsWithoutTheRobotIfThePortIsNotLent) {
  const std::string token = begin();
  EXPECT_TRUE(check_.on());
  EXPECT_THAT(check_.begin("viewer 4", monotonic_now()).why(), HasSubstr("under way"));
  EXPECT_THAT(watch("guessed").why(), HasSubstr("no check has this token"));
  const Json found = result(token);
  EXPECT_EQ(found["errors"], 1);
  EXPECT_THAT(std::string(found["findings"][0]["seen"]), HasSubstr("not at rest"));
  EXPECT_FALSE(check_.on());
}

TEST_F(WheelsUpCheckTest, SaysThatThePortCannotBeOpened) {
  std::string token = begin();
  ASSERT_TRUE(check_.handover().give("/dev/no-such-port"));
  const Json found = result(token);
  EXPECT_EQ(found["port"], "/dev/no-such-port");
  EXPECT_EQ(found["errors"], 1);
  EXPECT_THAT(found.dump(), HasSubstr("/dev/no-such-port: "));
  EXPECT_FALSE(check_.handover().given()) << "the daemon has its port again";
  token = begin("viewer 4");
  ASSERT_TRUE(check_.handover().give("/dev/no-such-port"));
  EXPECT_EQ(result(token)["errors"], 1) << "the next one may be another viewer's";
}

TEST_F(WheelsUpCheckTest, NobodyWatchesOnceItsViewerIsGone) {
  const std::string token = begin();
  EXPECT_TRUE(check_.watches());
  check_.lose("viewer 4");
  EXPECT_EQ(watch(token).why(), "");
  check_.lose("viewer 3");
  EXPECT_THAT(watch(token).why(), HasSubstr("no check has this token"));
}

// Signs of life that arrive a second late would keep the tracks running after the page is gone.
TEST_F(WheelsUpCheckTest, EndsIfThePathToItsViewerIsSlow) {
  const HostNs now = monotonic_now();
  const std::string token = begin("viewer 3", now);
  EXPECT_THAT(watch(token, 7.0, now + 400 * kNsPerMs).why(), HasSubstr("less than 0.3 s"));
  EXPECT_THAT(watch(token, 8.0, now + 401 * kNsPerMs).why(), HasSubstr("no check has this token"));
  std::vector<messages::EventQueue::Entry> told;
  while (told.empty()) told = events_.drain();
  EXPECT_THAT(told[0].event.text, HasSubstr("less than 0.3 s"));
  EXPECT_FALSE(check_.on());
}

TEST_F(WheelsUpCheckTest, AFrozenClockOfThePageIsNoSignOfLife) {
  const HostNs now = monotonic_now() - kNsPerS;
  const std::string token = begin("viewer 3", now);
  for (HostNs at = now; at < now + kNsPerS; at += 40 * kNsPerMs)
    ASSERT_EQ(watch(token, 7.0, at).why(), "");
  EXPECT_FALSE(check_.watches());
}

}  // namespace
}  // namespace tp100::selftest
