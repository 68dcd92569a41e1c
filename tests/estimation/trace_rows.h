#pragma once
// Rows of golden traces by name, and how estimates are written into them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/estimates.h"
#include "core/pose.h"
#include "estimation/kalman.h"
#include "support/golden_trace.h"

namespace tp100::estimation {

/// A trace whose columns are the names of its first row's values.
class TraceRows {
 public:
  void add(const std::string& name, double value) {
    if (rows_.empty()) names_.push_back(name);
    row_.push_back(value);
  }
  void end_row() { rows_.push_back(std::exchange(row_, {})); }

  /// See test::GoldenTrace.
  std::string difference(const std::string& file) const {
    test::GoldenTrace trace("estimation/" + file, names_);
    for (const auto& row : rows_) trace.row(row);
    return trace.difference();
  }

 private:
  std::vector<std::string> names_;
  std::vector<double> row_;
  std::vector<std::vector<double>> rows_;
};

inline void add(TraceRows& rows, const std::string& name, const Twist& twist) {
  rows.add(name + "_vx", twist.vx_mps);
  rows.add(name + "_vy", twist.vy_mps);
  rows.add(name + "_rate", twist.yaw_rate_radps);
}

inline void add(TraceRows& rows, const std::string& name, const PlanarCovariance& covariance) {
  rows.add(name + "_xx", covariance.xx);
  rows.add(name + "_xy", covariance.xy);
  rows.add(name + "_xyaw", covariance.x_yaw);
  rows.add(name + "_yy", covariance.yy);
  rows.add(name + "_yyaw", covariance.y_yaw);
  rows.add(name + "_yawyaw", covariance.yaw_yaw);
}

inline void add_mean(TraceRows& rows, const std::string& name, const StateVector& mean) {
  for (Eigen::Index i = 0; i < kStates; ++i) rows.add(name + std::to_string(i), mean[i]);
}

/// The lower triangle.
inline void add_covariance(TraceRows& rows, const std::string& name,
                           const StateMatrix& covariance) {
  for (Eigen::Index i = 0; i < kStates; ++i) {
    for (Eigen::Index k = 0; k <= i; ++k)
      rows.add(name + std::to_string(i) + std::to_string(k), covariance(i, k));
  }
}

/// Logarithms of the standard deviations, which show a change of small ones as well, and the
/// correlations of each state with the next ones, `reach` of them.
inline void add_spread(TraceRows& rows, const std::string& name, const StateMatrix& covariance,
                       Eigen::Index reach = 1) {
  for (Eigen::Index i = 0; i < kStates; ++i)
    rows.add(name + std::to_string(i), std::log(covariance(i, i)) / 2.0);
  for (Eigen::Index i = 0; i < kStates; ++i) {
    for (Eigen::Index k = i + 1; k < std::min(i + 1 + reach, Eigen::Index{kStates}); ++k)
      rows.add(name + std::to_string(i) + std::to_string(k),
               covariance(i, k) / std::sqrt(covariance(i, i) * covariance(k, k)));
  }
}

/// The same numbers everywhere.
class Draws {
 public:
  explicit Draws(std::uint32_t seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 2147483647.0;
  }
  /// -1 or 1.
  double sign() { return uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

 private:
  std::minstd_rand random_;
};

}  // namespace tp100::estimation
