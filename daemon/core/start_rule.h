#pragma once
// Who may start a run, and how: the one rule for program, terminal and page. Pure.

#include <cstdint>
#include <string_view>

#include "wire/messages.h"

namespace tp100 {

/// Starts a run again when typed at the terminal. Enter alone, which stops, never does.
inline constexpr std::string_view kStartWord = "go";

/// A port is physical unless this proves otherwise: a pseudo-terminal alone may be a serial server
/// with a robot behind it. `board`: as the hello of the session says.
constexpr bool is_emulator(bool pseudo_terminal, std::uint8_t board) {
  return pseudo_terminal && board == static_cast<std::uint8_t>(wire::Board::kNative);
}

/// What moves when it drives, as shown to people. The consent to a start does not depend on it: a
/// board that simulates its robot is on a real port, and is treated as a real robot.
enum class RobotKind : std::uint8_t {
  kPhysical,
  kEmulated,   ///< is_emulator()
  kSimulated,  ///< the firmware simulates its robot inside the board (FAKE_ROBOT)
};

/// As in messages.
constexpr const char* to_string(RobotKind kind) {
  switch (kind) {
    case RobotKind::kPhysical:
      return "physical";
    case RobotKind::kEmulated:
      return "emulated";
    case RobotKind::kSimulated:
      return "simulated";
  }
  return "unknown";
}

constexpr RobotKind robot_kind(bool pseudo_terminal, std::uint8_t board) {
  if (board == static_cast<std::uint8_t>(wire::Board::kFakeRobot)) return RobotKind::kSimulated;
  return is_emulator(pseudo_terminal, board) ? RobotKind::kEmulated : RobotKind::kPhysical;
}

/// Facts known when a start is requested.
struct StartFacts {
  bool emulator = false;    ///< is_emulator()
  bool go = false;          ///< somebody gave --go
  bool service = false;     ///< a service manager started the program: it may have restarted it
  bool has_run = false;     ///< since the robot is looked for, a run began or somebody pressed STOP
  bool ran_before = false;  ///< the program drove other runs before it looked for this robot
};

/// Consent that a start needs.
enum class StartConsent : std::uint8_t {
  kNone,   ///< the program starts by itself
  kEnter,  ///< at the terminal Enter; on the page a confirmed press
  kWord,   ///< at the terminal kStartWord and Enter; on the page a confirmed press
};

constexpr StartConsent start_consent(const StartFacts& facts) {
  if (facts.has_run) return StartConsent::kWord;
  if ((facts.emulator || facts.go) && !facts.service) return StartConsent::kNone;
  return facts.ran_before ? StartConsent::kWord : StartConsent::kEnter;
}

/// Meaning of a line typed at the terminal.
enum class LineMeaning : std::uint8_t {
  kNothing,
  kStart,
  kStop,
};

/// `line`: without surrounding white space. Once a run has begun, any line but kStartWord is a
/// STOP, even if nothing seems to run: the run that it is meant for may have ended just now, before
/// the robot knows.
constexpr LineMeaning meaning_of(std::string_view line, StartConsent consent, bool under_way) {
  if (under_way) return LineMeaning::kStop;
  if (line == kStartWord) return LineMeaning::kStart;
  if (consent == StartConsent::kWord) return LineMeaning::kStop;
  return line.empty() ? LineMeaning::kStart : LineMeaning::kNothing;
}

}  // namespace tp100
