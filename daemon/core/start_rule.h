#pragma once
// What a start needs: consent, and that it is known where the robot stands. The one rule for
// program, terminal, page and ROS 2. Pure.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/command.h"
#include "core/pose.h"
#include "core/run_state.h"

namespace tp100 {

/// Starts a run again when typed at the terminal. Enter alone, which stops, never does.
inline constexpr std::string_view kStartWord = "go";
/// The same, and where the robot stands.
inline constexpr std::string_view kStartPlacedWords = "go start", kStartHereWords = "go here";

/// The start that a request means by what it says of where the robot stands: "start" (of the
/// course), "here", or nothing of it. Nothing: it says something else.
constexpr std::optional<OperatorRequest> start_request(std::string_view where) {
  if (where.empty()) return OperatorRequest::kStart;
  if (where == "start") return OperatorRequest::kStartPlaced;
  if (where == "here") return OperatorRequest::kContinue;
  return std::nullopt;
}

/// A robot within these of the course's start counts as standing there.
inline constexpr double kAtStartM = 0.03, kAtStartRad = 3.0 * kRadPerDeg;
inline bool at_start(const Pose& pose, const Pose& start) {
  return magnitude(pose.x_m - start.x_m, pose.y_m - start.y_m) <= kAtStartM &&
         std::abs(wrap_angle(pose.yaw_rad - start.yaw_rad)) <= kAtStartRad;
}

/// What is known of where the robot stands.
struct PlaceFacts {
  Pose start{};                ///< of the course
  Pose shown{};                ///< the steering pose in the course's world
  std::optional<Pose> seen{};  ///< by the overhead camera, now or before
  bool seen_now = false;
  /// It was placed, driven by hand or contradicted by a camera since it was at the start.
  bool moved = false;
  bool on_path = false;  ///< a run from here has a path to go on
};

inline StartPlaces start_places(const PlaceFacts& facts) {
  const bool seen_elsewhere = facts.seen && !at_start(*facts.seen, facts.start);
  StartPlaces out;
  if (facts.moved || seen_elsewhere || !at_start(facts.shown, facts.start))
    out.unsaid = StartRefusal::kWhere;
  if (seen_elsewhere && facts.seen_now) out.placed = StartRefusal::kSeenElsewhere;
  if (!facts.on_path) out.here = StartRefusal::kOffPath;
  return out;
}

/// Why a request is refused for where the robot stands; kNone for those that do not start a course.
constexpr StartRefusal refusal_of(const StartPlaces& places, OperatorRequest request) {
  if (request == OperatorRequest::kStart) return places.unsaid;
  if (request == OperatorRequest::kStartPlaced) return places.placed;
  return request == OperatorRequest::kContinue ? places.here : StartRefusal::kNone;
}

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
  kStartPlaced,
  kStartHere,
  kStop,
};

/// `line`: without surrounding white space. Once a run has begun, any line but those of a start is
/// a STOP, even if nothing seems to run: the run that it should stop may have ended just now,
/// before the robot has been told.
constexpr LineMeaning meaning_of(std::string_view line, StartConsent consent, bool under_way) {
  if (under_way) return LineMeaning::kStop;
  if (line == kStartWord) return LineMeaning::kStart;
  if (line == kStartPlacedWords) return LineMeaning::kStartPlaced;
  if (line == kStartHereWords) return LineMeaning::kStartHere;
  if (consent == StartConsent::kWord) return LineMeaning::kStop;
  return line.empty() ? LineMeaning::kStart : LineMeaning::kNothing;
}

}  // namespace tp100
