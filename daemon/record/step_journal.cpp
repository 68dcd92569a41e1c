#include "record/step_journal.h"

#include <cstring>
#include <utility>

#include "record/step_codec.h"

namespace tp100::record {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{64} << 10;

}  // namespace

StepJournal::StepJournal(const std::string& folder, std::uint64_t max_bytes)
    : max_bytes_(max_bytes), file_(folder) {}

void StepJournal::add(const StepRecord& record) {
  if (!problem_.empty()) return;
  if (record.step != ++steps_) return give_up("step " + std::to_string(steps_) + " is missing");
  encode_inputs(record, open_);
  if (open_.size() >= kBlockBytes) write_block();
}

void StepJournal::write_block() {
  if (file_->size() + open_.size() > max_bytes_)
    return give_up("they are more than " + std::to_string(max_bytes_ / 1'000'000) +
                   " MB, see record.max_mb");
  if (const int error = file_->append(open_); error != 0) return give_up(std::strerror(error));
  sizes_.push_back(static_cast<std::uint32_t>(open_.size()));
  open_.clear();
}

void StepJournal::read(const std::function<void(std::span<const std::uint8_t>)>& each) {
  std::uint64_t from = 0;
  Bytes block;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    block.resize(sizes_[i]);
    if (const int error = file_->read(from, block); error != 0)
      return give_up(std::strerror(error));
    each(block);
    from += block.size();
  }
  if (!open_.empty()) each(open_);
}

// The disk gets its room back.
void StepJournal::give_up(std::string problem) {
  problem_ = std::move(problem);
  file_.reset();
  sizes_.clear();
  open_ = {};
}

}  // namespace tp100::record
