#pragma once
// The inputs of every step since the program's start, so that a recording that begins later can be
// replayed like any other: what a step knows is the sum of all that ever went in. Memory does not
// grow with it. One thread.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/step_record.h"
#include "record/nameless_file.h"

namespace tp100::record {

class StepJournal {
 public:
  /// In `folder`, up to `max_bytes`: forty kilobytes a second at 200 Hz. Throws SetupError.
  StepJournal(const std::string& folder, std::uint64_t max_bytes);

  /// The first step is number 1.
  void add(const StepRecord& record);
  /// Why it has not got all steps, and nothing to read any more; empty: it has.
  const std::string& problem() const { return problem_; }
  /// Everything so far, oldest first, in blocks (step_codec.h).
  void read(const std::function<void(std::span<const std::uint8_t> block)>& each);

 private:
  void write_block();
  void give_up(std::string problem);

  std::uint64_t max_bytes_;
  std::optional<NamelessFile> file_;  // none: gave up
  std::uint64_t steps_ = 0;
  std::vector<std::uint32_t> sizes_;  // of the blocks in the file
  Bytes open_;                        // the block that grows
  std::string problem_;
};

}  // namespace tp100::record
