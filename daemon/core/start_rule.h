#pragma once
// Consent that a start needs: the one rule for program, terminal and page. Pure.

#include <cstdint>
#include <string_view>

namespace tp100 {

/// Starts a run again when typed at the terminal. Enter alone, which stops, never does.
inline constexpr std::string_view kStartWord = "go";

/// Facts known when a start is requested.
struct StartFacts {
  bool emulator = false;  ///< is_emulator() of core/board.h
  bool go = false;        ///< --go was given
  bool service = false;   ///< a service manager started the program: it may have restarted it
  bool has_run = false;  ///< a run began, or STOP was pressed, since the search for the robot began
  bool ran_before = false;  ///< the program drove other runs before this search
};

/// Consent that a start needs.
enum class StartConsent : std::uint8_t {
  kNone,   ///< the program starts by itself
  kEnter,  ///< at the terminal Enter; on the page a confirmed press
  kWord,   ///< at the terminal kStartWord and Enter; on the page a confirmed press
};

constexpr StartConsent start_consent(const StartFacts& facts) {
  if (facts.has_run) return StartConsent::kWord;
  // Whoever gave --go watched the first drive of the program.
  const bool go = facts.go && !facts.ran_before;
  if ((facts.emulator || go) && !facts.service) return StartConsent::kNone;
  return facts.ran_before ? StartConsent::kWord : StartConsent::kEnter;
}

/// Meaning of a line typed at the terminal.
enum class LineMeaning : std::uint8_t {
  kNothing,
  kStart,
  kStop,
};

/// `line`: without surrounding white space. Once a run has begun, any line but kStartWord is a
/// STOP, even if nothing seems to run: the run that it should stop may have ended just now, before
/// the robot has been told.
constexpr LineMeaning meaning_of(std::string_view line, StartConsent consent, bool under_way) {
  if (under_way) return LineMeaning::kStop;
  if (line == kStartWord) return LineMeaning::kStart;
  if (consent == StartConsent::kWord) return LineMeaning::kStop;
  return line.empty() ? LineMeaning::kStart : LineMeaning::kNothing;
}

}  // namespace tp100
