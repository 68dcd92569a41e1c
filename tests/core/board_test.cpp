#include "core/board.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tp100 {
namespace {

constexpr auto kMega = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
constexpr auto kNative = static_cast<std::uint8_t>(wire::BoardType::kNative);
constexpr auto kFake = static_cast<std::uint8_t>(wire::BoardType::kFakeRobot);
constexpr auto kUnknown = static_cast<std::uint8_t>(wire::BoardType::kUnknown);

TEST(Board, APortIsPhysicalUnlessPtyAndHelloProveAnEmulator) {
  EXPECT_TRUE(is_emulator(true, kNative));
  // A pty may be a serial server with a real robot behind it, or the robot may be a user's own.
  EXPECT_FALSE(is_emulator(true, kMega));
  EXPECT_FALSE(is_emulator(true, kUnknown));
  EXPECT_FALSE(is_emulator(true, 77));
  EXPECT_FALSE(is_emulator(false, kNative));
  EXPECT_FALSE(is_emulator(false, kMega));
}

TEST(Board, ARobotInsideItsBoardIsShownAsSimulatedButStartsAsARealOne) {
  EXPECT_EQ(robot_kind(true, kNative), RobotKind::kEmulated);
  EXPECT_EQ(robot_kind(false, kNative), RobotKind::kPhysical);
  EXPECT_EQ(robot_kind(false, kMega), RobotKind::kPhysical);
  for (const bool pseudo_terminal : {false, true}) {
    EXPECT_EQ(robot_kind(pseudo_terminal, kFake), RobotKind::kSimulated);
    EXPECT_FALSE(is_emulator(pseudo_terminal, kFake));
  }
}

TEST(Board, EveryKnownKindHasANameOfItsOwn) {
  std::set<std::string> names;
  int known = 0;
  for (int board = 0; board < 256; ++board) {
    const auto kind = static_cast<std::uint8_t>(board);
    if (is_known_board(kind)) {
      ++known;
      names.insert(board_name(kind));
    } else {
      EXPECT_STREQ(board_name(kind), "an unknown board") << board;
    }
  }
  EXPECT_EQ(known, 4);
  EXPECT_EQ(names.size(), 4u);
  EXPECT_EQ(names.count("an unknown board"), 0u);
}

}  // namespace
}  // namespace tp100
