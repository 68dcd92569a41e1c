#pragma once
// The figures on the page of a campaign: titles, units, and charts of their distribution and of
// what they depend on.

#include <string>
#include <vector>

#include "sim/campaign/merge.h"

namespace tp100::sim {

/// One of the figures that the page shows; the rest is in merged.json and runs.csv.
struct ShownFigure {
  const char* name;  ///< as in merged.json
  const char *title, *unit;
  double scale;  ///< factor from the figure's own unit
  int places;
  const char* colour;
  const MergedFigure* merged = nullptr;

  std::string with_unit() const;
  /// The value in this unit, without the unit's name; "never" if it is not finite.
  std::string text(double value) const;
  /// With the 95 % interval in brackets, if there is one.
  std::string text(double value, const Interval& interval) const;
};

/// The shown figures that the campaign has.
std::vector<ShownFigure> shown_figures(const Merged& merged);

/// Whether a rank correlation over this many runs deserves a chart: its magnitude is above 0.6 and
/// above what chance gives in one of 20 cases.
bool is_strong(double rank_correlation, std::size_t runs);
extern const char* const kStrongRule;  ///< the same rule in words

/// Box plots of all completed runs, and of those of each value of each list.
std::string spread_chart(const ShownFigure& figure, const Merged& merged);

/// Every completed run as a dot: a sampled number and the figure.
std::string correlation_chart(const ShownFigure& figure, const std::string& sampled,
                              double rank_correlation, const Merged& merged);

}  // namespace tp100::sim
