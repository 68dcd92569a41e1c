#pragma once
// The runs of a campaign combined. The same runs give the same result, in whatever order and on
// whatever machine they were driven.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/campaign_spec.h"
#include "sim/campaign/summary.h"

namespace tp100::sim {

/// One run as read from its file.
struct MergedRun {
  std::uint64_t index = 0, seed = 0;
  std::map<std::string, std::string> sampled;     ///< as text
  std::map<std::string, double> sampled_numbers;  ///< those of them that are numbers
  std::string refused;  ///< why it could not be driven; empty: it was driven
  bool completed = false;
  std::string cause;  ///< why it was driven but not completed, as in `course --json`
  /// Every number of its figures by full name, of arrays the largest; infinite if there is none, as
  /// for a disturbance without recovery. Figures that depend on the machine are left out.
  std::map<std::string, double> figures;
};

/// One figure over the completed runs.
struct MergedFigure {
  std::string name;
  Summary summary{};
  std::vector<std::pair<std::uint64_t, double>> worst{};  ///< index and value, the worst first
  /// Rank correlation with each sampled number, if there is one.
  std::vector<std::pair<std::string, double>> correlations{};
};

struct MergedGroup {
  std::string variable, value;  ///< of a list
  std::size_t driven = 0, completed = 0;
  std::map<std::string, Summary> figures{};
};

struct Merged {
  std::uint64_t asked = 0;  ///< runs of the campaign
  std::vector<std::uint64_t> missing{};
  std::vector<MergedRun> runs{};  ///< the existing ones, by index
  std::size_t driven = 0, completed = 0;
  std::vector<MergedFigure> figures{};
  std::vector<MergedGroup> groups{};

  /// The run of this index, which must exist.
  const MergedRun& run(std::uint64_t index) const;
  /// Runs driven but not completed, by index: no figure counts them.
  std::vector<const MergedRun*> failed() const;
  /// Number of failures by cause, the most frequent first.
  std::vector<std::pair<std::string, std::size_t>> causes() const;
};

/// Parses a run's file; nothing: it is none, or not whole, as after a loss of power. Pure.
std::optional<MergedRun> parse_run_file(const std::string& text);

/// Combines `runs`, ordered by index, at most as many as the spec has. Pure.
Merged merge(const CampaignSpec& spec, std::vector<MergedRun> runs);

std::string merged_json(const Merged& merged);
/// One row per run: index, seed, completed, cause, refused, sampled values, every figure.
std::string merged_csv(const Merged& merged);

// The merged campaign as one offline page.

/// `spec_text` is shown unchanged; `facts`: what was driven, when and with what. Pure.
std::string merge_page(const Merged& merged, const std::string& spec_text,
                       const std::vector<std::pair<std::string, std::string>>& facts = {});

}  // namespace tp100::sim
