#pragma once
// What identify found, for people and for a robot file.

#include <string>

#include "course/robot.h"
#include "identify/identify.h"

namespace tp100::identify {

/// Belief of a robot file, for identify. The threshold of turning is the configuration's.
Belief belief_of(const course::Robot& robot, double turning_threshold_radps);

/// Several lines, at most 100 columns: values with intervals beside what `base` had, residuals of
/// eqs 1-5 as they stand and extended, each run, and what the runs cannot tell.
std::string identify_report(const Identification& found, const course::Robot& base);

/// `base` with the values that were found and, as comments, where each came from. `date` is the
/// day of the runs as it should be named; empty: none.
course::Robot identified_robot(const Identification& found, const course::Robot& base,
                               const std::string& date);

/// The head of its file: what stood there before, then the runs and the residuals.
std::string identified_note(const Identification& found, const std::string& base_note,
                            const std::string& date);

}  // namespace tp100::identify
