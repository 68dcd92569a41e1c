#include "sim/campaign/origin.h"

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <vector>

#include "config/configuration.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "sim/board/avr_image.h"
#include "sim/campaign/build_id.h"

namespace tp100::sim {
namespace {

constexpr std::size_t kLongestName = 1000;
constexpr const char* kNone = "not there";
// Another release of these may round otherwise.
constexpr std::array<std::string_view, 3> kLibraries = {"libm.", "libode.", "libsimavr."};

/// FNV-1a: files change by mistake here, not by malice.
std::string digest(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, hash);
  return text.data();
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

/// The robots of a run whose campaign names none.
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
    program();
    if (!spec_.config.empty())
      add("configuration " + spec_.config,
          [this] { return course::read_text_file(spec_.config).text; });
    for (const Variable& variable : spec_.choices)
      for (const std::string& value : texts_of(variable)) choice(variable.name, value);
    return std::move(origin_);
  }

 private:
  void program() {
    for (const auto& [name, id] : build_ids()) {
      if (name.empty()) origin_["program"] = "tp100-sim " TP100_VERSION ", build " + id;
      for (const std::string_view library : kLibraries)
        if (name.starts_with(library)) origin_["library " + name] = id;
    }
  }

  // The run says why a file cannot be read.
  template <class Read>
  void add(const std::string& name, Read read) {
    std::string& content = origin_[text::one_line(name, kLongestName)];
    try {
      content = digest(read());
    } catch (const SetupError&) {
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
    } catch (const SetupError&) {
      // As unreadable as the configuration, which stands here already.
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
  Origin origin_;
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

}  // namespace tp100::sim
