#pragma once
// Where the three estimates have been in this run: line strips that grow, in bounded memory.

#include <array>
#include <string>
#include <vector>

#include "core/snapshot.h"
#include "messages/foxglove_json.h"
#include "messages/publish_clock.h"

namespace tp100::messages {

class Trail {
 public:
  static constexpr double kSpacingM = 0.01;
  static constexpr std::size_t kMaxPoints = 4000;  ///< of one strip; then every second one goes

  /// Takes the poses of one step; a run that begins starts the strips anew.
  void add(const Snapshot& snapshot);
  /// foxglove.SceneUpdate with what came since the last call; empty: nothing.
  std::string take_update(const PublishClock& clock, HostNs now);
  /// foxglove.SceneUpdate with all that take_update() has given so far.
  std::string whole(const PublishClock& clock, HostNs now) const;

 private:
  struct Strip {
    std::vector<Point> points;
    std::size_t given = 0;
  };
  void append(Strip& strip, const Pose& pose);
  void clear();
  std::string message(const PublishClock& clock, HostNs now, bool all) const;

  std::array<Strip, 3> strips_{};
  std::uint32_t chunk_ = 0;
  bool replace_ = false;  // what was given is void
  RunState run_ = RunState::kIdle;
};

}  // namespace tp100::messages
