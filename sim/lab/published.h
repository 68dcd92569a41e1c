#pragma once
// What the paper prints.

#include <array>
#include <optional>
#include <string_view>

namespace tp100::sim {

/// Errors that the paper prints for a course, in its own units; negative: not printed. Its mean
/// squared errors carry units of m and rad and contradict its own maxima, so they are not compared.
struct PublishedErrors {
  std::string_view course;
  double max_position_error_cm;
  double mse_x, mse_y, mse_yaw;
};

/// The row of a bundled course, by its name.
inline std::optional<PublishedErrors> published_errors(std::string_view course) {
  static constexpr std::array<PublishedErrors, 5> kRows = {{
      {"1-straight", 1.5625, -1, -1, -1},
      {"1-curve", 1.2028, -1, -1, -1},
      {"1-sharp", 8.5838, -1, -1, -1},
      {"2", -1, 0.1854, 0.1486, 0.801},
      {"3", 34.1, 1.6607, 0.4948, 0.821},
  }};
  for (const PublishedErrors& row : kRows)
    if (row.course == course) return row;
  return std::nullopt;
}

// Values of the tables "result of the equivalent wheelbase" and "obtained slip parameters".
inline constexpr double kPublishedWheelbaseM = 0.2742;
inline constexpr double kPublishedSlipLeft = 0.1;
inline constexpr double kPublishedSlipRight = 0.1188;
inline constexpr double kPublishedSlipAngleDeg = 0.404;  ///< straight on
inline constexpr double kPublishedSlipAngleTurningDeg = 0.0;

}  // namespace tp100::sim
