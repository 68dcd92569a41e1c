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
  std::string watch(const std::string& token, std::string& json) {
    json.clear();
    return check_.watch({.token = token, .input_ms = input_ms_ += 1.0}, monotonic_now(), json);
  }
  /// Watches until the check has ended.
  Json result(const std::string& token) {
    std::string json;
    const auto until = std::chrono::steady_clock::now() + 60s;
    while (std::chrono::steady_clock::now() < until) {
      EXPECT_EQ(watch(token, json), "");
      const Json answer = Json::parse(json);
      if (answer.contains("result")) return answer["result"];
      std::this_thread::sleep_for(1ms);
    }
    return {};
  }

  double input_ms_ = 0.0;
  const server::Driver viewer_{.id = "viewer 3", .name = "viewer 3"};
  WheelsUpCheck check_{{}, {}};
};

TEST_F(WheelsUpCheckTest, EndsWithoutTheRobotIfThePortIsNotLent) {
  std::string token, json;
  ASSERT_EQ(check_.begin(viewer_, monotonic_now(), token), "");
  EXPECT_TRUE(check_.on());
  std::string other;
  EXPECT_THAT(check_.begin({.id = "viewer 4", .name = ""}, monotonic_now(), other),
              HasSubstr("under way"));
  EXPECT_THAT(watch("guessed", json), HasSubstr("no check has this token"));
  const Json found = result(token);
  EXPECT_EQ(found["errors"], 1);
  EXPECT_THAT(std::string(found["findings"][0]["seen"]), HasSubstr("not at rest"));
  EXPECT_FALSE(check_.on());
}

TEST_F(WheelsUpCheckTest, SaysThatThePortCannotBeOpened) {
  std::string token;
  ASSERT_EQ(check_.begin(viewer_, monotonic_now(), token), "");
  ASSERT_TRUE(check_.handover().give("/dev/no-such-port"));
  const Json found = result(token);
  EXPECT_EQ(found["port"], "/dev/no-such-port");
  EXPECT_EQ(found["errors"], 1);
  EXPECT_THAT(found.dump(), HasSubstr("/dev/no-such-port: "));
  EXPECT_FALSE(check_.handover().given()) << "the daemon has its port again";
  ASSERT_EQ(check_.begin({.id = "viewer 4", .name = ""}, monotonic_now(), token), "");
  ASSERT_TRUE(check_.handover().give("/dev/no-such-port"));
  EXPECT_EQ(result(token)["errors"], 1) << "the next one may be another viewer's";
}

TEST_F(WheelsUpCheckTest, NobodyWatchesOnceItsViewerIsGone) {
  std::string token, json;
  ASSERT_EQ(check_.begin(viewer_, monotonic_now(), token), "");
  EXPECT_TRUE(check_.watches());
  check_.lose("viewer 4");
  EXPECT_EQ(watch(token, json), "");
  check_.lose(viewer_.id);
  EXPECT_THAT(watch(token, json), HasSubstr("no check has this token"));
}

// Signs of life that arrive a second late would keep the tracks running after the page is gone.
TEST_F(WheelsUpCheckTest, EndsIfThePathToItsViewerIsSlow) {
  std::string token, json;
  const HostNs now = monotonic_now();
  ASSERT_EQ(check_.begin(viewer_, now, token), "");
  EXPECT_THAT(check_.watch({.token = token, .input_ms = 7.0}, now + 400 * kNsPerMs, json),
              HasSubstr("less than 0.3 s"));
  EXPECT_THAT(check_.watch({.token = token, .input_ms = 8.0}, now + 401 * kNsPerMs, json),
              HasSubstr("no check has this token"));
  std::string end;
  while (end.empty()) end = check_.take_end();
  EXPECT_THAT(end, HasSubstr("less than 0.3 s"));
  EXPECT_FALSE(check_.on());
}

TEST_F(WheelsUpCheckTest, AFrozenClockOfThePageIsNoSignOfLife) {
  std::string token, json;
  const HostNs now = monotonic_now() - kNsPerS;
  ASSERT_EQ(check_.begin(viewer_, now, token), "");
  for (HostNs at = now; at < now + kNsPerS; at += 40 * kNsPerMs) {
    json.clear();
    ASSERT_EQ(check_.watch({.token = token, .input_ms = 7.0}, at, json), "");
  }
  EXPECT_FALSE(check_.watches());
}

}  // namespace
}  // namespace tp100::selftest
