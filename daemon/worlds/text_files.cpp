#include "worlds/text_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/run_state.h"
#include "text/encoding.h"
#include "text/format.h"
#include "worlds/message.h"

namespace tp100::worlds {
namespace {

constexpr std::size_t kMaxTemplate = 500;

std::string number(double value) { return text::format("%.6f", value); }

std::optional<std::string> value_of(std::string_view name, const StepRecord& record, Frame frame) {
  const Snapshot& snapshot = record.snapshot;
  const Pose& pose = snapshot.world;
  if (name == "seq") return std::to_string(record.step);
  if (name == "t_s") return number(to_s(record.now_ns));
  if (name == "left_count") return std::to_string(snapshot.sample.left_counts);
  if (name == "right_count") return std::to_string(snapshot.sample.right_counts);
  if (name == "left") return number(to_length(frame, snapshot.left_mps));
  if (name == "right") return number(to_length(frame, snapshot.right_mps));
  if (name == "mode") return std::string(to_string(snapshot.run_state));
  constexpr std::array<std::string_view, 3> kPlace = {"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kTurn = {"roll", "pitch", "yaw"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (name == kPlace[i]) return number(to_place(frame, {pose.x_m, pose.y_m, pose.z_m})[i]);
    if (name == kTurn[i]) return number(to_rpy(frame, pose)[i]);
  }
  return std::nullopt;
}

/// Calls on_text(text) and on_name(name) in order.
template <class Text, class Name>
void walk(std::string_view pattern, Text on_text, Name on_name) {
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    on_text(pattern.substr(0, open));
    if (open == std::string_view::npos) return;
    const std::size_t close = pattern.find('}', open);
    const bool whole = close != std::string_view::npos;
    on_name(pattern.substr(open + 1, whole ? close - open - 1 : std::string_view::npos));
    pattern = whole ? pattern.substr(close + 1) : std::string_view();
  }
}

enum Value : std::size_t { kX, kY, kZ, kRoll, kPitch, kYaw };
using Values = std::array<std::optional<double>, 6>;

bool between(char c) { return std::string_view(" \t\r\n,;()").find(c) != std::string_view::npos; }

/// Removes a number from the front of `text`.
std::optional<double> number(std::string_view& text) {
  std::string_view rest = text;
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text = rest.substr(static_cast<std::size_t>(end - rest.data()));
  return value;
}

std::optional<Orientation> orientation(const Values& values, Frame frame) {
  Orientation out;
  if (!values[kPitch]) return std::nullopt;
  const auto count = [&](std::size_t from) {
    return std::count_if(values.begin() + static_cast<std::ptrdiff_t>(from),
                         values.begin() + static_cast<std::ptrdiff_t>(from + 3),
                         [](const auto& value) { return value.has_value(); });
  };
  out.has_turn = count(kRoll) == 3;
  out.has_place = count(kX) == 3;
  from_rpy(frame, {values[kRoll].value_or(0.0), *values[kPitch], values[kYaw].value_or(0.0)},
           out.pose);
  if (out.has_place) {
    const Vector place = from_place(frame, {*values[kX], *values[kY], *values[kZ]});
    out.pose.x_m = place[0];
    out.pose.y_m = place[1];
    out.pose.z_m = place[2];
    if (!std::all_of(place.begin(), place.end(),
                     [](double m) { return std::abs(m) <= kMaxPlaceM; }))
      return std::nullopt;
  }
  const bool plausible = std::abs(out.pose.roll_rad) <= kMaxLeanRad &&
                         std::abs(out.pose.pitch_rad) <= kMaxLeanRad &&
                         std::abs(out.pose.yaw_rad) <= kMaxYawRad;
  return plausible ? std::optional(out) : std::nullopt;
}

/// "P=1.0 Y=2.0 R=3.0" and "X=1.0 Y=2.0 Z=3.0": the labels before a Y decide which one it is.
std::optional<Orientation> labelled(std::string_view text, Frame frame) {
  Values values{};
  bool rotator = false;
  while (true) {
    while (!text.empty() && between(text.front())) text.remove_prefix(1);
    if (text.empty()) break;
    const char label = text.front();
    if (text.size() < 2 || text[1] != '=') return std::nullopt;
    text.remove_prefix(2);
    const auto value = number(text);
    if (!value || (!text.empty() && !between(text.front()))) return std::nullopt;
    if (label == 'P' || label == 'X') rotator = label == 'P';
    const std::size_t at = label == 'P'   ? kPitch
                           : label == 'R' ? kRoll
                           : label == 'X' ? kX
                           : label == 'Z' ? kZ
                           : label != 'Y' ? values.size()
                           : rotator      ? kYaw
                                          : kY;
    if (at == values.size() || values[at]) return std::nullopt;
    values[at] = value;
  }
  const bool whole_turn = values[kRoll] && values[kPitch] && values[kYaw];
  const bool place = values[kX] || values[kY] || values[kZ];
  const bool whole_place = values[kX] && values[kY] && values[kZ];
  if (!whole_turn || (place && !whole_place)) return std::nullopt;
  return orientation(values, frame);
}

std::optional<Orientation> plain(std::string_view text, Frame frame) {
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  while (true) {
    while (!text.empty() && between(text.front())) text.remove_prefix(1);
    if (text.empty()) break;
    const auto value = number(text);
    if (!value || count == numbers.size() || (!text.empty() && !between(text.front())))
      return std::nullopt;
    numbers[count++] = *value;
  }
  Values values{};
  if (count == 6)
    for (std::size_t i = 0; i < 3; ++i) values[i] = numbers[i];
  if (count == 1 || count == 3 || count == 6) {
    const std::size_t from = count == 6 ? 3 : 0;
    values[kPitch] = numbers[from];
    if (count != 1) {
      values[kYaw] = numbers[from + 1];
      values[kRoll] = numbers[from + 2];
    }
  }
  return orientation(values, frame);
}

}  // namespace

void require_encoder_template(std::string_view pattern, const std::string& where) {
  if (pattern.size() > kMaxTemplate)
    throw UserError(where + ": longer than " + std::to_string(kMaxTemplate) + " characters");
  const std::size_t last = pattern.rfind('{');
  if (last != std::string_view::npos && pattern.find('}', last) == std::string_view::npos)
    throw UserError(where + ": a { without its }");
  const auto record = std::make_unique<const StepRecord>();
  walk(
      pattern, [](std::string_view) {},
      [&](std::string_view name) {
        if (!value_of(name, *record, Frame::kRos))
          throw UserError(where + ": {" + std::string(name) +
                          "} is no value; use seq, t_s, left_count, right_count, left, right, x, "
                          "y, z, roll, pitch, yaw or mode");
      });
}

std::string encoder_text(std::string_view pattern, const StepRecord& record, Frame frame) {
  std::string out;
  walk(
      pattern, [&](std::string_view text) { out += text; },
      [&](std::string_view name) {
        if (const auto value = value_of(name, record, frame)) out += *value;
      });
  if (!out.ends_with('\n')) out += '\n';
  return out;
}

std::optional<Orientation> orientation_of(std::string_view text, Frame frame) {
  if (text.size() > kMaxOrientationText) return std::nullopt;
  const std::string utf8 = text::as_utf8(std::string(text));
  text = utf8;
  return text.find('=') != std::string_view::npos ? labelled(text, frame) : plain(text, frame);
}

}  // namespace tp100::worlds
