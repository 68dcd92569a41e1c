#pragma once
// The results of identify, for people and for a robot file.

#include <optional>
#include <string>

#include "course/robot_file.h"
#include "identify/identify.h"
#include "identify/next_manoeuvre.h"

namespace tp100::identify {

/// Prior from a robot file, for identify. The turning threshold is the configuration's.
Prior prior_of(const course::Robot& robot, double turning_threshold_radps);

/// Several lines of at most 100 columns: values with intervals beside those of `base`, residuals of
/// eqs 1-5 alone and extended, each run, and what the runs cannot determine.
std::string identify_report(const Identification& found, const course::Robot& base);

/// The same as one JSON object on one line (REFERENCE.md, `identify --json`). `robot`: of
/// identified_robot(). `driven`: of an identification that drove by itself.
std::string identify_json(const Identification& found, const course::Robot& base,
                          const course::Robot& robot,
                          const std::optional<AutoProgress>& driven = std::nullopt);

/// `base` with the identified values and, as comments, their origins. `date` is the day of the runs
/// as printed; empty: none.
course::Robot identified_robot(const Identification& found, const course::Robot& base,
                               const std::string& date);

/// The comment at the head of its file: the previous comment, then the runs and the residuals.
std::string identified_note(const Identification& found, const std::string& base_note,
                            const std::string& date);

}  // namespace tp100::identify
