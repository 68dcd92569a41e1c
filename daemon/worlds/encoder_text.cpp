#include "worlds/encoder_text.h"

#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/run_state.h"

namespace tp100::worlds {
namespace {

constexpr std::size_t kMaxTemplate = 500;

std::string number(double value) {
  std::array<char, 40> text{};
  const int n = std::snprintf(text.data(), text.size(), "%.6f", value);
  return {text.data(), static_cast<std::size_t>(n)};
}

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

}  // namespace

void require_encoder_template(std::string_view pattern, const std::string& where) {
  if (pattern.size() > kMaxTemplate)
    throw SetupError(where + ": longer than " + std::to_string(kMaxTemplate) + " characters");
  const auto record = std::make_unique<const StepRecord>();
  const auto unclosed = pattern.rfind('{');
  if (unclosed != std::string_view::npos && pattern.find('}', unclosed) == std::string_view::npos)
    throw SetupError(where + ": a { without its }");
  walk(
      pattern, [](std::string_view) {},
      [&](std::string_view name) {
        if (!value_of(name, *record, Frame::kRos))
          throw SetupError(where + ": {" + std::string(name) +
                           "} is no value; use seq, t_s, left_count, right_count, left, right, x, "
                           "y, z, roll, pitch, yaw or mode");
      });
}

std::string encoder_text(std::string_view pattern, const StepRecord& record, Frame frame) {
  std::string out;
  walk(
      pattern,
      [&](std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
          const bool escape = text[i] == '\\' && i + 1 < text.size();
          if (escape && (text[i + 1] == 'n' || text[i + 1] == 't')) {
            out += text[++i] == 'n' ? '\n' : '\t';
          } else {
            out += text[i];
          }
        }
      },
      [&](std::string_view name) {
        if (const auto value = value_of(name, record, frame)) out += *value;
      });
  if (!out.ends_with('\n')) out += '\n';
  return out;
}

}  // namespace tp100::worlds
