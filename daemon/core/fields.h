#pragma once
// The fields of a structure by name. A list of them is written once, and does not compile unless it
// has them all.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace tp100 {

template <class T, class Plain>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Plain>;

/// The names in "a, b, c", of which there are N.
template <std::size_t N>
consteval std::array<std::string_view, N> split_names(std::string_view list) {
  std::array<std::string_view, N> names;
  for (std::string_view& name : names) {
    name = list.substr(0, list.find(','));
    list.remove_prefix(std::min(name.size() + 2, list.size()));
  }
  return names;
}

template <std::size_t N, class Visitor, class... Fields>
void visit_each(const std::array<std::string_view, N>& names, Visitor& visit, Fields&... fields) {
  static_assert(sizeof...(fields) == N);
  std::size_t i = 0;
  (visit(names[i++], fields), ...);
}

/// The fields of `values` as an object of nlohmann's; null: an optional one that has no value.
template <class Json, class Values>
Json object_of(const Values& values) {
  Json json;
  visit_fields(
      [&json](std::string_view name, const auto& value) {
        if constexpr (requires { value.has_value(); }) {
          json[name] = value ? Json(*value) : Json(nullptr);
        } else {
          json[name] = value;
        }
      },
      values);
  return json;
}

}  // namespace tp100

/// Calls visit(name, variable) for each of these variables.
#define TP100_VISIT(visit, ...)                                                           \
  do {                                                                                    \
    constexpr std::string_view kList = #__VA_ARGS__;                                      \
    constexpr auto kCount = static_cast<std::size_t>(std::ranges::count(kList, ',') + 1); \
    static constexpr auto kNames = ::tp100::split_names<kCount>(kList);                   \
    ::tp100::visit_each(kNames, visit, __VA_ARGS__);                                      \
  } while (false)

/// Defines visit_fields(visit, object), which calls visit(name, field) for each field of a `Type`,
/// constant or not, in the order of its declaration.
#define TP100_FIELDS(Type, ...)                         \
  template <class Visitor, ::tp100::MaybeConst<Type> T> \
  void visit_fields(Visitor&& visit, T& object) {       \
    auto& [__VA_ARGS__] = object;                       \
    TP100_VISIT(visit, __VA_ARGS__);                    \
  }
