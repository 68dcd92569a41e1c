#pragma once
// The names of a table's columns as people write them: "Distance (cm)" for distance_m.

#include <string>
#include <string_view>

namespace tp100::text {

inline constexpr std::string_view kBlank = " \t\r\n";
/// Without white space at both ends, also the space that does not break, which copies of web pages
/// have.
std::string_view trimmed(std::string_view text);

struct Unit {
  std::string_view text, base;
  double size;  ///< in the base
};
/// Null: there is none of that name.
const Unit* unit_named(std::string_view text);

/// The name of a column, taken apart.
struct ColumnName {
  std::string stem;  ///< "gyro_z"
  std::string unit;  ///< "rad/s"; empty: none
};
ColumnName name_in(std::string_view cell);

}  // namespace tp100::text
