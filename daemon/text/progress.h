#pragma once
// Progress of work that takes long, for whoever waits for it at a terminal.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace tp100::text {

/// "12 of 40 runs, 1 min 10 s left"; without an estimate before the first is done. `noun` is one
/// whose plural ends in s.
std::string progress_text(std::string_view noun, std::uint64_t done, std::uint64_t all,
                          double elapsed_s);

/// A line at the end of standard error, written anew in place, from two seconds on. Nothing unless
/// that is a terminal.
class Progress {
 public:
  Progress(std::string noun, std::uint64_t all);
  /// Clears the line.
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done.
  void step();
  /// Removes the line, before something else is printed; the next step() shows it again.
  void clear();

 private:
  std::string noun_;
  std::uint64_t all_, done_ = 0;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  bool terminal_, shown_ = false;
};

}  // namespace tp100::text
