// Addresses of datagrams, and how they are sent.
#include "link/udp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "support/refusal.h"
#include "udp_receiver.h"

namespace tp100::link {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Udp, AddressesAreReadAsDocumented) {
  EXPECT_EQ(to_string(parse_udp("udp:47100", "--send")), "127.0.0.1:47100");
  EXPECT_EQ(to_string(parse_udp("udp:0.0.0.0:1", "--send")), "0.0.0.0:1");
  EXPECT_EQ(to_string(parse_udp("udp:bench-pc:65535", "--send")), "bench-pc:65535");
  EXPECT_EQ(parse_udp(std::string_view("udp:471009").substr(0, 9), "--send").port, 47100)
      << "what follows the text is not of the address";
}

/// Why the address is refused, in one line.
std::string refused(const std::string& text) {
  return test::refusal([&] { parse_udp(text, "--send"); });
}

TEST(Udp, WhatIsNoAddressIsAnErrorOfOneLineInPrintableCharacters) {
  for (const char* text :
       {"", "47100", "udp:", "udp:0", "udp:65536", "udp:-1", "udp:1x", "udp::1", "tcp:1",
        "udp:a b:1", "udp:::1:5", "udp:a\tb:5", "udp:a/b:5", "udp:1\n"}) {
    EXPECT_THAT(refused(text), HasSubstr("--send"));
    EXPECT_THAT(refused(text), Not(HasSubstr("\n")));
  }
  // The name of a host has at most 253 characters.
  const auto with_host = [](std::size_t size) { return "udp:" + std::string(size, 'h') + ":5"; };
  EXPECT_EQ(parse_udp(with_host(253), "--send").host.size(), 253U);
  EXPECT_NE(refused(with_host(254)), "");
  EXPECT_THAT(refused("a\x1f z~\x7f\xff."), HasSubstr("--send a? z~??.: not an address"));
  EXPECT_THAT(refused(std::string(100, 'x') + "y"),
              HasSubstr(" " + std::string(100, 'x') + "...: not an address"));
}

TEST(Udp, AHostIsLookedUpWithItsPortAndAWrongOneIsAnErrorAtOnce) {
  const sockaddr_in address = resolve({.host = "127.0.0.2", .port = 0x1234});
  EXPECT_EQ(address.sin_family, AF_INET);
  EXPECT_EQ(address.sin_addr.s_addr, htonl(0x7f000002));
  EXPECT_EQ(address.sin_port, htons(0x1234));
  EXPECT_THROW(resolve({.host = "::1", .port = 1}), UserError) << "addresses are IPv4";
  EXPECT_THAT(test::refusal([] { resolve({.host = "no.such.host.invalid", .port = 71}); }),
              HasSubstr("udp:no.such.host.invalid:71: no such host ("));
  // Nobody asked for broadcasts.
  EXPECT_THAT(test::refusal([] { UdpSender({.host = "255.255.255.255", .port = 9}); }),
              HasSubstr("udp:255.255.255.255:9: cannot send there ("));
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

}  // namespace
}  // namespace tp100::link
