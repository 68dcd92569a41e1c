#pragma once
// Findings of an examination, and how they are printed. Pure.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_names.h"

namespace tp100::doctor {

struct LinkTest;

enum class Severity {
  kOk,       ///< checked, nothing to do
  kNote,     ///< worth knowing
  kWarning,  ///< the robot drives, but not as well as it could
  kError,    ///< prevents the robot from driving
};

/// Names as in table and JSON.
inline constexpr std::array<EnumName<Severity>, 4> kSeverityNames = {{
    {Severity::kOk, "ok"},
    {Severity::kNote, "note"},
    {Severity::kWarning, "warning"},
    {Severity::kError, "error"},
}};
constexpr std::string_view to_string(Severity severity) {
  return name_in(kSeverityNames, severity);
}

struct Finding {
  Severity severity = Severity::kOk;
  std::string name;  ///< stable identifier, as in table and JSON
  std::string seen;  ///< what and where, one line
  std::string fix;   ///< one line; empty if there is nothing to do
};

using Findings = std::vector<Finding>;

Finding ok(std::string name, std::string seen);
Finding warning(std::string name, std::string seen, std::string fix);
Finding error(std::string name, std::string seen, std::string fix);

/// Number of findings of that severity.
std::size_t count(const Findings& findings, Severity severity);

/// Adds `more` at the end of `findings`.
void append(Findings& findings, Findings more);

/// As text: one line per finding and one for its fix; the count of each severity at the end.
std::string table(const Findings& findings);

/// As JSON, one object without a line end: {"port", "errors", "warnings", "notes", "findings":
/// [{"severity", "name", "seen", "fix"}]}
std::string json(const Findings& findings, const std::string& port);
/// The same, one object on one line, with "link": null or {"samples", "lost", "crc_errors",
/// "age_us", "round_trip_us": {"p50", "p90", "p99", "max"}, ...}
std::string json(const Findings& findings, const std::string& port,
                 const std::optional<LinkTest>& link);

}  // namespace tp100::doctor
