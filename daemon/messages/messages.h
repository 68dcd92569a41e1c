#pragma once
// Messages of the channels, as JSON (CHANNELS.md): from plain data to text. No socket, file or
// clock; any thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/enum_names.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/step_record.h"
#include "core/time.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"

namespace tp100::messages {

/// Robot and course of a bridge between two changes of the set-up: the context of every message.
struct RunContext {
  std::string version;
  std::shared_ptr<const course::Course> course;  ///< null: none
  course::Robot robot{};
  std::string setup = "flat";
  std::string world = "internal";
  std::string pacing = "host";
  double rate_hz = 200.0;
  bool stop_unwatched = false;  ///< server.stop_unwatched
};

/// Converts host time for viewers and recordings: to Unix time that never jumps, and to seconds
/// since the start. The wall clock is read once, at the start; afterwards only monotonic time
/// counts.
struct PublishClock {
  HostNs start_ns = 0;             ///< monotonic
  std::int64_t start_unix_ns = 0;  ///< the same instant, by the wall clock

  double t_s(HostNs at) const { return to_s(at - start_ns); }
  /// Never negative.
  std::uint64_t unix_ns(HostNs at) const {
    const std::int64_t unix = start_unix_ns + (at - start_ns);
    return unix < 0 ? 0 : static_cast<std::uint64_t>(unix);
  }
  HostNs host_ns(std::uint64_t unix_ns) const {
    return start_ns + (static_cast<std::int64_t>(unix_ns) - start_unix_ns);
  }
};

/// True pose of the robot, measured from outside.
struct Truth {
  HostNs at_ns = 0;
  Pose pose{};
};

/// One thing that happened.
struct Event {
  enum class Level : std::uint8_t { kInfo, kWarning, kError };
  HostNs at_ns = 0;
  std::string kind = "daemon";  ///< as listed in CHANNELS.md
  Level level = Level::kInfo;
  std::string text{};
  std::string cause{};  ///< empty unless the operator has to act
  std::string fix{};    ///< how
};

/// A fault that ended a run.
inline Event fault_event(HostNs at, Fault fault) {
  const FaultText& words = describe(fault);
  return {at,
          "fault",
          Event::Level::kError,
          std::string(words.name),
          std::string(words.cause),
          std::string(words.fix)};
}

/// Names as in /event.level.
inline constexpr std::array<EnumName<Event::Level>, 3> kLevelNames = {{
    {Event::Level::kInfo, "info"},
    {Event::Level::kWarning, "warning"},
    {Event::Level::kError, "error"},
}};

/// Writes the messages of our own schemas about one run context; those of Foxglove's are in
/// messages/foxglove.h. Each function returns the whole text of one message.
class Messages {
 public:
  Messages(RunContext run_context, PublishClock clock);

  const RunContext& run_context() const { return run_context_; }
  const PublishClock& clock() const { return clock_; }
  /// Null without a course.
  const course::Path* path() const { return path_ ? &*path_ : nullptr; }

  std::string estimate(const StepRecord& record, const std::optional<Truth>& truth) const;
  std::string sample(const Sample& sample, HostNs now) const;
  /// The record's command must be valid.
  std::string command(const StepRecord& record) const;
  std::string slip(const StepRecord& record) const;
  std::string course() const;
  std::string event(const Event& event) const;

 private:
  RunContext run_context_;
  PublishClock clock_;
  std::optional<course::Path> path_;
};

/// The reference path in at most so many points; it has at most 1000 segments.
inline constexpr std::size_t kMaxPathPoints = 20'000;
/// A point at most every 2 cm, or as far apart as the limit requires; both ends of every segment
/// are among them.
std::vector<course::PathPoint> path_points(const course::Path& path);

}  // namespace tp100::messages
