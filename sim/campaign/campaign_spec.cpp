#include "sim/campaign/campaign_spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

using text::TomlTable;
using text::TomlValue;

/// Uniform numbers between 0 and 1, both excluded; the same with every standard library.
class Shares {
 public:
  Shares(const SampleKey& by, const std::string& name) {
    std::vector<std::uint32_t> words;
    for (const std::uint64_t number : {by.seed, by.index}) {
      words.push_back(static_cast<std::uint32_t>(number));
      words.push_back(static_cast<std::uint32_t>(number >> 32));
    }
    for (const char c : name) words.push_back(static_cast<unsigned char>(c));
    std::seed_seq sequence(words.begin(), words.end());
    random_.seed(sequence);
  }
  double next() {
    return (static_cast<double>(random_() >> 11) + 0.5) / static_cast<double>(1ULL << 53);
  }

 private:
  std::mt19937_64 random_;
};

bool is_sampled(const TomlTable& table) {
  return table.has("uniform") || table.has("normal") || table.has("list");
}

std::pair<double, double> two_numbers(TomlTable& table, const char* key, const char* what) {
  const std::vector<TomlValue> values = table.values(key);
  std::vector<double> numbers;
  for (const TomlValue& value : values) {
    if (const auto* whole = std::get_if<long long>(&value)) {
      numbers.push_back(static_cast<double>(*whole));
    } else if (const auto* number = std::get_if<double>(&value)) {
      numbers.push_back(*number);
    }
  }
  if (values.size() != 2 || numbers.size() != 2 || !std::isfinite(numbers[0]) ||
      !std::isfinite(numbers[1]))
    table.fail(key, std::string(key) + " needs two numbers: " + what);
  return {numbers[0], numbers[1]};
}

Variable read_sampled(TomlTable sampled, const std::string& name) {
  if (sampled.has("uniform")) {
    const auto [low, high] = two_numbers(sampled, "uniform", "the lowest and the highest");
    if (low > high) sampled.fail("uniform", "the lowest comes first");
    return {name, Uniform{low, high}};
  }
  if (sampled.has("normal")) {
    const auto [mean, sd] = two_numbers(sampled, "normal", "mean and standard deviation");
    if (sd < 0.0) sampled.fail("normal", "a standard deviation is not negative");
    return {name, Normal{mean, sd}};
  }
  List list = sampled.values("list");
  if (list.empty())
    sampled.fail("list", "'" + name +
                             "' needs a value, or one of { uniform = [LOW, HIGH] }, { normal = "
                             "[MEAN, SD] }, { list = [...] }");
  return {name, std::move(list)};
}

constexpr text::Range kRuns{1.0, 1e6};
constexpr text::Range kSeeds{0.0, 9e15};

struct ChoiceKey {
  const char* name;
  const char* standard;
};
// In alphabetical order, as all variables are.
constexpr std::array<ChoiceKey, 8> kChoices = {{{"board", "native"},
                                                {"body", ""},
                                                {"camera", ""},
                                                {"course", nullptr},
                                                {"faults", ""},
                                                {"floor", ""},
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
  Variable variable = root.holds_table(key.name)
                          ? read_sampled(root.table(key.name), key.name)
                          : Variable{key.name, root.required_value(key.name)};
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

/// Samples the variables in their order and keeps the values that vary.
class Sampling {
 public:
  Sampling(const CampaignSpec& spec, PlannedRun& run) : spec_(spec), run_(run), turn_(run.index) {}

  text::TomlValue operator()(const Variable& variable, const std::string& prefix) {
    text::TomlValue value = draw(variable, {spec_.seed, run_.index, turn_});
    turn_ /= variable.choices();
    if (variable.varies()) run_.sampled.emplace_back(prefix + variable.name, value);
    return value;
  }

 private:
  const CampaignSpec& spec_;
  PlannedRun& run_;
  std::uint64_t turn_;
};

}  // namespace

std::uint64_t Variable::choices() const {
  const auto* list = std::get_if<List>(&source);
  return list == nullptr ? 1 : list->size();
}

TomlValue draw(const Variable& variable, const SampleKey& by) {
  if (const auto* value = std::get_if<TomlValue>(&variable.source)) return *value;
  if (const auto* list = std::get_if<List>(&variable.source))
    return list->at(static_cast<std::size_t>(by.turn % list->size()));
  Shares shares(by, variable.name);
  const double share = shares.next();
  if (const auto* uniform = std::get_if<Uniform>(&variable.source))
    return uniform->low + (uniform->high - uniform->low) * share;
  const Normal& normal = std::get<Normal>(variable.source);
  // Box-Muller transform: std::normal_distribution differs between standard libraries.
  return normal.mean +
         normal.sd * std::sqrt(-2.0 * std::log(share)) * std::cos(2.0 * kPi * shares.next());
}

std::vector<Variable> read_variables(TomlTable table, const std::string& prefix) {
  std::vector<Variable> variables;
  for (const std::string& key : table.keys()) {
    const std::string name = prefix + key;
    if (!table.holds_table(key)) {
      variables.push_back({name, table.required_value(key)});
    } else if (TomlTable inner = table.table(key); is_sampled(inner)) {
      variables.push_back(read_sampled(inner, name));
    } else {
      for (Variable& one : read_variables(inner, name + ".")) variables.push_back(std::move(one));
    }
  }
  return variables;
}

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
  Sampling sampled(spec, run);
  for (const Variable& variable : spec.choices) {
    const std::string value = std::get<std::string>(sampled(variable, ""));
    if (variable.name == "board") run.options.board = value;
    if (variable.name == "body") run.options.body = value;
    if (variable.name == "camera") run.camera = value;
    if (variable.name == "course") run.course = value;
    if (variable.name == "faults") run.faults = words(value);
    if (variable.name == "floor") run.options.floor = value;
    if (variable.name == "robot") run.options.robot = value;
    if (variable.name == "setup") run.options.setup = value;
  }
  for (const Variable& variable : spec.configuration)
    run.options.configuration_values.emplace_back(variable.name, sampled(variable, ""));
  for (const Variable& variable : spec.robot)
    run.options.robot_values.emplace_back(variable.name, sampled(variable, "robot_values."));
  return run;
}

}  // namespace tp100::sim
