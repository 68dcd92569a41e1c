#include "link/udp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
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
  EXPECT_THROW(resolve({.host = "no.such.host.invalid", .port = 1}), SetupError);
}

TEST(Udp, DatagramsArriveAndAMissingListenerIsNoHarm) {
  auto receiver = std::make_unique<UdpReceiver>();
  UdpSender sender({.port = receiver->port()});
  EXPECT_TRUE(sender.send("one"));
  EXPECT_EQ(receiver->wait(), "one");
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
}

}  // namespace
}  // namespace tp100::link
