#pragma once
// One thing that a campaign varies from run to run.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "text/toml_document.h"

namespace tp100::sim {

struct Uniform {
  double low, high;
};
struct Normal {
  double mean, sd;
};
using List = std::vector<text::TomlValue>;

struct Variable {
  std::string name;
  std::variant<text::TomlValue, Uniform, Normal, List> source;

  bool varies() const { return source.index() != 0; }
  /// Values of a list, else 1: so many runs it takes to see all of them.
  std::uint64_t choices() const;
};

/// Which value a run gets: from lists the one at `turn` (modulo their length), from uniform and
/// normal what `seed`, `index` and the name decide, whatever else is drawn. Pure.
struct DrawnBy {
  std::uint64_t seed, index, turn;
};
text::TomlValue draw(const Variable& variable, const DrawnBy& by);

/// A value, or one of { uniform = [LOW, HIGH] }, { normal = [MEAN, SD] }, { list = [...] }. Throws
/// SetupError.
Variable read_variable(text::TomlTable& table, const std::string& key, const std::string& name);

/// The variables in `table` and in the tables within, by full name, in alphabetical order. Throws
/// SetupError.
std::vector<Variable> read_variables(text::TomlTable table, const std::string& prefix = "");

}  // namespace tp100::sim
