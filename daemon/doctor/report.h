#pragma once
// An examination as people and programs read it. Pure.

#include <optional>
#include <string>

#include "doctor/finding.h"
#include "doctor/robot.h"

namespace tp100::doctor {

/// One line per finding and one for its fix, the count of each severity at the end.
std::string table(const Findings& findings);

/// One JSON object on one line: {"port", "errors", "warnings", "notes", "findings": [{"severity",
/// "name", "seen", "fix"}], "link": null or {"samples", "lost", "crc_errors", "age_us",
/// "round_trip_us": {"p50", "p90", "p99", "max"}, ...}}
std::string json(const Findings& findings, const std::string& port,
                 const std::optional<LinkTest>& link);

}  // namespace tp100::doctor
