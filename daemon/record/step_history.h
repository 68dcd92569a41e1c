#pragma once
// Keeps the inputs of the steps since the last restart of the step (StepInputs::restart), so that a
// recording that begins later can be replayed: a step's state is the result of all inputs since.
// The first megabytes stay in memory; later ones go to a file. One thread.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/step_record.h"
#include "record/recording_file.h"

namespace tp100::record {

struct HistorySettings {
  std::string folder{};                   ///< of the file, made if absent; empty: memory only
  std::uint64_t max_bytes = 300'000'000;  ///< the history stops there: two hours at 200 Hz
  std::uint64_t memory_bytes = 8'000'000;
};

/// It holds two spans of steps, each of which begins at a restart of the step: the newest, and, for
/// recordings that look back up to a minute, the one before.
class StepHistory {
 public:
  explicit StepHistory(HistorySettings settings) : settings_(std::move(settings)) {}

  /// The first step is number 1.
  void add(const StepRecord& record);
  /// Discards the steps before number `next`, which restarts with another course, robot or set-up.
  void forget(std::uint64_t next);
  /// Passes the inputs of all steps that are needed before step `first`, oldest first, in blocks
  /// (step_codec.h). Returns why they are incomplete, in one line, or nothing. Above `max_bytes`
  /// nothing is passed.
  std::string read(std::uint64_t first, std::uint64_t max_bytes,
                   const std::function<void(std::span<const std::uint8_t> block)>& each) const;

 private:
  struct Block {
    Bytes bytes;             // empty: in the file
    std::uint32_t size = 0;  // there
  };
  struct Span {
    std::uint64_t first = 1;  // number of its first step
    HostNs began_ns = 0;
    std::uint64_t steps = 0;
    std::vector<Block> blocks{};
    Bytes open{};  // the growing block
    std::uint64_t bytes = 0;
    std::unique_ptr<AnonymousFile> file{};
    std::string problem{};  // why steps are missing
  };

  void close_block();
  void give_up(std::string problem);

  HistorySettings settings_;
  Span newest_{}, before_{};
};

}  // namespace tp100::record
