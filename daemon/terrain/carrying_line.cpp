#include "terrain/carrying_line.h"

#include <algorithm>
#include <cmath>

namespace tp100::terrain {
namespace {

constexpr std::size_t kPlaces = CarryingLine::kPlaces;
// Exactly at a place all lines through it are equally high: a little beside it they are not.
constexpr double kBeside = 1e-9;

constexpr std::array<double, kPlaces> kOneOver = [] {
  std::array<double, kPlaces> share{};
  for (std::size_t i = 1; i < kPlaces; ++i) share[i] = 1.0 / static_cast<double>(i);
  return share;
}();

CarryingLine through(const WheelHeights& wheel, std::size_t before, std::size_t after, double com) {
  const double rise = (wheel[after] - wheel[before]) * kOneOver[after - before];
  return {before, after, rise, wheel[before] + rise * (com - static_cast<double>(before))};
}

void raise(CarryingLine& line, const CarryingLine& other) {
  if (other.height > line.height) line = other;
}

}  // namespace

CarryingLine carrying_line(const WheelHeights& wheel, double com) {
  const double last = std::clamp(std::floor(com), 0.0, static_cast<double>(kPlaces - 2));
  const auto before = static_cast<std::size_t>(last);
  if (com >= last && com <= last + 1.0) com = std::clamp(com, last + kBeside, last + 1.0 - kBeside);
  CarryingLine line = through(wheel, 0, before + 1, com);
  for (bool higher = true; higher;) {
    // Best from one end, then from the other: where neither can better it, it is the highest of
    // all.
    const double until_now = line.height;
    for (std::size_t j = before + 1, i = line.before; j < kPlaces; ++j)
      raise(line, through(wheel, i, j, com));
    for (std::size_t i = 0, j = line.after; i <= before; ++i)
      raise(line, through(wheel, i, j, com));
    higher = line.height > until_now;
  }
  return line;
}

}  // namespace tp100::terrain
