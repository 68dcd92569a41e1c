#pragma once
// Who may start a run, and how: the one rule that program, terminal and page obey. Pure.

#include <cstdint>
#include <string_view>

#include "wire/messages.h"

namespace tp100 {

/// Typed at the terminal, it starts a run again. Enter alone, which stops, never does.
inline constexpr std::string_view kStartWord = "go";

/// A port is physical unless this proves otherwise: a pseudo-terminal alone may be a serial server
/// with a robot behind it. `board`: as the hello of the session says.
constexpr bool is_emulator(bool pseudo_terminal, std::uint8_t board) {
  return pseudo_terminal && board == static_cast<std::uint8_t>(wire::Board::kNative);
}

/// What is known when a start is asked for.
struct StartFacts {
  bool emulator = false;    ///< is_emulator()
  bool go = false;          ///< somebody gave --go
  bool service = false;     ///< a service manager started the program: it may have restarted it
  bool has_run = false;     ///< since the robot is looked for, a run began or somebody pressed STOP
  bool ran_before = false;  ///< the program drove other runs before it looked for this robot
};

/// What a start takes.
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

/// What a line typed at the terminal asks for.
enum class LineMeaning : std::uint8_t {
  kNothing,
  kStart,
  kStop,
};

/// `line`: without white space around it. Once something has run, whatever is no kStartWord is a
/// STOP, even if nothing seems to run: the run that it is meant for may have ended just now, and
/// the robot may not know yet.
constexpr LineMeaning meaning_of(std::string_view line, StartConsent consent, bool under_way) {
  if (under_way) return LineMeaning::kStop;
  if (line == kStartWord) return LineMeaning::kStart;
  if (consent == StartConsent::kWord) return LineMeaning::kStop;
  return line.empty() ? LineMeaning::kStart : LineMeaning::kNothing;
}

}  // namespace tp100
