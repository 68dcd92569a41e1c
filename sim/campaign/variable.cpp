#include "sim/campaign/variable.h"

#include <cmath>
#include <random>

#include "core/angle.h"

namespace tp100::sim {
namespace {

using text::TomlTable;
using text::TomlValue;

/// Evenly between 0 and 1, ends left out; the same in every program.
class Shares {
 public:
  Shares(const DrawnBy& by, const std::string& name) {
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

bool is_drawn(const TomlTable& table) {
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

Variable read_drawn(TomlTable drawn, const std::string& name) {
  if (drawn.has("uniform")) {
    const auto [low, high] = two_numbers(drawn, "uniform", "the lowest and the highest");
    if (low > high) drawn.fail("uniform", "the lowest comes first");
    return {name, Uniform{low, high}};
  }
  if (drawn.has("normal")) {
    const auto [mean, sd] = two_numbers(drawn, "normal", "mean and standard deviation");
    if (sd < 0.0) drawn.fail("normal", "a standard deviation is not negative");
    return {name, Normal{mean, sd}};
  }
  List list = drawn.values("list");
  if (list.empty())
    drawn.fail("list", "'" + name +
                           "' needs a value, or one of { uniform = [LOW, HIGH] }, { normal = "
                           "[MEAN, SD] }, { list = [...] }");
  return {name, std::move(list)};
}

}  // namespace

std::uint64_t Variable::choices() const {
  const auto* list = std::get_if<List>(&source);
  return list == nullptr ? 1 : list->size();
}

TomlValue draw(const Variable& variable, const DrawnBy& by) {
  if (const auto* value = std::get_if<TomlValue>(&variable.source)) return *value;
  if (const auto* list = std::get_if<List>(&variable.source))
    return list->at(static_cast<std::size_t>(by.turn % list->size()));
  Shares shares(by, variable.name);
  const double share = shares.next();
  if (const auto* uniform = std::get_if<Uniform>(&variable.source))
    return uniform->low + (uniform->high - uniform->low) * share;
  const Normal& normal = std::get<Normal>(variable.source);
  // Box and Muller's; the library's own may differ between libraries.
  return normal.mean +
         normal.sd * std::sqrt(-2.0 * std::log(share)) * std::cos(2.0 * kPi * shares.next());
}

Variable read_variable(TomlTable& table, const std::string& key, const std::string& name) {
  if (!table.holds_table(key)) return {name, table.required_value(key)};
  return read_drawn(table.table(key), name);
}

std::vector<Variable> read_variables(TomlTable table, const std::string& prefix) {
  std::vector<Variable> variables;
  for (const std::string& key : table.keys()) {
    const std::string name = prefix + key;
    if (!table.holds_table(key)) {
      variables.push_back({name, table.required_value(key)});
    } else if (TomlTable inner = table.table(key); is_drawn(inner)) {
      variables.push_back(read_drawn(inner, name));
    } else {
      for (Variable& one : read_variables(inner, name + ".")) variables.push_back(std::move(one));
    }
  }
  return variables;
}

}  // namespace tp100::sim
