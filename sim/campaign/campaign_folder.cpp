#include "sim/campaign/campaign_folder.h"

#include <link.h>

#include <array>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "sim/board/avr_image.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 1000, kMaxDifferenceText = 600;
constexpr const char* kNone = "not there";
// Other releases of these libraries may round differently.
constexpr std::array<std::string_view, 3> kLibraries = {"libm.", "libode.", "libsimavr."};

/// FNV-1a: files change by mistake here, not by malice.
std::string digest(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return text::format("%016" PRIx64, hash);
}

std::string digest_of_file(const char* path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return digest(content.str());
}

/// This program and the libraries that compute for it, as they were when they were loaded.
const Origin& program_origin() {
  static const Origin kOrigin = [] {
    Origin origin = {
        {"program", "tp100-sim " TP100_VERSION ", build " + digest_of_file("/proc/self/exe")}};
    const auto add = [](dl_phdr_info* module, std::size_t /*size*/, void* to) {
      const std::string name = fs::path(module->dlpi_name).filename();
      for (const std::string_view library : kLibraries)
        if (name.starts_with(library))
          (*static_cast<Origin*>(to))["library " + name] = digest_of_file(module->dlpi_name);
      return 0;
    };
    dl_iterate_phdr(add, &origin);
    return origin;
  }();
  return kOrigin;
}

/// Every text that the variable can take.
std::vector<std::string> texts_of(const Variable& variable) {
  List values;
  if (const auto* value = std::get_if<text::TomlValue>(&variable.source)) values = {*value};
  if (const auto* list = std::get_if<List>(&variable.source)) values = *list;
  std::vector<std::string> texts;
  for (const text::TomlValue& value : values)
    if (const auto* text = std::get_if<std::string>(&value)) texts.push_back(*text);
  return texts;
}

/// The configured robots, for a campaign that names none.
std::vector<std::string> configured_robots(const CampaignSpec& spec) {
  for (const Variable& variable : spec.configuration)
    if (variable.name == "robot") return texts_of(variable);
  if (spec.config.empty()) return {config::Configuration{}.robot};
  const course::TextFile file = course::read_text_file(spec.config);
  return {config::parse_configuration(file.text, file.path).robot};
}

class Finding {
 public:
  explicit Finding(const CampaignSpec& spec) : spec_(spec) {}

  Origin operator()() {
    if (!spec_.config.empty())
      add("configuration " + spec_.config,
          [this] { return course::read_text_file(spec_.config).text; });
    for (const Variable& variable : spec_.choices)
      for (const std::string& value : texts_of(variable)) choice(variable.name, value);
    return std::move(origin_);
  }

 private:
  // The run itself reports why a file cannot be read.
  template <class Read>
  void add(const std::string& name, Read read) {
    std::string& content = origin_[one_line(name, kLongestName)];
    try {
      content = digest(read());
    } catch (const UserError&) {
      content = kNone;
    }
  }

  void add_bundled(const char* noun, course::Bundled folder, const std::string& name) {
    add(std::string(noun) + " " + name, [&] { return course::read_bundled(folder, name).text; });
  }

  void add_robots() {
    try {
      for (const std::string& robot : configured_robots(spec_))
        add_bundled("robot", course::Bundled::kRobots, robot);
    } catch (const UserError&) {
      // The configuration's error is reported already.
    }
  }

  void choice(const std::string& variable, const std::string& value) {
    if (variable == "course") add_bundled("course", course::Bundled::kCourses, value);
    if (variable == "camera" && !value.empty())
      add_bundled("camera", course::Bundled::kCameras, value);
    if (variable == "robot" && !value.empty())
      add_bundled("robot", course::Bundled::kRobots, value);
    if (variable == "robot" && value.empty()) add_robots();
    if (variable == "board" && value == "avr")
      add("firmware", [] { return course::read_text_file(built_firmware()).text; });
  }

  const CampaignSpec& spec_;
  Origin origin_ = program_origin();
};

}  // namespace

Origin origin_of(const CampaignSpec& spec) { return Finding(spec)(); }

std::string origin_text(const Origin& origin) {
  std::string text;
  for (const auto& [name, content] : origin) text += name + ": " + content + "\n";
  return text;
}

Origin read_origin(const std::string& text) {
  Origin origin;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t colon = line.rfind(": "); colon != std::string::npos)
      origin[line.substr(0, colon)] = line.substr(colon + 2);
  return origin;
}

std::string difference(const Origin& before, const Origin& now) {
  std::string text;
  const auto say = [&text](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  for (const auto& [name, content] : before) {
    const auto found = now.find(name);
    if (found != now.end() && found->second == content) continue;
    const std::string is = found == now.end() ? kNone : found->second;
    say(name + " was " + content + ", is " + is);
  }
  for (const auto& [name, content] : now)
    if (!before.contains(name)) say(name + " was " + kNone + ", is " + content);
  return text;
}

CampaignFolder::CampaignFolder(std::string path, std::string spec_text)
    : path_(std::move(path)), spec_text_(std::move(spec_text)) {}

CampaignFolder::CampaignFolder(std::string path, std::string spec_text, Origin origin)
    : CampaignFolder(std::move(path), std::move(spec_text)) {
  const std::string origin_path = path_ + "/origin.txt";
  text::make_folder(path_ + "/runs");
  // Written before the spec: a program that finds the spec also finds the origin.
  const bool begun = fs::exists(spec_path());
  if (begun && course::read_text_file(spec_path()).text != spec_text_)
    throw UserError(path_ + ": holds the runs of another campaign (its spec.toml differs); give " +
                    "another --out, or delete it");
  if (fs::exists(origin_path)) {
    origin_ = read_origin(course::read_text_file(origin_path).text);
    require(origin);
  } else if (begun) {
    throw UserError(path_ + ": does not say which program drove its runs (no origin.txt); give " +
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
  throw UserError(path_ + ": its runs were made with different inputs (" +
                  one_line(differs, kMaxDifferenceText) +
                  "); restore that, or give another --out to drive all runs again");
}

CampaignFolder CampaignFolder::existing(const std::string& path) {
  if (!fs::exists(path + "/spec.toml"))
    throw UserError(path + ": holds no campaign (no spec.toml in it); give the --out of one");
  return CampaignFolder(path, course::read_text_file(path + "/spec.toml").text);
}

std::string CampaignFolder::run_path(std::uint64_t index) const {
  return path_ + text::format("/runs/%06" PRIu64 ".json", index);
}

void CampaignFolder::put(std::uint64_t index, const std::string& json) const {
  text::write_file(run_path(index), json);
}

std::string CampaignFolder::get(std::uint64_t index) const {
  return fs::exists(run_path(index)) ? course::read_text_file(run_path(index)).text : std::string();
}

}  // namespace tp100::sim
