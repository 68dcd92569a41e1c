#include "record/step_difference.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "record/step_fields.h"
#include "text/format.h"

namespace tp100::record {
namespace {

/// All results in order.
class Results {
 public:
  enum class Kind : std::uint8_t { kFlag, kUnsigned, kSigned, kReal };
  struct Entry {
    std::string_view name;
    std::size_t group;  ///< the structure around it
    Kind kind;
    std::uint64_t bits;
  };

  explicit Results(const StepRecord& record) { visit_results(*this, record); }

  template <class T>
  void operator()(std::string_view name, const T& value) {
    if constexpr (std::same_as<T, double>) {
      add(name, Kind::kReal, std::bit_cast<std::uint64_t>(value));
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      add(name,
          std::same_as<T, bool> ? Kind::kFlag
          : std::is_signed_v<T> ? Kind::kSigned
                                : Kind::kUnsigned,
          static_cast<std::uint64_t>(value));
    } else {
      groups_.emplace_back(name, group_);
      const std::size_t outer = std::exchange(group_, groups_.size() - 1);
      visit_fields(*this, value);
      group_ = outer;
    }
  }
  template <std::size_t N>
  void operator()(std::string_view name, const std::array<double, N>& values) {
    for (const double value : values) (*this)(name, value);
  }

  /// With the names of the structures around it.
  std::string full_name(const Entry& entry) const {
    std::string name(entry.name);
    for (std::size_t at = entry.group; at != 0; at = groups_[at].second)
      name = std::string(groups_[at].first) + "." + name;
    return name;
  }

  std::vector<Entry> entries;

 private:
  void add(std::string_view name, Kind kind, std::uint64_t bits) {
    entries.push_back({name, group_, kind, bits});
  }

  std::vector<std::pair<std::string_view, std::size_t>> groups_{{}};  // name and outer group
  std::size_t group_ = 0;
};

std::string shown(const Results::Entry& entry) {
  switch (entry.kind) {
    case Results::Kind::kFlag:
      return entry.bits != 0 ? "true" : "false";
    case Results::Kind::kUnsigned:
      return std::to_string(entry.bits);
    case Results::Kind::kSigned:
      return std::to_string(static_cast<std::int64_t>(entry.bits));
    case Results::Kind::kReal:
      break;
  }
  return text::shortest(std::bit_cast<double>(entry.bits));
}

double distance(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  const double apart = std::abs(a - b);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

}  // namespace

std::optional<StepDifference> first_difference(const StepRecord& recorded,
                                               const StepRecord& computed) {
  const Results was(recorded), is(computed);
  const auto [first, other] = std::ranges::mismatch(was.entries, is.entries, {},
                                                    &Results::Entry::bits, &Results::Entry::bits);
  if (first == was.entries.end()) return std::nullopt;
  return StepDifference{was.full_name(*first), shown(*first), shown(*other)};
}

void LargestDifference::add(const StepRecord& recorded, const StepRecord& computed) {
  const Results before(recorded), after(computed);
  for (std::size_t i = 0; i < before.entries.size(); ++i) {
    const Results::Entry &was = before.entries[i], &is = after.entries[i];
    if (was.bits == is.bits) continue;
    if (was.kind != Results::Kind::kReal) {
      decided = true;
      continue;
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
  }
}

bool LargestDifference::within(double limit) const {
  return !decided && std::max({length_m, angle_rad, other}) <= limit;
}

}  // namespace tp100::record
