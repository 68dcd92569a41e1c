#pragma once
// Messages corrupted as by a bad line or a hostile sender.

#include <random>
#include <string>

namespace tp100::test {

/// The i-th corruption of a message: one to four of its bytes overwritten, and every `cut_every`-th
/// cut short.
inline std::string corrupted(const std::string& good, int i, int cut_every, std::mt19937& random) {
  std::uniform_int_distribution<std::size_t> place(0, good.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  std::string bad = good;
  for (int flips = i % 4; flips >= 0; --flips) bad[place(random)] = static_cast<char>(byte(random));
  if (i % cut_every == 0) bad.resize(place(random));
  return bad;
}

}  // namespace tp100::test
