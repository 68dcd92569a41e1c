#include "server/local_daemons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.h"
#include "server/access.h"

namespace tp100::server {
namespace {

using Json = nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const LocalDaemon kFirst{"127.0.0.1", 8765, "ab12"};
const LocalDaemon kSecond{"::1", 8766, "cd34"};

/// As /proc/net/unix shows an abstract socket.
std::string row(const std::string& name) {
  return "00000000d3f3330d: 00000002 00000000 00000000 0001 01 64140 @" + name + "\n";
}

TEST(LocalDaemons, AreKnownWhileTheyRun) {
  // No other process uses it.
  const std::string session = random_name();
  const LocalDaemon one{"127.0.0.1", 1, session}, other{"::1", 2, session};
  std::optional<Announcement> first(one);
  {
    const Announcement second(other);
    EXPECT_THAT(local_daemons(), Contains(one));
    EXPECT_THAT(local_daemons(), Contains(other));
  }
  EXPECT_THAT(local_daemons(), Contains(one));
  EXPECT_THAT(local_daemons(), Not(Contains(other)));
  first.reset();
  EXPECT_THAT(local_daemons(), Not(Contains(one)));
}

TEST(LocalDaemons, AKilledProcessLeavesNoEntry) {
  const LocalDaemon killed{"127.0.0.1", 3, random_name()};
  int announced[2];
  ASSERT_EQ(::pipe(announced), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const Announcement announcement(killed);
    const char byte = 1;
    if (::write(announced[1], &byte, 1) != 1) ::_exit(1);
    for (;;) ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(announced[0], &byte, 1), 1);
  EXPECT_THAT(local_daemons(), Contains(killed));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_THAT(local_daemons(), Not(Contains(killed)));
  ::close(announced[0]);
  ::close(announced[1]);
}

TEST(LocalDaemons, AreReadFromTheKernelsTable) {
  const std::string table =
      "Num       RefCount Protocol Flags    Type St Inode Path\n" + row("tp100d/::1/8766/cd34") +
      "00000000a: 00000002 00000000 00000000 0001 03 7 /run/tp100d/127.0.0.1/1/aa\n"
      "00000000b: 00000003 00000000 00000000 0001 03 8\n" +
      row("dbus-x") + row("tp100d/127.0.0.1/8765/ab12");
  EXPECT_THAT(daemons_in(table), ElementsAre(kFirst, kSecond));
}

TEST(LocalDaemons, HostileNamesAreSkippedAndAFloodOfNamesIsCut) {
  std::vector<std::string> names = words(
      "127.0.0.1 127.0.0.1/1 127.0.0.1/1/ 127.0.0.1//ab 127.0.0.1/0/ab 127.0.0.1/01/ab "
      "127.0.0.1/65536/ab 127.0.0.1/-1/ab 127.0.0.1/1x/ab evil.example/1/ab localhost/1/ab /1/ab "
      "127.0.0.1/1/AB 127.0.0.1/1/ab/c 127.0.0.1/1/<b> 127.0.0.1/1/\"\xff fe80::1%eth0/1/ab");
  names.insert(names.end(),
               {"", "127.0.0.1/1/ab ", std::string("127.0.0.1/1/a\0b", 15),
                "127.0.0.1/1/" + std::string(33, 'a'), std::string(100'000, '1') + "/1/ab"});
  for (const std::string& rest : names)
    EXPECT_THAT(daemons_in(row("tp100d/" + rest)), IsEmpty()) << rest.substr(0, 60);
  EXPECT_THAT(daemons_in(""), IsEmpty());
  EXPECT_THAT(daemons_in(std::string(1'000, '\n')), IsEmpty());
  std::string table;
  for (int i = 1; i <= 10'000; ++i) table += row("tp100d/127.0.0.1/" + std::to_string(i) + "/ab");
  EXPECT_EQ(daemons_in(table).size(), 64U);
}

TEST(RobotPages, AreAddressesOfPages) {
  EXPECT_THAT(robot_pages(" http://10.0.0.7:8765, https://lab/ http://[::1]:80"),
              ElementsAre("http://10.0.0.7:8765/", "https://lab/", "http://[::1]:80/"));
  EXPECT_THAT(robot_pages(""), IsEmpty());
  std::vector<std::string> wrong = words(
      "10.0.0.7:8765 http:// ftp://lab http://lab/page http://me@lab http://lab:1:2 "
      "http://lab:port javascript:alert(1) http://lab?x http://lab\"x");
  wrong.push_back("http://" + std::string(300, 'a'));
  for (const std::string& bad : wrong) {
    try {
      robot_pages("http://good " + bad);
      ADD_FAILURE() << bad;
    } catch (const SetupError& error) {
      EXPECT_THAT(error.what(), HasSubstr("server.robots")) << bad;
      EXPECT_LT(std::string(error.what()).size(), 200U);
    }
  }
}

/// The addresses of the list, in their order; behind that of the page's own daemon a `*`.
std::string listed(const LocalDaemon& own, const std::string& host) {
  std::string urls;
  const std::vector<LocalDaemon> found = {
      kFirst, kSecond, {"0.0.0.0", 8767, "ef56"}, {"192.168.0.7", 8768, "0789"}};
  const Json answer = Json::parse(robots_json(own, found, {"http://far/"}, host));
  for (const Json& one : answer.at("robots"))
    urls += std::string(one.at("url")) + (one.contains("own") ? "* " : " ");
  return urls;
}

TEST(RobotList, LeadsToEachByTheNameOfThePage) {
  EXPECT_EQ(listed(kFirst, "localhost:8765"),
            "http://localhost:8765/* http://localhost:8766/ http://localhost:8767/ "
            "http://192.168.0.7:8768/ http://far/ ");
  EXPECT_EQ(listed(kSecond, "[::1]:8766"),
            "http://[::1]:8766/* http://[::1]:8765/ http://[::1]:8767/ http://192.168.0.7:8768/ "
            "http://far/ ");
  // A loopback address would lead another machine to itself.
  EXPECT_EQ(listed({"0.0.0.0", 8767, "ef56"}, "lab:8767"),
            "http://lab:8767/* http://192.168.0.7:8768/ http://far/ ");
  const Json two = Json::parse(robots_json(kFirst, {kFirst}, {"http://far/"}, "127.0.0.1:8765"));
  EXPECT_EQ(two.at("robots"),
            Json::parse(R"([{"url":"http://127.0.0.1:8765/","session":"ab12","own":true},)"
                        R"({"url":"http://far/"}])"));
}

TEST(PageOfTheMachine, HasTheSameNameAndThePortOfADaemon) {
  const std::vector<LocalDaemon> daemons = {kFirst, {"0.0.0.0", 80, "ef56"}};
  // Origin and host, in turn.
  const auto expect = [&](const char* text, bool accepted) {
    const std::vector<std::string> all = words(text);
    for (std::size_t i = 0; i + 1 < all.size(); i += 2)
      EXPECT_EQ(is_page_of(daemons, all[i], all[i + 1]), accepted) << all[i] << " " << all[i + 1];
  };
  expect(
      "http://127.0.0.1:8765 127.0.0.1:8766 http://LOCALHOST:8765 localhost:8766 "
      "http://[::1]:8765 [::1]:8766 http://lab lab:8766 http://[::1] [::1]:8766",
      true);
  expect(
      "http://127.0.0.1:8767 127.0.0.1:8766 http://127.0.0.1 127.0.0.2:8766 "
      "http://evil.example:8765 127.0.0.1:8766 http://10.0.0.9:8765 127.0.0.1:8766 "
      "http://127.0.0.1:8765 10.0.0.7:8766 https://127.0.0.1:8765 127.0.0.1:8766 "
      "http://127.0.0.1:8765x 127.0.0.1:8766 http://127.0.0.1:8765/ 127.0.0.1:8766 "
      "http://127.0.0.1:08765 127.0.0.1:8766 null 127.0.0.1:8766 http:// 127.0.0.1:8766",
      false);
  EXPECT_FALSE(is_page_of(daemons, "", ""));
  EXPECT_FALSE(is_page_of(daemons, "http://:8765", ""));
}

}  // namespace
}  // namespace tp100::server
