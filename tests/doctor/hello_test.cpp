#include "doctor/hello.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::doctor {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

/// The payload of a hello.
std::array<std::uint8_t, wire::Hello::kSize> payload(std::uint16_t protocol, std::uint32_t schema) {
  wire::Hello hello{};
  hello.protocol = protocol;
  hello.firmware[0] = 3;
  hello.firmware[1] = 20;
  hello.firmware[2] = 100;
  hello.schema = schema;
  hello.board = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
  hello.boot_nonce = 7;
  std::array<std::uint8_t, wire::Hello::kSize> bytes{};
  wire::Writer writer(bytes.data());
  hello.visit(writer);
  return bytes;
}

TEST(HelloReply, NamesBoardFirmwareAndProtocol) {
  const auto bytes = payload(wire::kProtocolVersion, wire::kSchemaHash);
  const HelloReply hello = read_hello(bytes.data(), bytes.size());
  EXPECT_TRUE(hello.ours);
  EXPECT_EQ(hello.text,
            "a Mega 2560, firmware 3.20.100, protocol " + std::to_string(wire::kProtocolVersion));
}

TEST(HelloReply, SaysThatTheRobotIsSimulatedInsideTheBoard) {
  auto bytes = payload(wire::kProtocolVersion, wire::kSchemaHash);
  bytes[9] = static_cast<std::uint8_t>(wire::BoardType::kFakeRobot);
  EXPECT_THAT(read_hello(bytes.data(), bytes.size()).text,
              HasSubstr("robot simulated inside the board"));
}

TEST(HelloReply, OfAnotherVersionNamesBothAndAsksForFlashing) {
  const auto other = payload(wire::kProtocolVersion + 1, 0xABCD);
  // Only the first nine bytes of a hello are guaranteed in every version.
  for (const std::size_t size : {std::size_t{9}, other.size()}) {
    const HelloReply hello = read_hello(other.data(), size);
    EXPECT_FALSE(hello.ours);
    EXPECT_THAT(hello.text, HasSubstr("firmware 3.20.100"));
    EXPECT_THAT(hello.text, HasSubstr("schema 0000abcd"));
    EXPECT_THAT(hello.text,
                EndsWith("; flash the board with scripts/flash (installed: tp100-flash)"));
  }
}

TEST(HelloReply, ThatIsTooShortIsNone) {
  const auto bytes = payload(wire::kProtocolVersion, wire::kSchemaHash);
  EXPECT_EQ(read_hello(bytes.data(), 8).text, "");
}

}  // namespace
}  // namespace tp100::doctor
