#include "sim/campaign/campaign_folder.h"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "analysis/atomic_file.h"
#include "app/bundled_files.h"
#include "core/error.h"

namespace tp100::sim {

namespace fs = std::filesystem;

CampaignFolder::CampaignFolder(std::string path, const std::string& spec_text)
    : path_(std::move(path)), spec_text_(spec_text) {
  analysis::make_folder(path_ + "/runs");
  if (!fs::exists(spec_path())) {
    analysis::write_file(spec_path(), spec_text_);
  } else if (app::read_text_file(spec_path()).text != spec_text_) {
    throw SetupError(path_ + ": holds the runs of another campaign (its spec.toml differs); give " +
                     "another --out, or delete it");
  }
}

CampaignFolder CampaignFolder::existing(const std::string& path) {
  if (!fs::exists(path + "/spec.toml"))
    throw SetupError(path + ": holds no campaign (no spec.toml in it); give the --out of one");
  return {path, app::read_text_file(path + "/spec.toml").text};
}

std::string CampaignFolder::run_path(std::uint64_t index) const {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "/runs/%06" PRIu64 ".json", index);
  return path_ + name.data();
}

bool CampaignFolder::has(std::uint64_t index) const { return fs::exists(run_path(index)); }

void CampaignFolder::put(std::uint64_t index, const std::string& json) const {
  analysis::write_file(run_path(index), json);
}

std::string CampaignFolder::get(std::uint64_t index) const {
  return has(index) ? app::read_text_file(run_path(index)).text : std::string();
}

}  // namespace tp100::sim
