#include "text/column_name.h"

#include <algorithm>
#include <array>

#include "core/arithmetic.h"
#include "text/format.h"

namespace tp100::text {
namespace {

constexpr std::array<Unit, 36> kUnits = {{
    {"m", "m", 1.0},
    {"metre", "m", 1.0},
    {"meter", "m", 1.0},
    {"mm", "m", 1e-3},
    {"cm", "m", 1e-2},
    {"km", "m", 1e3},
    {"in", "m", 0.0254},
    {"inch", "m", 0.0254},
    {"inches", "m", 0.0254},
    {"ft", "m", 0.3048},
    {"s", "s", 1.0},
    {"sec", "s", 1.0},
    {"ms", "s", 1e-3},
    {"us", "s", 1e-6},
    {"ns", "s", 1e-9},
    {"rad", "rad", 1.0},
    {"deg", "rad", kRadPerDeg},
    {"degree", "rad", kRadPerDeg},
    {"°", "rad", kRadPerDeg},
    {"radps", "rad/s", 1.0},
    {"rad/s", "rad/s", 1.0},
    {"rad s^-1", "rad/s", 1.0},
    {"degps", "rad/s", kRadPerDeg},
    {"deg/s", "rad/s", kRadPerDeg},
    {"dps", "rad/s", kRadPerDeg},
    {"°/s", "rad/s", kRadPerDeg},
    {"mps", "m/s", 1.0},
    {"m/s", "m/s", 1.0},
    {"m s^-1", "m/s", 1.0},
    {"mmps", "m/s", 1e-3},
    {"mm/s", "m/s", 1e-3},
    {"cmps", "m/s", 1e-2},
    {"cm/s", "m/s", 1e-2},
    {"kmh", "m/s", 1.0 / 3.6},
    {"km/h", "m/s", 1.0 / 3.6},
    {"kph", "m/s", 1.0 / 3.6},
}};

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (true) {
    const std::size_t first = std::min(text.find_first_not_of(kBlank), text.size());
    text = text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
    // A space that does not break, which copies of web pages have.
    if (text.starts_with("\xc2\xa0"))
      text.remove_prefix(2);
    else if (text.ends_with("\xc2\xa0"))
      text.remove_suffix(2);
    else
      return text;
  }
}

const Unit* unit_named(std::string_view text) {
  if (text.size() > 2 && text.ends_with('s') && !text.ends_with("ps") && !text.ends_with("/s"))
    if (const Unit* one = unit_named(text.substr(0, text.size() - 1)); one != nullptr) return one;
  const auto found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& one) { return one.text == text; });
  return found == kUnits.end() ? nullptr : &*found;
}

ColumnName name_in(std::string_view cell) {
  std::string text = lower(trimmed(cell));
  ColumnName name;
  const std::size_t open = text.find_first_of("([");
  if (open != std::string::npos && (text.ends_with(')') || text.ends_with(']'))) {
    name.unit = trimmed(std::string_view(text).substr(open + 1, text.size() - open - 2));
    text = trimmed(std::string_view(text).substr(0, open));
  }
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  const std::size_t last = text.rfind('_');
  if (name.unit.empty() && last != std::string::npos && unit_named(text.substr(last + 1))) {
    name.unit = text.substr(last + 1);
    text.resize(last);
  }
  name.stem = text == "time" || text == "timestamp" ? "t" : text;
  return name;
}

}  // namespace tp100::text
