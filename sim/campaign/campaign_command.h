#pragma once
// `tp100-sim campaign` and `tp100-sim merge`.

#include <optional>
#include <string>

namespace tp100::sim {

struct CampaignCommand {
  std::string spec;  ///< file
  std::string out;   ///< folder of the campaign
  /// Only these runs, as "3", "3-7" or "3,5-7,12"; none: all. An empty text is refused: it comes
  /// from a job whose list is missing, which must not drive everything.
  std::optional<std::string> index{};
  std::string record;  ///< folder for recordings; empty: none
  int todo = 0;        ///< above 0: drive nothing, print the open runs, at most this many per line
};

/// Drives the runs that are not done yet, one after the other; with `record` also those that are.
/// Any number of such commands may work in one folder at once. Returns 0 if all of them are done, 1
/// if some were refused. Throws UserError.
int run_campaign(const CampaignCommand& command);

/// Writes merged.json, runs.csv and index.html into the folder of a campaign, from the runs that
/// are done. Returns 0 if all are done, 1 if some are missing or were refused. Throws UserError.
int run_merge(const std::string& folder);

}  // namespace tp100::sim
