#include "live/service_notice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "../support/notify_socket.h"
#include "../support/temporary_folder.h"

namespace tp100::live {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ServiceNoticeTest : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const test::NotifySocket manager_{folder_.file("notify")};
};

TEST_F(ServiceNoticeTest, SaysWhatHappensOverASocketByPathOrAnAbstractOne) {
  ServiceNotice notice({.socket = folder_.file("notify")});
  EXPECT_EQ(notice.ready(), "");
  notice.status("waits for a robot");
  notice.status("waits for a robot");
  notice.status("ready");
  notice.stopping();
  EXPECT_THAT(manager_.received(),
              ElementsAre("READY=1", "STATUS=waits for a robot", "STATUS=ready", "STOPPING=1"));
  const std::string name = "@tp100-notice-" + std::to_string(::getpid());
  const test::NotifySocket abstract(name);
  EXPECT_EQ(ServiceNotice({.socket = name}).ready(), "");
  EXPECT_THAT(abstract.received(), ElementsAre("READY=1"));
}

TEST_F(ServiceNoticeTest, TheWatchdogIsFedFourTimesAPeriodWhileTheLoopTurnsAndNotWhenItHangs) {
  ServiceNotice notice({.socket = folder_.file("notify"), .watchdog_ns = 2 * kNsPerS});
  notice.alive(0, 0);
  EXPECT_THAT(manager_.received(), IsEmpty()) << "it has not begun to cycle";
  for (HostNs now = 0; now < 4 * kNsPerS; now += 10 * kNsPerMs)
    notice.alive(static_cast<std::uint64_t>(1 + now / (5 * kNsPerMs)), now);
  EXPECT_THAT(manager_.received(), testing::AllOf(testing::SizeIs(8), testing::Each("WATCHDOG=1")));
  notice.alive(2000, 5 * kNsPerS);
  manager_.received();
  for (HostNs now = 5 * kNsPerS; now < 15 * kNsPerS; now += 10 * kNsPerMs) notice.alive(2000, now);
  EXPECT_THAT(manager_.received(), IsEmpty());
  notice.alive(2001, 15 * kNsPerS);
  EXPECT_THAT(manager_.received(), ElementsAre("WATCHDOG=1"));
}

TEST_F(ServiceNoticeTest, TheWatchdogIsFedWhileSomethingIsWaitedForAfterTheLoopsEnd) {
  using namespace std::chrono_literals;
  ServiceNotice notice({.socket = folder_.file("notify"), .watchdog_ns = kNsPerMs});
  const auto now = [] { return ServiceNotice::Time::clock::now(); };
  int looks = 0;
  EXPECT_TRUE(notice.wait(now() + 60s, [&looks](auto) {
    std::this_thread::sleep_for(5ms);
    return ++looks == 3;
  }));
  EXPECT_THAT(manager_.received(), testing::Contains("WATCHDOG=1").Times(testing::Ge(2)));
  EXPECT_FALSE(notice.wait(now() + 20ms, [](auto) { return false; }));
  EXPECT_TRUE(notice.wait(now() - 1s, [](auto) { return true; })) << "late, but done";
}

TEST_F(ServiceNoticeTest, AManagerThatDoesNotReadHoldsUpNobody) {
  ServiceNotice notice({.socket = folder_.file("notify")});
  for (int i = 0; i < 5000; ++i) notice.status(std::to_string(i));
  EXPECT_FALSE(manager_.received().empty());
}

TEST(ServiceNotice, AManagerThatCannotBeToldIsNamed) {
  const test::TemporaryFolder folder;
  ServiceNotice gone({.socket = folder.file("gone")});
  EXPECT_THAT(gone.ready(), testing::AllOf(HasSubstr(folder.file("gone") + ": "),
                                           HasSubstr("No such file"), HasSubstr("systemctl")));
  ServiceNotice deep({.socket = "/" + std::string(200, 'x')});
  EXPECT_THAT(deep.ready(), HasSubstr("name too long"));
}

class ServiceEnvironment : public testing::Test {
 protected:
  void TearDown() override {
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) ::unsetenv(name);
  }
};

TEST_F(ServiceEnvironment, SaysWhoListensAndHowLongItWaitsUnlessThatIsForAnotherProgram) {
  EXPECT_EQ(service_settings().socket, "");
  ::setenv("NOTIFY_SOCKET", "@manager", 1);
  EXPECT_EQ(service_settings().socket, "@manager");
  EXPECT_EQ(service_settings().watchdog_ns, 0);
  ::setenv("WATCHDOG_USEC", "2000000", 1);
  EXPECT_EQ(service_settings().watchdog_ns, 2 * kNsPerS);
  for (const bool own : {true, false}) {
    ::setenv("WATCHDOG_PID", std::to_string(own ? ::getpid() : ::getppid()).c_str(), 1);
    EXPECT_EQ(service_settings().watchdog_ns, own ? 2 * kNsPerS : 0);
  }
  ::unsetenv("WATCHDOG_PID");
  for (const char* text : {"", "2s", "-1", "99999999999999999999", "9223372036854775807"}) {
    ::setenv("WATCHDOG_USEC", text, 1);
    EXPECT_EQ(service_settings().watchdog_ns, 0) << text;
  }
}

}  // namespace
}  // namespace tp100::live
