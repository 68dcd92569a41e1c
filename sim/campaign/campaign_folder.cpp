#include "sim/campaign/campaign_folder.h"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "course/bundled_files.h"
#include "text/atomic_file.h"

namespace tp100::sim {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kSaidOfDifference = 600;

}  // namespace

CampaignFolder::CampaignFolder(std::string path, std::string spec_text)
    : path_(std::move(path)), spec_text_(std::move(spec_text)) {}

CampaignFolder::CampaignFolder(std::string path, std::string spec_text, Origin origin)
    : CampaignFolder(std::move(path), std::move(spec_text)) {
  const std::string origin_path = path_ + "/origin.txt";
  text::make_folder(path_ + "/runs");
  // Written before the spec, so whoever sees the spec sees it too.
  const bool begun = fs::exists(spec_path());
  if (begun && course::read_text_file(spec_path()).text != spec_text_)
    throw SetupError(path_ + ": holds the runs of another campaign (its spec.toml differs); give " +
                     "another --out, or delete it");
  if (fs::exists(origin_path)) {
    origin_ = read_origin(course::read_text_file(origin_path).text);
    require(origin);
  } else if (begun) {
    throw SetupError(path_ + ": does not say which program drove its runs (no origin.txt); give " +
                     "another --out to drive all of them with this one");
  } else {
    origin_ = std::move(origin);
    text::write_file(origin_path, origin_text(origin_));
  }
  if (!begun) text::write_file(spec_path(), spec_text_);
}

void CampaignFolder::require(const Origin& origin) const {
  const std::string differs = difference(origin_, origin);
  if (differs.empty()) return;
  throw SetupError(path_ + ": its runs come from something else (" +
                   text::one_line(differs, kSaidOfDifference) +
                   "); put that back, or give another --out to drive all runs anew");
}

CampaignFolder CampaignFolder::existing(const std::string& path) {
  if (!fs::exists(path + "/spec.toml"))
    throw SetupError(path + ": holds no campaign (no spec.toml in it); give the --out of one");
  return CampaignFolder(path, course::read_text_file(path + "/spec.toml").text);
}

std::string CampaignFolder::run_path(std::uint64_t index) const {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "/runs/%06" PRIu64 ".json", index);
  return path_ + name.data();
}

bool CampaignFolder::has(std::uint64_t index) const { return fs::exists(run_path(index)); }

void CampaignFolder::put(std::uint64_t index, const std::string& json) const {
  text::write_file(run_path(index), json);
}

std::string CampaignFolder::get(std::uint64_t index) const {
  return has(index) ? course::read_text_file(run_path(index)).text : std::string();
}

}  // namespace tp100::sim
