#include "record/step_difference.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/arithmetic.h"
#include "record/step_fields.h"

namespace tp100::record {
namespace {

template <class T>
concept Number = std::is_arithmetic_v<T>;

/// All results in order.
class Results {
 public:
  struct Entry {
    std::string_view name;  ///< without the names of the structures around it
    std::uint64_t bits;
    bool real;
  };

  template <class T>
  void operator()(const char* name, const T& value) {
    if constexpr (std::same_as<T, double>) {
      entries.push_back({name, std::bit_cast<std::uint64_t>(value), true});
    } else if constexpr (Number<T>) {
      entries.push_back({name, static_cast<std::uint64_t>(value), false});
    } else {
      visit_fields(*this, value);
    }
  }
  template <std::size_t N>
  void operator()(const char* name, const std::array<double, N>& values) {
    for (const double value : values) (*this)(name, value);
  }
  template <class T>
  void operator()(const char* name, T value, T) {
    (*this)(name, static_cast<std::uint8_t>(value));
  }

  std::vector<Entry> entries;
};

/// Calls `each` with the index and both entries of all results that differ, until it returns false.
template <class Each>
void each_difference(const StepRecord& recorded, const StepRecord& computed, const Each& each) {
  thread_local Results was, is;
  was.entries.clear();
  is.entries.clear();
  visit_results(was, recorded);
  visit_results(is, computed);
  for (std::size_t i = 0; i < was.entries.size(); ++i) {
    if (was.entries[i].bits != is.entries[i].bits && !each(i, was.entries[i], is.entries[i]))
      return;
  }
}

template <class T>
std::string shown(T value) {
  std::array<char, 40> digits{};
  if constexpr (std::same_as<T, bool>) return value ? "true" : "false";
  const auto end = [&] {
    if constexpr (std::integral<T>)
      return std::to_chars(digits.data(), digits.data() + digits.size(), +value).ptr;
    else
      return std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  }();
  return {digits.data(), end};
}

/// Lists names and texts of all results in order. Slow: only for records known to differ.
class Lister {
 public:
  template <class T>
  void operator()(const char* name, const T& value) {
    if constexpr (Number<T>) {
      entries.push_back({prefix_ + name, shown(value)});
    } else {
      const std::string outer = prefix_;
      prefix_ += name;
      prefix_ += '.';
      visit_fields(*this, value);
      prefix_ = outer;
    }
  }
  template <std::size_t N>
  void operator()(const char* name, const std::array<double, N>& values) {
    for (const double value : values) (*this)(name, value);
  }
  template <class T>
  void operator()(const char* name, T value, T) {
    (*this)(name, static_cast<std::uint8_t>(value));
  }

  struct Entry {
    std::string field, value;
  };
  std::vector<Entry> entries;

 private:
  std::string prefix_;
};

Lister listed(const StepRecord& record) {
  Lister lister;
  visit_results(lister, record);
  return lister;
}

double distance(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  const double apart = std::abs(a - b);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

}  // namespace

std::optional<StepDifference> first_difference(const StepRecord& recorded,
                                               const StepRecord& computed) {
  std::optional<StepDifference> found;
  each_difference(recorded, computed, [&](std::size_t i, const auto&, const auto&) {
    const auto was = listed(recorded).entries[i], is = listed(computed).entries[i];
    found = {was.field, was.value, is.value};
    return false;
  });
  return found;
}

void LargestDifference::add(const StepRecord& recorded, const StepRecord& computed) {
  each_difference(recorded, computed, [&](std::size_t, const auto& was, const auto& is) {
    if (!was.real) {
      decided = true;
      return true;
    }
    const auto a = std::bit_cast<double>(was.bits), b = std::bit_cast<double>(is.bits);
    const double apart = distance(a, b);
    if (was.name.ends_with("_m")) {
      length_m = std::max(length_m, apart);
    } else if (was.name.ends_with("_rad")) {
      angle_rad = std::max(angle_rad, std::isinf(apart) ? apart : std::abs(wrap_angle(a - b)));
    } else {
      const double scale = std::isinf(apart) ? 1.0 : std::max({1.0, std::abs(a), std::abs(b)});
      other = std::max(other, apart / scale);
    }
    return true;
  });
}

bool LargestDifference::within(double limit) const {
  return !decided && std::max({length_m, angle_rad, other}) <= limit;
}

}  // namespace tp100::record
