#pragma once
// What an examination found.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tp100::doctor {

enum class Severity {
  kOk,       ///< looked at, nothing to do
  kNote,     ///< worth knowing
  kWarning,  ///< the robot drives, but not as well as it could
  kError,    ///< keeps the robot from driving
};

/// "ok", "note", "warning" or "error".
std::string_view to_string(Severity severity);

struct Finding {
  Severity severity = Severity::kOk;
  std::string name;  ///< stable identifier, as in table and JSON
  std::string seen;  ///< what and where, one line
  std::string fix;   ///< one line; empty if there is nothing to do
};

using Findings = std::vector<Finding>;

Finding ok(std::string name, std::string seen);

/// How many have that severity.
std::size_t count(const Findings& findings, Severity severity);

/// Adds `more` at the end of `findings`.
void append(Findings& findings, Findings more);

}  // namespace tp100::doctor
