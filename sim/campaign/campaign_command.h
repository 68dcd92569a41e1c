#pragma once
// `tp100-sim campaign` and `tp100-sim merge`.

#include <optional>
#include <string>

namespace tp100::sim {

struct CampaignCommand {
  std::string spec;  ///< file
  std::string out;   ///< folder of the campaign
  /// Only these runs, as "3", "3-7" or "3,5-7,12"; none: all. An empty text is refused: a task
  /// whose list is missing passes it and must not drive everything.
  std::optional<std::string> index{};
  std::string record;  ///< folder for recordings; empty: none
  int todo = 0;        ///< drive nothing: print the runs not done, at most so many per line
};

/// Drives the runs that are not done yet, one after the other; with `record` also those that are.
/// Any number of such commands may work in one folder at once. 0: all of them are done; 1: some
/// were refused. Throws SetupError.
int run_campaign(const CampaignCommand& command);

/// Writes merged.json, runs.csv and index.html into the folder of a campaign, from the runs that
/// are done. 0: all runs are done; 1: some are missing or were refused. Throws SetupError.
int run_merge(const std::string& folder);

}  // namespace tp100::sim
