// Whose requests are served: by host, by origin, and from pages of other daemons of the machine,
// which the page lists.
#include "server/access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "server/local_daemons.h"
#include "support/refusal.h"

namespace tp100::server {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const AccessRules kRules{.hosts = {"robot.lab", "Other.Lab"},
                         .origins = {"https://app.foxglove.dev", "https://HERE.example"}};

TEST(Host, AddressesAndLocalhostAreTaken) {
  for (const char* host :
       {"127.0.0.1", "127.0.0.1:8765", "localhost:8765", "LOCALHOST", "[::1]", "[::1]:8765",
        "192.168.0.7:8765", "robot.lab", "Robot.Lab:80", "other.lab"})
    EXPECT_TRUE(host_allowed(host, kRules)) << host;
}

TEST(Host, NamesThatAnyoneCouldOwnAreNot) {
  for (const char* host :
       {"", "evil.example", "evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example",
        "127.0.0.1:8765:1", "127.0.0.1:port", "[::1", "[::1]x", "[evil]", "127.0.0.1@evil.example",
        ":8765", "127.0.0.1:123456"})
    EXPECT_FALSE(host_allowed(host, kRules)) << host;
}

TEST(Origin, ThePagesOwnAndTheListedOnesAreTaken) {
  EXPECT_TRUE(origin_allowed("", "127.0.0.1:8765", kRules));
  EXPECT_TRUE(origin_allowed("http://127.0.0.1:8765", "127.0.0.1:8765", kRules));
  EXPECT_TRUE(origin_allowed("http://LOCALHOST:8765", "localhost:8765", kRules));
  EXPECT_TRUE(origin_allowed("https://app.foxglove.dev", "127.0.0.1:8765", kRules));
  EXPECT_TRUE(origin_allowed("https://here.example", "127.0.0.1:8765", kRules));
}

TEST(Origin, EverybodyElsesIsNot) {
  for (const char* origin :
       {"null", "http://evil.example", "http://127.0.0.1:8766", "http://127.0.0.1",
        "http://localhost:8765", "https://app.foxglove.dev.evil.example", "http://app.foxglove.dev",
        "http://127.0.0.1:8765.evil.example", "file://"})
    EXPECT_FALSE(origin_allowed(origin, "127.0.0.1:8765", kRules)) << origin;
}

TEST(FetchSite, OnlyThePagesOwnRequestsAndTheUsersAreTaken) {
  for (const char* own : {"", "same-origin", "none"}) EXPECT_TRUE(fetch_site_allowed(own)) << own;
  for (const char* other : {"cross-site", "same-site", "Cross-Site"})
    EXPECT_FALSE(fetch_site_allowed(other)) << other;
}

using Json = nlohmann::json;

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
  Descriptor first = announce(one);
  {
    const Descriptor second = announce(other);
    EXPECT_THAT(local_daemons(), Contains(one));
    EXPECT_THAT(local_daemons(), Contains(other));
  }
  EXPECT_THAT(local_daemons(), Contains(one));
  EXPECT_THAT(local_daemons(), Not(Contains(other)));
  first = Descriptor();
  EXPECT_THAT(local_daemons(), Not(Contains(one)));
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
    const std::string why = test::refusal([&] { robot_pages("http://good " + bad); });
    EXPECT_THAT(why, HasSubstr("server.robots")) << bad;
    EXPECT_LT(why.size(), 200U);
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
