#pragma once
// What a reproduction says, as one page and as one JSON object.

#include <string>
#include <vector>

#include "course/robot.h"
#include "sim/study/reproduce.h"

namespace tp100::sim {

/// Everything that was driven.
struct Reproduction {
  course::Robot reference{};
  std::vector<SlopeSlip> slopes;  ///< of the reference robot, one a row of slope_rows()
  std::vector<CourseStudy> studies;
  int runs = 0;
  std::uint64_t seed = 1;
};

/// Largest difference between measured slip and the paper's table.
double worst_slope_difference(const Reproduction& what);
/// Whether every run was completed and every limit holds.
bool all_hold(const Reproduction& what);

/// One offline HTML page.
std::string reproduction_page(const Reproduction& what);
/// One JSON object.
std::string reproduction_json(const Reproduction& what);
/// The table of limits, for a terminal.
std::string reproduction_table(const Reproduction& what);

}  // namespace tp100::sim
