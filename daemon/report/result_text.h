#pragma once
// The result of a run as JSON and as a table, beside the paper's printed results.

#include <optional>
#include <string>
#include <string_view>

#include "report/metrics.h"

namespace tp100::report {

/// The result as one JSON object on one line, without line break. Keys in fixed order; doubles are
/// the shortest text that reads back the same, so that equal runs print equal text. `cause` appears
/// only in a run that was not completed, `fused` only in one with an overhead camera; the recovery
/// from a disturbance is null if there was none.
std::string result_json(const RunResult& run, const RunFigures& figures);

/// The result as text: several lines, at most 100 columns, with notes on which values are the
/// paper's and which are our own.
std::string result_table(const RunResult& run, const RunFigures& figures);

/// Errors that the paper prints for a course, in its own units; negative: not printed. Its mean
/// squared errors carry units of m and rad and contradict its own maxima, so they are not compared.
struct PublishedErrors {
  std::string_view course;
  double max_position_error_cm;
  double mse_x, mse_y, mse_yaw;
};

/// The row of a bundled course, by its name.
std::optional<PublishedErrors> published_errors(std::string_view course);

/// Values of the tables "result of the equivalent wheelbase" and "obtained slip parameters".
inline constexpr double kPublishedWheelbaseM = 0.2742;
inline constexpr double kPublishedSlipLeft = 0.1;
inline constexpr double kPublishedSlipRight = 0.1188;
inline constexpr double kPublishedSlipAngleDeg = 0.404;  ///< straight on
inline constexpr double kPublishedSlipAngleTurningDeg = 0.0;

}  // namespace tp100::report
