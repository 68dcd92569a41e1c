#pragma once
// The folder of a campaign: its spec, what its results come from, and one file for each run that is
// done. Several programs may work in it at once, and any of them may be killed: a file is there
// whole or not at all.

#include <cstdint>
#include <string>

#include "sim/campaign/origin.h"

namespace tp100::sim {

class CampaignFolder {
 public:
  /// Makes the folder, or takes up the one that is there. Throws SetupError: it cannot be written,
  /// belongs to a campaign with another spec, or its runs have another origin.
  CampaignFolder(std::string path, std::string spec_text, Origin origin);
  /// One that is there. Throws SetupError: it holds no campaign.
  static CampaignFolder existing(const std::string& path);

  const std::string& path() const { return path_; }
  const std::string& spec_text() const { return spec_text_; }
  /// For messages.
  std::string spec_path() const { return path_ + "/spec.toml"; }
  /// Throws SetupError that says what differs from where the runs of this folder come from.
  void require(const Origin& origin) const;
  bool has(std::uint64_t index) const;
  /// Throws SetupError.
  void put(std::uint64_t index, const std::string& json) const;
  /// The text of a run's file; empty: it is not done. Throws SetupError.
  std::string get(std::uint64_t index) const;

 private:
  CampaignFolder(std::string path, std::string spec_text);
  std::string run_path(std::uint64_t index) const;

  std::string path_;
  std::string spec_text_;
  Origin origin_;
};

}  // namespace tp100::sim
