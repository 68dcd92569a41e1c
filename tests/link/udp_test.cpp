#include "link/udp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/error.h"
#include "support/refusal.h"
#include "udp_receiver.h"

namespace tp100::link {
namespace {

using ::testing::HasSubstr;

TEST(Udp, AddressesAreReadAsDocumented) {
  EXPECT_EQ(to_string(parse_udp("udp:47100", "--send")), "127.0.0.1:47100");
  EXPECT_EQ(to_string(parse_udp("udp:0.0.0.0:1", "--send")), "0.0.0.0:1");
  EXPECT_EQ(to_string(parse_udp("udp:bench-pc:65535", "--send")), "bench-pc:65535");
  EXPECT_EQ(parse_udp(std::string_view("udp:471009").substr(0, 9), "--send").port, 47100)
      << "what follows the text is not of the address";
}

TEST(Udp, WhatIsNoAddressIsAnErrorOfOneLine) {
  for (const char* text : {"", "47100", "udp:", "udp:0", "udp:65536", "udp:-1", "udp:1x", "udp::1",
                           "tcp:1", "udp:a b:1", "udp:::1:5", "udp:1\n"}) {
    try {
      parse_udp(text, "--send");
      ADD_FAILURE() << text;
    } catch (const SetupError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--send"));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  // The name of a host has at most 253 characters.
  const auto with_host = [](const std::string& host) { return "udp:" + host + ":5"; };
  EXPECT_EQ(parse_udp(with_host(std::string(253, 'h')), "--send").host.size(), 253U);
  for (const std::string& host : {std::string(254, 'h'), std::string("a\tb"), std::string("a/b")})
    EXPECT_THROW(parse_udp(with_host(host), "--send"), SetupError) << host;
}

TEST(Udp, AWrongAddressIsShownInPrintableCharacters) {
  const auto message = [](const std::string& text) {
    return test::refusal([&] { parse_udp(text, "--send"); });
  };
  EXPECT_THAT(message("a\x1f\x20z~\x7f\xff"
                      "b"),
              HasSubstr("--send a? z~??b: not an address"));
  EXPECT_THAT(message(std::string(100, 'x') + "y"),
              HasSubstr(" " + std::string(100, 'x') + ": not an address"));
}

TEST(Udp, AHostIsLookedUpWithItsPort) {
  EXPECT_THROW(resolve({.host = "::1", .port = 1}), SetupError) << "addresses are IPv4";
  const sockaddr_in address = resolve({.host = "127.0.0.2", .port = 0x1234});
  EXPECT_EQ(address.sin_family, AF_INET);
  EXPECT_EQ(address.sin_addr.s_addr, htonl(0x7f000002));
  EXPECT_EQ(address.sin_port, htons(0x1234));
  try {
    resolve({.host = "no.such.host.invalid", .port = 71});
    ADD_FAILURE();
  } catch (const SetupError& error) {
    EXPECT_THAT(error.what(), HasSubstr("udp:no.such.host.invalid:71: no such host ("));
  }
}

TEST(Udp, WhereNothingMayBeSentIsAnErrorAtOnce) {
  try {
    UdpSender sender({.host = "255.255.255.255", .port = 9});
    ADD_FAILURE() << "nobody asked for broadcasts";
  } catch (const SetupError& error) {
    EXPECT_THAT(error.what(), HasSubstr("udp:255.255.255.255:9: cannot send there ("));
  }
}

TEST(Udp, EachDatagramIsSentOnceWhoeverListensAndOneThatIsTooLongIsTold) {
  auto receiver = std::make_unique<UdpReceiver>();
  UdpSender sender({.port = receiver->port()});
  EXPECT_FALSE(sender.send(std::string(65'508, 'x')));
  EXPECT_TRUE(sender.send(""));
  EXPECT_EQ(receiver->wait(), "");
  EXPECT_TRUE(sender.send("one"));
  EXPECT_EQ(receiver->wait(), "one");
  EXPECT_EQ(receiver->wait(20), "");
  const std::uint16_t port = receiver->port();
  receiver.reset();
  for (int i = 0; i < 5; ++i) sender.send("into the void");
  UdpReceiver again(port);
  EXPECT_TRUE(sender.send("two"));
  EXPECT_EQ(again.wait(), "two");
}

TEST(Udp, TheClockOfThisMachineHasOneName) {
  EXPECT_EQ(monotonic_clock_name(), monotonic_clock_name());
  EXPECT_FALSE(monotonic_clock_name().empty());
  EXPECT_LE(monotonic_clock_name().size(), 64U);
  std::string boot_id;
  if (std::ifstream("/proc/sys/kernel/random/boot_id") >> boot_id) {
    EXPECT_EQ(monotonic_clock_name(), boot_id);
  }
}

}  // namespace
}  // namespace tp100::link
