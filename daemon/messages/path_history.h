#pragma once
// Paths of the three estimates in this run: growing line strips in bounded memory.

#include <array>
#include <string>
#include <vector>

#include "core/step_record.h"
#include "messages/foxglove.h"
#include "messages/messages.h"

namespace tp100::messages {

class PathHistory {
 public:
  static constexpr double kSpacingM = 0.01;
  static constexpr double kJumpM = 0.3;  ///< farther between two steps: the robot was placed there
  static constexpr std::size_t kMaxPoints = 4000;  ///< per strip; then every second one is dropped

  /// Takes the poses of one step; the beginning of a run clears the strips.
  void add(const Snapshot& snapshot);
  /// Forgets all points.
  void clear();
  /// foxglove.SceneUpdate with the points since the last call; empty: none.
  std::string take_update(const PublishClock& clock, HostNs now);
  /// foxglove.SceneUpdate with everything that take_update() has returned so far.
  std::string whole(const PublishClock& clock, HostNs now) const;

 private:
  struct Strip {
    std::vector<Point> points;
    std::size_t given = 0;
  };
  void append(Strip& strip, const Pose& pose);
  std::string message(const PublishClock& clock, HostNs now, bool all) const;

  std::array<Strip, kPoseSources.size()> strips_{};
  std::uint32_t chunk_ = 0;
  bool replace_ = false;  // the strips sent so far are obsolete
  RunState run_ = RunState::kIdle;
};

}  // namespace tp100::messages
