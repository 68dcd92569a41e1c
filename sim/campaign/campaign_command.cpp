#include "sim/campaign/campaign_command.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <utility>

#include "analysis/atomic_file.h"
#include "app/bundled_files.h"
#include "core/error.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/campaign_run.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/merge_page.h"

namespace tp100::sim {
namespace {

constexpr std::size_t kNamedMissing = 5;

/// First and last run asked for.
std::pair<std::uint64_t, std::uint64_t> range_of(const std::string& text, std::uint64_t runs) {
  std::uint64_t first = 0, last = runs - 1;
  if (text.empty()) return {first, last};
  const char* end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, first);
  last = first;
  if (error == std::errc() && at != end && *at == '-') {
    const auto second = std::from_chars(at + 1, end, last);
    at = second.ptr;
    error = second.ec;
  }
  if (error != std::errc() || at != end || first > last || last >= runs)
    throw SetupError("--index " + course::one_line(text) + ": not a run of this campaign; give K " +
                     "or K-L, from 0 to " + std::to_string(runs - 1));
  return {first, last};
}

/// Lines of "K-L" for whoever spreads the runs over processors.
void print_todo(const CampaignFolder& folder, std::pair<std::uint64_t, std::uint64_t> range,
                std::uint64_t most) {
  const auto number = [](std::uint64_t of) { return static_cast<unsigned long long>(of); };
  for (std::uint64_t first = range.first; first <= range.second; ++first) {
    if (folder.has(first)) continue;
    std::uint64_t last = first;
    while (last < range.second && last - first + 1 < most && !folder.has(last + 1)) ++last;
    std::printf("%llu-%llu\n", number(first), number(last));
    first = last;
  }
}

Merged merge_folder(const CampaignFolder& folder, const CampaignSpec& spec) {
  std::vector<MergedRun> runs;
  for (std::uint64_t index = 0; index < spec.runs; ++index) {
    const std::string text = folder.get(index);
    if (!text.empty())
      runs.push_back(parse_run_file(text, folder.path() + ", run " + std::to_string(index)));
  }
  return merge(spec, std::move(runs));
}

std::string missing_text(const Merged& merged) {
  std::string text = std::to_string(merged.missing.size()) + " of " + std::to_string(merged.asked) +
                     " runs are missing (";
  for (std::size_t i = 0; i < std::min(kNamedMissing, merged.missing.size()); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(merged.missing[i]);
  return text + (merged.missing.size() > kNamedMissing ? ", ..." : "") +
         "); run the campaign again, what is done is not done again";
}

}  // namespace

int run_campaign(const CampaignCommand& command) {
  const app::TextFile file = app::read_text_file(command.spec);
  const CampaignSpec spec = parse_campaign(file.text, file.path);
  const auto [first, last] = range_of(command.index, spec.runs);
  const CampaignFolder folder(command.out, file.text);
  if (command.todo > 0) {
    print_todo(folder, {first, last}, static_cast<std::uint64_t>(command.todo));
    return 0;
  }
  std::uint64_t driven = 0, refused = 0;
  for (std::uint64_t index = first; index <= last; ++index) {
    if (folder.has(index) && command.record.empty()) continue;
    const CampaignRun run = drive(plan(spec, index), command.record);
    folder.put(index, run.json);
    ++driven;
    refused += std::uint64_t{run.refused};
    if (run.refused)
      std::fprintf(stderr, "tp100-sim: run %llu refused: %s",
                   static_cast<unsigned long long>(index), run.json.c_str());
  }
  std::printf("%s: %llu runs driven, %llu were done before, %llu refused\n", command.out.c_str(),
              static_cast<unsigned long long>(driven),
              static_cast<unsigned long long>(last - first + 1 - driven),
              static_cast<unsigned long long>(refused));
  return refused > 0 ? 1 : 0;
}

int run_merge(const std::string& path) {
  const CampaignFolder folder = CampaignFolder::existing(path);
  const CampaignSpec spec = parse_campaign(folder.spec_text(), folder.spec_path());
  const Merged merged = merge_folder(folder, spec);
  analysis::write_file(path + "/merged.json", merged_json(merged));
  analysis::write_file(path + "/runs.csv", merged_csv(merged));
  analysis::write_file(path + "/index.html", merge_page(merged, folder.spec_text()));
  const std::size_t refused = merged.runs.size() - merged.driven;
  std::printf("%s: %zu of %zu driven runs completed; page: %s/index.html\n", path.c_str(),
              merged.completed, merged.driven, path.c_str());
  if (!merged.missing.empty())
    std::fprintf(stderr, "tp100-sim: %s\n", missing_text(merged).c_str());
  if (refused > 0)
    std::fprintf(stderr, "tp100-sim: %zu runs were refused; the page says why\n", refused);
  return merged.missing.empty() && refused == 0 ? 0 : 1;
}

}  // namespace tp100::sim
