#include "messages/path_history.h"

#include <array>
#include <span>
#include <utility>

#include "core/arithmetic.h"
#include "messages/messages.h"

namespace tp100::messages {
namespace {

constexpr double kThicknessM = 0.004;
constexpr double kLiftM = 0.004;

// Red, blue and green as in the paper.
constexpr std::array<Colour, kPoseSources.size()> kColours = {
    {{0.90, 0.20, 0.18, 1.0}, {0.26, 0.53, 0.96, 1.0}, {0.20, 0.72, 0.35, 1.0}}};

}  // namespace

void PathHistory::add(const Snapshot& snapshot) {
  const bool began = snapshot.run_state == RunState::kRunning && run_ != RunState::kRunning;
  run_ = snapshot.run_state;
  if (began) clear();
  if (!snapshot.has_sample) return;
  for (std::size_t i = 0; i < strips_.size(); ++i)
    append(strips_[i], snapshot.estimates[kPoseSources[i]].pose);
}

void PathHistory::clear() {
  for (Strip& strip : strips_) strip = {};
  replace_ = true;
}

void PathHistory::append(Strip& strip, const Pose& pose) {
  const Point point{pose.x_m, pose.y_m, pose.z_m + kLiftM};
  if (!strip.points.empty()) {
    const Point& last = strip.points.back();
    const double moved = magnitude(point.x_m - last.x_m, point.y_m - last.y_m);
    if (!(moved >= kSpacingM)) return;
    if (moved > kJumpM) {
      strip = {};
      replace_ = true;
    }
  }
  strip.points.push_back(point);
  if (strip.points.size() <= kMaxPoints) return;
  for (std::size_t i = 0; i < strip.points.size() / 2; ++i) strip.points[i] = strip.points[2 * i];
  strip.points.resize(strip.points.size() / 2);
  replace_ = true;
}

std::string PathHistory::take_update(const PublishClock& clock, HostNs now) {
  bool any = replace_;
  for (const Strip& strip : strips_) any = any || strip.points.size() > strip.given;
  if (!any) return {};
  ++chunk_;
  std::string text = message(clock, now, std::exchange(replace_, false));
  for (Strip& strip : strips_) strip.given = strip.points.size();
  return text;
}

std::string PathHistory::whole(const PublishClock& clock, HostNs now) const {
  return message(clock, now, true);
}

std::string PathHistory::message(const PublishClock& clock, HostNs now, bool all) const {
  const std::uint64_t at = clock.unix_ns(now);
  return scene_update(at, all, [&](text::JsonWriter& json) {
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      const Strip& strip = strips_[i];
      // Repeat the last point of the previous part, so that the strip has no gap.
      const std::size_t from = all || strip.given == 0 ? 0 : strip.given - 1;
      if (strip.points.size() < from + 2) continue;
      write_entity(
          json,
          {.id = "path_history/" + std::string(to_string(kPoseSources[i])) + "/" +
                 std::to_string(chunk_),
           .lines = line_strip(std::span(strip.points).subspan(from), kThicknessM, kColours[i])},
          at);
    }
  });
}

}  // namespace tp100::messages
