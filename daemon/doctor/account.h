#pragma once
// Whether an account may use a device file, and whether it only has to log in again.

#include <sys/types.h>

#include <string>
#include <vector>

#include "doctor/finding.h"
#include "doctor/system.h"

namespace tp100::doctor {

/// Whose session this is.
struct Account {
  std::string name;
  std::vector<gid_t> groups;  ///< of this session, the primary one included
};

/// May the account read and write `device`? `usable` is what System::usable says to it; mode and
/// groups only explain why not. Names: permission, group.
Findings permission_findings(const System& system, const std::string& device,
                             const Account& account, bool usable);

}  // namespace tp100::doctor
