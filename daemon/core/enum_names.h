#pragma once
// Names of an enum's values, as files and messages have them: one table beside each enum, from
// which the value is printed, parsed and offered as a choice.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tp100 {

template <class E>
struct EnumName {
  E value;
  const char* name;
};

/// Name of a value; "unknown" if the table does not have it.
template <class E, std::size_t N>
constexpr const char* name_in(const std::array<EnumName<E>, N>& names, E value) {
  for (const EnumName<E>& one : names)
    if (one.value == value) return one.name;
  return "unknown";
}

/// A change of a state, as in events: "run: idle -> arming". The states have a to_string().
template <class State>
std::string change_text(const std::string& what, State from, State to) {
  return what + ": " + std::string(to_string(from)) + " -> " + std::string(to_string(to));
}

/// The value of that name, or nothing.
template <class E, std::size_t N>
constexpr std::optional<E> value_in(const std::array<EnumName<E>, N>& names,
                                    std::string_view name) {
  for (const EnumName<E>& one : names)
    if (name == one.name) return one.value;
  return std::nullopt;
}

}  // namespace tp100
