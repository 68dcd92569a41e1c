#pragma once
// A file without a name, for what would make memory grow: it goes with the program, however that
// ends. One thread.

#include <cstdint>
#include <span>
#include <string>

namespace tp100::record {

class NamelessFile {
 public:
  /// On the disk of `folder`. Throws SetupError.
  explicit NamelessFile(const std::string& folder);
  ~NamelessFile();
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  /// All of `bytes` at the end, or nothing. 0 or an errno.
  int append(std::span<const std::uint8_t> bytes);
  /// Fills `into` with what begins at `from`. 0 or an errno; EIO: there is less.
  int read(std::uint64_t from, std::span<std::uint8_t> into) const;
  std::uint64_t size() const { return size_; }

 private:
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace tp100::record
