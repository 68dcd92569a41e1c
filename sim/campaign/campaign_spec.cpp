#include "sim/campaign/campaign_spec.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace tp100::sim {
namespace {

constexpr text::Range kRuns{1.0, 1e6};
constexpr text::Range kSeeds{0.0, 9e15};

struct ChoiceKey {
  const char* name;
  const char* standard;
};
// In alphabetical order, as all variables are.
constexpr std::array<ChoiceKey, 6> kChoices = {{{"board", "native"},
                                                {"camera", ""},
                                                {"course", nullptr},
                                                {"faults", ""},
                                                {"robot", ""},
                                                {"setup", ""}}};

bool is_text(const text::TomlValue& value) { return std::holds_alternative<std::string>(value); }

bool only_texts(const Variable& variable) {
  if (const auto* value = std::get_if<text::TomlValue>(&variable.source)) return is_text(*value);
  const auto* list = std::get_if<List>(&variable.source);
  return list != nullptr && std::all_of(list->begin(), list->end(), is_text);
}

Variable read_choice(text::TomlTable& root, const ChoiceKey& key) {
  if (!root.has(key.name) && key.standard != nullptr)
    return {key.name, text::TomlValue(root.text(key.name, key.standard))};
  Variable variable = read_variable(root, key.name, key.name);
  if (!only_texts(variable))
    root.fail(key.name, std::string(key.name) + " needs a string or { list = [\"...\", ...] }");
  return variable;
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// Goes through the variables in their order and keeps what differs.
class Drawing {
 public:
  Drawing(const CampaignSpec& spec, PlannedRun& run) : spec_(spec), run_(run), turn_(run.index) {}

  text::TomlValue operator()(const Variable& variable, const std::string& prefix) {
    text::TomlValue value = draw(variable, {spec_.seed, run_.index, turn_});
    turn_ /= variable.choices();
    if (variable.varies()) run_.drawn.emplace_back(prefix + variable.name, value);
    return value;
  }

 private:
  const CampaignSpec& spec_;
  PlannedRun& run_;
  std::uint64_t turn_;
};

}  // namespace

CampaignSpec parse_campaign(const std::string& text, const std::string& file) {
  text::TomlTable root = text::TomlDocument(text, file).root();
  CampaignSpec spec;
  spec.runs = static_cast<std::uint64_t>(root.required_number("runs", kRuns));
  spec.seed = static_cast<std::uint64_t>(root.integer("seed", 1, kSeeds));
  spec.config = root.text("config", "");
  for (const ChoiceKey& key : kChoices) spec.choices.push_back(read_choice(root, key));
  spec.configuration = read_variables(root.table("configuration"));
  spec.robot = read_variables(root.table("robot_values"));
  root.finish();
  return spec;
}

PlannedRun plan(const CampaignSpec& spec, std::uint64_t index) {
  PlannedRun run;
  run.index = index;
  run.options.seed = spec.seed + index;
  run.options.config = spec.config;
  Drawing drawn(spec, run);
  for (const Variable& variable : spec.choices) {
    const std::string value = std::get<std::string>(drawn(variable, ""));
    if (variable.name == "board") run.options.board = value;
    if (variable.name == "camera") run.camera = value;
    if (variable.name == "course") run.course = value;
    if (variable.name == "faults") run.faults = words(value);
    if (variable.name == "robot") run.options.robot = value;
    if (variable.name == "setup") run.options.setup = value;
  }
  for (const Variable& variable : spec.configuration)
    run.options.configuration_values.emplace_back(variable.name, drawn(variable, ""));
  for (const Variable& variable : spec.robot)
    run.options.robot_values.emplace_back(variable.name, drawn(variable, "robot_values."));
  return run;
}

}  // namespace tp100::sim
