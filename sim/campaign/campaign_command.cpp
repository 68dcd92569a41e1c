#include "sim/campaign/campaign_command.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "course/bundled_files.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/campaign_spec.h"
#include "sim/campaign/merge.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/lockstep_recorder.h"
#include "text/atomic_file.h"
#include "text/format.h"
#include "text/progress.h"

namespace tp100::sim {
namespace {

/// Result of a run, as the text of its file: index, seed, sampled values, and either the figures
/// that `course --json` prints or "refused" with the reason (a sampled value that no robot can
/// have). The same run gives the same text except for figures that depend on the machine.
struct CampaignRun {
  std::string json;
  std::string refused;  ///< the reason; empty: it was driven
};
using Json = nlohmann::ordered_json;

Json figures_of(const PlannedRun& run, const std::string& record) {
  Loaded loaded = load(run.options);
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, run.course);
  const course::Course course =
      course::parse_course(loaded.files.course.text, loaded.files.course.path);
  LockstepSettings settings{
      .course = course,
      .robot = loaded.robot,
      .configuration = loaded.configuration,
      .setup = loaded.setup,
      .board = loaded.board,
      .camera = run.camera.empty() ? std::nullopt : std::optional(load_camera(run.camera)),
      .seed = run.options.seed,
      .faults = parse_faults(run.faults)};
  std::optional<LockstepRecorder> recorder;
  if (!record.empty()) recorder.emplace(record, loaded, run.options.seed).record(settings);
  const report::RunResult result = run_lockstep(settings);
  if (recorder) recorder->finish();
  return Json::parse(report::result_json(result, report::figures(result, course)));
}

/// Drives one run in virtual time. `record`: folder for its recording; empty: none. Throws only
/// exceptions other than UserError.
CampaignRun drive(const PlannedRun& run, const std::string& record) {
  CampaignRun done;
  Json json = {{"index", run.index}, {"seed", run.options.seed}};
  Json& sampled = json["sampled"] = Json::object();
  for (const auto& [name, value] : run.sampled)
    std::visit([&sampled, &key = name](const auto& one) { sampled[key] = one; }, value);
  try {
    json["result"] = figures_of(run, record);
  } catch (const UserError& error) {
    json["refused"] = done.refused = error.what();
  }
  done.json = json.dump() + "\n";
  return done;
}

constexpr std::size_t kNamedMissing = 5;
constexpr unsigned long long kNamedRefused = 5;

// Limit for a line of --todo, well below the longest argument that a system accepts.
constexpr std::size_t kRangesALine = 4000;

using Range = std::pair<std::uint64_t, std::uint64_t>;  ///< first and last

std::string text_of(const Range& range) {
  return std::to_string(range.first) +
         (range.first == range.second ? "" : "-" + std::to_string(range.second));
}

/// Parses "K" or "K-L"; none if it is neither, or not of this campaign.
std::optional<Range> read_range(std::string_view text, std::uint64_t runs) {
  Range range;
  const char* end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, range.first);
  range.second = range.first;
  if (error == std::errc() && at != end && *at == '-') {
    const auto second = std::from_chars(at + 1, end, range.second);
    at = second.ptr;
    error = second.ec;
  }
  if (error != std::errc() || at != end || range.first > range.second || range.second >= runs)
    return std::nullopt;
  return range;
}

/// The runs asked for.
std::vector<Range> ranges_of(const std::optional<std::string>& text, std::uint64_t runs) {
  if (!text) return {{0, runs - 1}};
  if (text->empty())
    throw UserError(
        "--index is empty; give runs as 3, 3-7 or 3,5-7,12, or leave --index out for all runs");
  std::vector<Range> ranges;
  for (std::size_t begin = 0; begin <= text->size();) {
    const std::size_t end = std::min(text->find(',', begin), text->size());
    const auto range = read_range(std::string_view(*text).substr(begin, end - begin), runs);
    if (!range)
      throw UserError("--index " + one_line(*text) + ": not runs of this campaign; give " +
                      "them as 3, 3-7 or 3,5-7,12, from 0 to " + std::to_string(runs - 1));
    ranges.push_back(*range);
    begin = end + 1;
  }
  return ranges;
}

/// Prints runs in lines as --index takes them.
class TodoLines {
 public:
  explicit TodoLines(std::uint64_t most) : most_(most) {}

  void add(std::uint64_t index) {
    if (!line_.empty() && line_.back().second + 1 == index && count_ < most_) {
      line_.back().second = index;
    } else {
      if (count_ == most_ || line_.size() == kRangesALine) print();
      line_.emplace_back(index, index);
    }
    ++count_;
  }
  void print() {
    std::string text;
    for (const Range& range : line_) text += (text.empty() ? "" : ",") + text_of(range);
    if (!text.empty()) std::printf("%s\n", text.c_str());
    line_.clear();
    count_ = 0;
  }

 private:
  std::uint64_t most_, count_ = 0;
  std::vector<Range> line_;
};

/// The run, if its file is there and whole.
std::optional<MergedRun> done_run(const CampaignFolder& folder, std::uint64_t index) {
  std::optional<MergedRun> run = parse_run_file(folder.get(index));
  return run && run->index == index ? std::move(run) : std::nullopt;
}

/// Prints the open runs, one range per line, as input for programs that distribute them.
void print_todo(const CampaignFolder& folder, const std::vector<Range>& ranges,
                std::uint64_t most) {
  TodoLines lines(most);
  for (const Range& range : ranges)
    for (std::uint64_t index = range.first; index <= range.second; ++index)
      if (!done_run(folder, index)) lines.add(index);
  lines.print();
}

Merged merge_folder(const CampaignFolder& folder, const CampaignSpec& spec) {
  std::vector<MergedRun> runs;
  for (std::uint64_t index = 0; index < spec.runs; ++index)
    if (std::optional<MergedRun> run = done_run(folder, index)) runs.push_back(std::move(*run));
  return merge(spec, std::move(runs));
}

std::string text_of(const text::TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return text->empty() ? "none" : *text;
  return std::visit([](const auto& one) { return Json(one).dump(); }, value);
}

std::string text_of(const Variable& variable) {
  if (const auto* value = std::get_if<text::TomlValue>(&variable.source)) return text_of(*value);
  if (const auto* uniform = std::get_if<Uniform>(&variable.source))
    return text::format("%g to %g, evenly", uniform->low, uniform->high);
  if (const auto* normal = std::get_if<Normal>(&variable.source))
    return text::format("%g, normal with sd %g", normal->mean, normal->sd);
  std::string text;
  for (const text::TomlValue& value : std::get<List>(variable.source))
    text += (text.empty() ? "each of: " : ", ") + text_of(value);
  return text;
}

/// True for an empty name: the value of the files, or no camera.
bool is_default(const Variable& variable) {
  const auto* value = std::get_if<text::TomlValue>(&variable.source);
  return value != nullptr && *value == text::TomlValue(std::string());
}

/// What was driven, when and with what, for the page.
std::vector<std::pair<std::string, std::string>> facts_of(const CampaignFolder& folder,
                                                          const CampaignSpec& spec) {
  std::vector<std::pair<std::string, std::string>> facts;
  const std::string origin_path = folder.path() + "/origin.txt";
  if (const std::int64_t begun = text::written_unix_s(origin_path); begun > 0) {
    facts.emplace_back("begun", text::utc_minute(begun));
    const Origin origin = read_origin(course::read_text_file(origin_path).text);
    if (const auto program = origin.find("program"); program != origin.end())
      facts.emplace_back("driven with", program->second);
  }
  facts.emplace_back("seeds", std::to_string(spec.seed) + " to " +
                                  std::to_string(spec.seed + spec.runs - 1) + ", one a run");
  for (const auto* variables : {&spec.choices, &spec.configuration, &spec.robot})
    for (const Variable& variable : *variables)
      if (!is_default(variable)) facts.emplace_back(variable.name, text_of(variable));
  return facts;
}

std::string missing_text(const Merged& merged) {
  std::string text = std::to_string(merged.missing.size()) + " of " + std::to_string(merged.asked) +
                     (merged.missing.size() == 1 ? " runs is missing (" : " runs are missing (");
  for (std::size_t i = 0; i < std::min(kNamedMissing, merged.missing.size()); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(merged.missing[i]);
  return text + (merged.missing.size() > kNamedMissing ? ", ..." : "") +
         "); run the campaign again: finished runs are not repeated";
}

struct Tally {
  unsigned long long driven = 0, done_before = 0, refused = 0;
};

void drive_one(const CampaignFolder& folder, const CampaignSpec& spec, std::uint64_t index,
               const std::string& record, text::Progress& progress, Tally& tally) {
  const CampaignRun run = drive(plan(spec, index), record);
  // A file may have been edited in the meantime.
  folder.require(origin_of(spec));
  folder.put(index, run.json);
  if (run.refused.empty()) {
    ++tally.driven;
  } else if (++tally.refused <= kNamedRefused) {
    progress.clear();
    std::fprintf(stderr, "tp100-sim: run %llu refused: %s\n",
                 static_cast<unsigned long long>(index), run.refused.c_str());
  }
}

}  // namespace

int run_campaign(const CampaignCommand& command) {
  const course::TextFile file = course::read_text_file(command.spec);
  const CampaignSpec spec = parse_campaign(file.text, file.path);
  const std::vector<Range> ranges = ranges_of(command.index, spec.runs);
  const CampaignFolder folder(command.out, file.text, origin_of(spec));
  if (command.todo > 0) {
    print_todo(folder, ranges, static_cast<std::uint64_t>(command.todo));
    return 0;
  }
  Tally tally;
  // To record a run it is driven again.
  std::vector<std::uint64_t> left;
  for (const Range& range : ranges)
    for (std::uint64_t index = range.first; index <= range.second; ++index)
      if (command.record.empty() && done_run(folder, index))
        ++tally.done_before;
      else
        left.push_back(index);
  {
    text::Progress progress("run", left.size());
    for (const std::uint64_t index : left) {
      drive_one(folder, spec, index, command.record, progress, tally);
      progress.step();
    }
  }
  if (tally.refused > kNamedRefused)
    std::fprintf(stderr, "tp100-sim: %llu more refused; `merge` lists each with its reason\n",
                 tally.refused - kNamedRefused);
  std::printf("%s: %s driven, %llu done before, %llu refused\n", command.out.c_str(),
              text::counted(tally.driven, "run").c_str(), tally.done_before, tally.refused);
  std::printf("next: tp100-sim merge %s\n", command.out.c_str());
  return tally.refused > 0 ? 1 : 0;
}

int run_merge(const std::string& path) {
  const CampaignFolder folder = CampaignFolder::existing(path);
  const CampaignSpec spec = parse_campaign(folder.spec_text(), folder.spec_path());
  const Merged merged = merge_folder(folder, spec);
  text::write_file(path + "/merged.json", merged_json(merged));
  text::write_file(path + "/runs.csv", merged_csv(merged));
  text::write_file(path + "/index.html",
                   merge_page(merged, folder.spec_text(), facts_of(folder, spec)));
  const std::size_t refused = merged.runs.size() - merged.driven;
  std::printf("%s: %zu of %zu driven runs completed; page: %s/index.html\n", path.c_str(),
              merged.completed, merged.driven, path.c_str());
  if (!merged.missing.empty())
    std::fprintf(stderr, "tp100-sim: %s\n", missing_text(merged).c_str());
  if (refused > 0)
    std::fprintf(stderr, "tp100-sim: %s refused; the page gives the reasons\n",
                 text::counted(refused, "run").c_str());
  return merged.missing.empty() && refused == 0 ? 0 : 1;
}

}  // namespace tp100::sim
