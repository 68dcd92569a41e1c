#pragma once
// One run of a campaign, driven in virtual time.

#include <string>

#include "sim/campaign/campaign_spec.h"

namespace tp100::sim {

/// What came of it, as the text of its file: index, seed, what was drawn, and either the figures
/// that `course --json` prints or "refused" with why it could not be driven (a drawn value that no
/// robot can have). The same run gives the same text but for what depends on the machine.
struct CampaignRun {
  std::string json;
  bool refused = false;
};
/// `record`: folder for a recording of it; empty: none. Throws what is no SetupError.
CampaignRun drive(const PlannedRun& run, const std::string& record);

}  // namespace tp100::sim
