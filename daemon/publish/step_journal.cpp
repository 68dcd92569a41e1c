#include "publish/step_journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "publish/step_codec.h"

namespace tp100::publish {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{64} << 10;

/// Calls `move(at, left)`, a read or write at an offset, until all is moved. Zero or an errno.
template <class Move>
int move_all(std::size_t size, Move move) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = move(done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 ? errno : EIO;
    done += static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace

StepJournal::StepJournal(const std::string& folder, std::uint64_t max_bytes)
    : max_bytes_(max_bytes) {
  std::string path = folder + "/.steps-XXXXXX";
  descriptor_ = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor_ < 0)
    throw SetupError(folder + ": nothing can be written there (" + std::strerror(errno) +
                     "); give another --record");
  ::unlink(path.c_str());
}

StepJournal::~StepJournal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void StepJournal::add(const StepRecord& record) {
  if (!problem_.empty()) return;
  if (record.step != ++steps_) return give_up("step " + std::to_string(steps_) + " is missing");
  encode_inputs(record, open_);
  if (open_.size() >= kBlockBytes) write_block();
}

void StepJournal::write_block() {
  if (written_ + open_.size() > max_bytes_) return give_up("they are more than record.max_mb");
  const int error = move_all(open_.size(), [&](std::size_t at, std::size_t left) {
    return ::pwrite(descriptor_, open_.data() + at, left, static_cast<off_t>(written_ + at));
  });
  if (error != 0) return give_up(std::strerror(error));
  sizes_.push_back(static_cast<std::uint32_t>(open_.size()));
  written_ += open_.size();
  open_.clear();
}

void StepJournal::read(const std::function<void(std::span<const std::uint8_t>)>& each) {
  std::uint64_t from = 0;
  Bytes block;
  for (const std::uint32_t size : std::vector(sizes_)) {
    block.resize(size);
    const int error = move_all(size, [&](std::size_t at, std::size_t left) {
      return ::pread(descriptor_, block.data() + at, left, static_cast<off_t>(from + at));
    });
    if (error != 0) return give_up(std::strerror(error));
    each(block);
    from += size;
  }
  if (!open_.empty()) each(open_);
}

// The disk gets its room back.
void StepJournal::give_up(std::string problem) {
  problem_ = std::move(problem);
  ::close(std::exchange(descriptor_, -1));
  sizes_.clear();
  open_ = {};
}

}  // namespace tp100::publish
