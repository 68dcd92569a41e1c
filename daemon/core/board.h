#pragma once
// The board that a hello names, and what moves when its robot drives. Pure.

#include <array>
#include <cstdint>
#include <string>

#include "core/enum_names.h"
#include "wire/messages.h"

namespace tp100 {

/// Name for people with its article; "an unknown board" for a kind that this version does not know.
/// `board`: as in the hello.
constexpr const char* board_name(std::uint8_t board) {
  switch (static_cast<wire::BoardType>(board)) {
    case wire::BoardType::kMega2560:
      return "a Mega 2560";
    case wire::BoardType::kNative:
      return "an emulated board";
    case wire::BoardType::kFakeRobot:
      return "a Mega 2560 with the robot simulated inside the board (FAKE_ROBOT)";
    case wire::BoardType::kUnknown:
      break;
  }
  return "an unknown board";
}

/// Whether this version knows the kind of board. An unknown one may drive if its
/// protocol version matches, after a warning.
constexpr bool is_known_board(std::uint8_t board) {
  return board >= static_cast<std::uint8_t>(wire::BoardType::kMega2560) &&
         board <= static_cast<std::uint8_t>(wire::BoardType::kFakeRobot);
}

/// "MAJOR.MINOR.PATCH".
inline std::string firmware_text(const wire::Hello& hello) {
  return std::to_string(hello.firmware[0]) + "." + std::to_string(hello.firmware[1]) + "." +
         std::to_string(hello.firmware[2]);
}

/// A port is physical unless this proves otherwise: a pseudo-terminal alone may be a serial server
/// with a robot behind it. `board`: as in the session's hello.
constexpr bool is_emulator(bool pseudo_terminal, std::uint8_t board) {
  return pseudo_terminal && board == static_cast<std::uint8_t>(wire::BoardType::kNative);
}

/// What moves when it drives, as shown to people. The consent to a start does not depend on it: a
/// board that simulates its robot is on a real port, and is treated as a real robot.
enum class RobotKind : std::uint8_t {
  kPhysical,
  kEmulated,   ///< is_emulator()
  kSimulated,  ///< the firmware simulates its robot inside the board (FAKE_ROBOT)
};

/// Names as in messages.
inline constexpr std::array<EnumName<RobotKind>, 3> kRobotKindNames = {{
    {RobotKind::kPhysical, "physical"},
    {RobotKind::kEmulated, "emulated"},
    {RobotKind::kSimulated, "simulated"},
}};
constexpr const char* to_string(RobotKind kind) { return name_in(kRobotKindNames, kind); }

constexpr RobotKind robot_kind(bool pseudo_terminal, std::uint8_t board) {
  if (board == static_cast<std::uint8_t>(wire::BoardType::kFakeRobot)) return RobotKind::kSimulated;
  return is_emulator(pseudo_terminal, board) ? RobotKind::kEmulated : RobotKind::kPhysical;
}

}  // namespace tp100
