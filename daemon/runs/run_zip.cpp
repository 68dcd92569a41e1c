#include "runs/run_zip.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace tp100::runs {
namespace {

constexpr std::uint64_t kMaxBytes = 0xFFFF'FFFE;  // more would need the 64-bit form
constexpr std::uint16_t kVersion = 20;
constexpr std::uint16_t kUnix = 3, kNamesInUtf8 = 1U << 11U;
constexpr std::uint32_t kFileMode = (S_IFREG | 0644U) << 16U;

/// Little-endian fields, one after the other.
class Fields {
 public:
  Fields& u16(std::uint64_t value) { return put(value, 2); }
  Fields& u32(std::uint64_t value) { return put(value, 4); }
  Fields& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  std::string take() { return std::move(bytes_); }

 private:
  Fields& put(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
    return *this;
  }
  std::string bytes_;
};

/// Date and time as MS-DOS counts them: local, in steps of 2 s, from 1980 to 2107.
std::uint32_t dos_time(std::time_t at) {
  std::tm local{};
  ::localtime_r(&at, &local);
  const auto years = static_cast<std::uint32_t>(std::clamp(local.tm_year - 80, 0, 127));
  const auto of = [](int value) { return static_cast<std::uint32_t>(value); };
  return years << 25U | of(local.tm_mon + 1) << 21U | of(local.tm_mday) << 16U |
         of(local.tm_hour) << 11U | of(local.tm_min) << 5U | of(local.tm_sec) >> 1U;
}

}  // namespace

RunZip::RunZip(const std::string& folder, const std::string& run) : folder_(folder), run_(run) {
  // The name is checked before anything is opened by it.
  const std::vector<std::string> names = files_of(folder, run);
  used_.emplace(folder + "/" + run + "/" + record::kRecordingFile);
  for (const std::string& name : names) {
    std::uint64_t bytes = 0;
    const Descriptor file = open_run_file(folder, run, name, bytes);
    struct stat status {};
    if (!file || ::fstat(file.get(), &status) != 0) continue;
    if (entries_.size() == kMaxZipFiles)
      throw UserError(run + ": more than " + std::to_string(kMaxZipFiles) +
                      " files; copy its folder instead");
    entries_.push_back({.name = name,
                        .bytes = bytes,
                        .device = status.st_dev,
                        .inode = status.st_ino,
                        .modified = status.st_mtime});
  }
  for (Entry& entry : entries_) {
    entry.at = size_;
    size_ += header(entry, false).size() + entry.bytes;
  }
  size_ += directory().size();
  if (size_ > kMaxBytes)
    throw UserError(run + ": more than 4 GB; load its files one by one, or copy its folder");
  if (entries_.empty()) next_ = Next::kDirectory;
}

std::string RunZip::header(const Entry& entry, bool central) const {
  const std::string name = name_in_archive(entry);
  Fields fields;
  if (central)
    fields.u32(0x02014b50).u16(kUnix << 8U | kVersion);
  else
    fields.u32(0x04034b50);
  fields.u16(kVersion).u16(kNamesInUtf8).u16(0);
  fields.u32(dos_time(entry.modified));
  fields.u32(entry.crc).u32(entry.bytes).u32(entry.bytes).u16(name.size()).u16(0);
  if (central) fields.u16(0).u16(0).u16(0).u32(kFileMode).u32(entry.at);
  return fields.text(name).take();
}

std::string RunZip::directory() const {
  std::string all;
  for (const Entry& entry : entries_) all += header(entry, true);
  const std::uint64_t bytes = all.size(), count = entries_.size();
  const std::uint64_t at =
      entries_.empty()
          ? 0
          : entries_.back().at + header(entries_.back(), false).size() + entries_.back().bytes;
  Fields end;
  end.u32(0x06054b50).u16(0).u16(0).u16(count).u16(count).u32(bytes);
  end.u32(at).u16(0);
  return all + end.take();
}

bool RunZip::open() {
  const Entry& entry = entries_[at_];
  std::uint64_t bytes = 0;
  file_ = open_run_file(folder_, run_, entry.name, bytes);
  offset_ = 0;
  struct stat status {};
  return file_ && ::fstat(file_.get(), &status) == 0 && status.st_dev == entry.device &&
         status.st_ino == entry.inode && bytes >= entry.bytes;
}

std::optional<std::size_t> RunZip::read_file(std::span<char> into) {
  if (!file_ && !open()) return std::nullopt;
  const std::uint64_t left = entries_[at_].bytes - offset_;
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, into.size()));
  std::size_t got = 0;
  const int error = move_all(wanted, got, [&](std::size_t at, std::size_t more) {
    return ::pread(file_.get(), into.data() + at, more, static_cast<off_t>(offset_ + at));
  });
  if (error != 0) return std::nullopt;
  offset_ += got;
  return got;
}

std::optional<std::size_t> RunZip::read(std::span<char> into) {
  switch (next_) {
    case Next::kChecksum: {
      const auto got = read_file(into);
      if (!got) return std::nullopt;
      Entry& entry = entries_[at_];
      crc_.process_bytes(into.data(), *got);
      if (offset_ < entry.bytes) return 0;
      entry.crc = crc_.checksum();
      crc_.reset();
      offset_ = 0;
      next_ = Next::kContent;
      const std::string head = header(entry, false);
      return head.copy(into.data(), into.size());
    }
    case Next::kContent: {
      const auto got = read_file(into);
      if (got && offset_ == entries_[at_].bytes) {
        file_ = Descriptor();
        offset_ = 0;
        next_ = ++at_ < entries_.size() ? Next::kChecksum : Next::kDirectory;
      }
      return got;
    }
    case Next::kDirectory: {
      const std::string all = directory();
      const std::size_t got = all.copy(into.data(), into.size(), offset_);
      offset_ += got;
      if (offset_ == all.size()) next_ = Next::kEnd;
      return got;
    }
    case Next::kEnd:
      break;
  }
  return 0;
}

}  // namespace tp100::runs
