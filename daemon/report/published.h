#pragma once
// What the paper printed, in its own units, to stand beside ours.

#include <optional>
#include <string_view>

namespace tp100::report {

/// Errors that the paper prints for a course; negative: not printed. Its mean squared errors carry
/// units of m and rad and contradict its own maxima; nothing is claimed from them.
struct PublishedErrors {
  std::string_view course;
  double max_position_error_cm;
  double mse_x, mse_y, mse_yaw;
};

/// The row of a bundled course, by its name.
std::optional<PublishedErrors> published_errors(std::string_view course);

/// Table "result of the equivalent wheelbase" and table "obtained slip parameters".
inline constexpr double kPublishedWheelbaseM = 0.2742;
inline constexpr double kPublishedSlipLeft = 0.1;
inline constexpr double kPublishedSlipRight = 0.1188;
inline constexpr double kPublishedSlipAngleDeg = 0.404;

}  // namespace tp100::report
