#pragma once
// A campaign as its file defines it: the number of runs, and the differences between them.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/robot/options.h"
#include "text/toml_document.h"

namespace tp100::sim {

struct Uniform {
  double low, high;
};
struct Normal {
  double mean, sd;
};
using List = std::vector<text::TomlValue>;

/// One quantity that a campaign varies from run to run.
struct Variable {
  std::string name;
  std::variant<text::TomlValue, Uniform, Normal, List> source;

  bool varies() const { return source.index() != 0; }
  /// Number of values of a list, else 1: the runs needed to see all of them.
  std::uint64_t choices() const;
};

/// Selects a run's value: from a list the one at `turn` (modulo its length); from uniform and
/// normal distributions one that depends only on `seed`, `index` and the variable's name. Pure.
struct SampleKey {
  std::uint64_t seed, index, turn;
};
text::TomlValue draw(const Variable& variable, const SampleKey& by);

/// Reads the variables in `table` and its nested tables, by full name, in alphabetical order: each
/// a value, or one of { uniform = [LOW, HIGH] }, { normal = [MEAN, SD] }, { list = [...] }. Throws
/// UserError.
std::vector<Variable> read_variables(text::TomlTable table, const std::string& prefix = "");

/// One run, fully determined.
struct PlannedRun {
  std::uint64_t index = 0;
  Options options{};
  std::string course;
  std::string camera;               ///< empty: no camera
  std::vector<std::string> faults;  ///< as for --fault
  text::NamedValues sampled;        ///< what differs from run to run
};

/// A campaign's file. config/campaigns/course-3.toml explains every key.
struct CampaignSpec {
  std::uint64_t runs = 0;
  std::uint64_t seed = 1;         ///< run i has the seed `seed` + i
  std::string config;             ///< configuration whose values are changed; empty: defaults
  std::vector<Variable> choices;  ///< board, body, camera, course, faults, floor, robot, setup
  std::vector<Variable> configuration;  ///< keys of tp100.toml
  std::vector<Variable> robot;          ///< keys of the robot's file
};

/// Throws UserError (file:line:column). Pure.
CampaignSpec parse_campaign(const std::string& text, const std::string& file);

/// Run `index` of the campaign. Lists are crossed: the first in alphabetical order changes with
/// every run, the next after each pass through the first, and so on. Pure.
PlannedRun plan(const CampaignSpec& spec, std::uint64_t index);

}  // namespace tp100::sim
