#pragma once
// Messages of the channels, as JSON (CHANNELS.md): from plain data to text. No socket, file or
// clock; any thread.

#include <memory>
#include <optional>
#include <string>

#include "core/steering.h"
#include "core/step_record.h"
#include "course/path.h"
#include "messages/publish_clock.h"
#include "messages/subject.h"

namespace tp100::messages {

/// Where the robot truly was, as somebody outside measured it.
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
  std::string cause{};   ///< empty unless there is something to do
  std::string remedy{};  ///< what
};

/// The three estimates, each named by what it is to steer by it.
inline constexpr Steering kEstimates[] = {Steering::kModel, Steering::kOdometry, Steering::kFused};
const Pose& pose_of(const Snapshot& snapshot, Steering estimate);

/// Writes messages about one subject. Each function returns the whole text of one message.
class Messages {
 public:
  Messages(Subject subject, PublishClock clock);

  const Subject& subject() const { return subject_; }
  const PublishClock& clock() const { return clock_; }
  /// Null without a course.
  const course::Path* path() const { return path_ ? &*path_ : nullptr; }

  // Our own schemas.
  std::string estimate(const StepRecord& record, const std::optional<Truth>& truth) const;
  std::string sample(const Sample& sample, HostNs now) const;
  /// Of a record whose command is valid.
  std::string command(const StepRecord& record) const;
  std::string slip(const StepRecord& record) const;
  std::string course() const;
  std::string event(const Event& event) const;

  // Foxglove's schemas.
  std::string transforms(const StepRecord& record, const std::optional<Truth>& truth) const;
  std::string pose(HostNs at, const Pose& pose) const;
  std::string path_poses(HostNs at) const;
  std::string scene(HostNs at) const;
  std::string log(const Event& event) const;

 private:
  Subject subject_;
  PublishClock clock_;
  std::optional<course::Path> path_;
};

/// The reference path, a point at most every `spacing_m`; both ends of every piece are among them.
std::vector<course::PathPoint> path_points(const course::Path& path, double spacing_m);

}  // namespace tp100::messages
