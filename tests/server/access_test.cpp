#include "server/access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tp100::server {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

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

TEST(Words, AreSeparatedBySpacesAndCommas) {
  EXPECT_THAT(words(" a, b\tc  "), ElementsAre("a", "b", "c"));
  EXPECT_THAT(words(""), IsEmpty());
}

}  // namespace
}  // namespace tp100::server
