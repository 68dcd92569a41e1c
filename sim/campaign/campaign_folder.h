#pragma once
// The folder of a campaign, and the origin of the results in it.

#include <cstdint>
#include <map>
#include <string>

#include "sim/campaign/campaign_spec.h"

namespace tp100::sim {

/// Origin of a campaign's results besides its spec. Two programs may put runs into one folder, or
/// one may continue it later, only if the origin is the same for both. Keys are "course 3", "robot
/// mine.toml", "program", ...; values identify the content: a digest of 16 hexadecimal digits for a
/// file, with its version for the program, "not there" for a missing file.
using Origin = std::map<std::string, std::string>;

/// This program, the libraries used for its computations, and every file that a run of the campaign
/// may read: configuration, courses, robots, cameras and, for the avr board, the firmware's image.
Origin origin_of(const CampaignSpec& spec);

/// Converts to text, one line per entry in alphabetical order, and back; skips invalid lines. Pure.
std::string origin_text(const Origin& origin);
Origin read_origin(const std::string& text);

/// Describes the differences; empty: none. Pure.
std::string difference(const Origin& before, const Origin& now);

/// A campaign's spec, the origin of its results, and one file for each run that is done. Several
/// programs may work in it at once, and any of them may be killed: files are created atomically.
class CampaignFolder {
 public:
  /// Creates the folder, or opens an existing one. Throws UserError if it cannot be written,
  /// belongs to a campaign with another spec, or has runs of another origin.
  CampaignFolder(std::string path, std::string spec_text, Origin origin);
  /// Opens an existing folder. Throws UserError if it holds no campaign.
  static CampaignFolder existing(const std::string& path);

  const std::string& path() const { return path_; }
  const std::string& spec_text() const { return spec_text_; }
  /// Path of the spec, for messages.
  std::string spec_path() const { return path_ + "/spec.toml"; }
  /// Throws UserError that names the differences from the origin of this folder's runs.
  void require(const Origin& origin) const;
  /// Throws UserError.
  void put(std::uint64_t index, const std::string& json) const;
  /// The text of a run's file, as it is; empty: there is none. Throws UserError.
  std::string get(std::uint64_t index) const;

 private:
  CampaignFolder(std::string path, std::string spec_text);
  std::string run_path(std::uint64_t index) const;

  std::string path_;
  std::string spec_text_;
  Origin origin_;
};

}  // namespace tp100::sim
