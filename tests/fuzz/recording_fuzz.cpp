// Fuzzes the reader of recordings: complete, cut off or made up.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <memory>

#include "byte_source.h"
#include "record/recording.h"

namespace tp100 {
namespace {

using fuzz::require;

// A file in memory, because the reader needs a path.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size)
      : descriptor_(::memfd_create("recording", MFD_CLOEXEC)) {
    require(descriptor_ >= 0 && ::write(descriptor_, data, size) == static_cast<ssize_t>(size),
            "memory for the file");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void stream(const std::string& path) {
  const record::McapReader reader(path);
  record::McapHandler ignoring;
  const record::McapEnd end = reader.stream(ignoring);
  require(end.whole || !end.problem.empty(), "what is not whole has a problem");
}

void visit(const std::string& path) {
  const record::Recording recording(path);
  recording.visit({.step =
                       [](const StepRecord& record) {
                         require(record.now_ns < (HostNs{1} << 60), "times that no sum overflows");
                       },
                   .truth =
                       [](HostNs, const Pose& truth) {
                         require(std::isfinite(truth.x_m) && std::isfinite(truth.yaw_rad),
                                 "a finite truth");
                       },
                   .message = [](const std::string&, std::uint64_t, std::string_view) {}});
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 200000) return 0;
  const tp100::MemoryFile file(data, size);
  try {
    tp100::stream(file.path());
    tp100::visit(file.path());
  } catch (const tp100::UserError& error) {
    tp100::fuzz::require_message(error.what());
  }
  return 0;
}
