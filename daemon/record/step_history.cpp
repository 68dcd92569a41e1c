#include "record/step_history.h"

#include <cstring>
#include <utility>

#include "core/error.h"
#include "record/step_codec.h"
#include "text/atomic_file.h"

namespace tp100::record {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{64} << 10;
constexpr HostNs kLongestLookBackNs = 60 * kNsPerS;

std::string more_than(std::uint64_t bytes) {
  return "more than " + std::to_string(bytes / 1'000'000) + " MB";
}

/// The first `steps` entries of `block`.
std::span<const std::uint8_t> first_steps(std::span<const std::uint8_t> block,
                                          std::uint64_t& steps) {
  ByteReader in(block);
  while (steps > 0 && in.left() > 0) {
    in.bytes(in.number<std::uint32_t>());
    --steps;
  }
  return block.first(block.size() - in.left());
}

}  // namespace

void StepHistory::add(const StepRecord& record) {
  if (!record.inputs.restart.empty()) {
    before_ = std::exchange(newest_, Span{});
    newest_.first = record.step;
    newest_.began_ns = record.now_ns;
  }
  if (before_.steps > 0 && record.now_ns - newest_.began_ns > kLongestLookBackNs) before_ = {};
  if (!newest_.problem.empty()) return;
  if (record.step != newest_.first + newest_.steps)
    return give_up("step " + std::to_string(newest_.first + newest_.steps) + " is missing");
  ++newest_.steps;
  encode_inputs(record, newest_.open);
  if (newest_.open.size() >= kBlockBytes) close_block();
}

void StepHistory::forget(std::uint64_t next) {
  before_ = {};
  newest_ = Span{};
  newest_.first = next;
}

void StepHistory::close_block() {
  Span& span = newest_;
  span.bytes += span.open.size();
  if (span.bytes > settings_.max_bytes) return give_up(more_than(settings_.max_bytes));
  if (span.bytes <= settings_.memory_bytes) {
    // Copied, because a copy has no spare capacity.
    span.blocks.push_back({Bytes(span.open), 0});
    span.open.clear();
    return;
  }
  if (settings_.folder.empty()) return give_up("the memory for them is full, and no folder is set");
  try {
    if (!span.file) {
      text::make_folder(settings_.folder, "folder");
      span.file = std::make_unique<AnonymousFile>(settings_.folder);
    }
  } catch (const UserError& error) {
    return give_up(error.what());
  }
  if (const int error = span.file->append(span.open); error != 0)
    return give_up(std::strerror(error));
  span.blocks.push_back({{}, static_cast<std::uint32_t>(span.open.size())});
  span.open.clear();
}

std::string StepHistory::read(
    std::uint64_t first, std::uint64_t max_bytes,
    const std::function<void(std::span<const std::uint8_t>)>& each) const {
  const Span& span = first < newest_.first ? before_ : newest_;
  if (!span.problem.empty()) return span.problem;
  if (first < span.first || first > span.first + span.steps)
    return "step " + std::to_string(first) + " is too old";
  if (span.bytes + span.open.size() > max_bytes) return more_than(max_bytes);
  std::uint64_t steps = first - span.first;
  std::uint64_t from = 0;
  Bytes read;
  for (const Block& block : span.blocks) {
    if (steps == 0) return {};
    std::span<const std::uint8_t> bytes = block.bytes;
    if (block.bytes.empty()) {
      read.resize(block.size);
      if (const int error = span.file->read(from, read); error != 0) return std::strerror(error);
      from += read.size();
      bytes = read;
    }
    each(first_steps(bytes, steps));
  }
  if (steps > 0) each(first_steps(span.open, steps));
  return {};
}

// Frees memory and disk.
void StepHistory::give_up(std::string problem) {
  newest_ = {.first = newest_.first,
             .began_ns = newest_.began_ns,
             .steps = newest_.steps,
             .problem = std::move(problem)};
}

}  // namespace tp100::record
