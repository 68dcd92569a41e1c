#include "text/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/descriptor.h"
#include "text/temporary.h"

namespace tp100::text {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKept = ".bak";
constexpr std::size_t kBlock = std::size_t{1} << 16;

// Read once, before there is a second thread, because reading the mask changes it for a moment.
const mode_t kMask = [] {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return mask;
}();

[[noreturn]] void fail(const std::string& path, int error) {
  throw UserError(path + ": cannot be written (" + std::strerror(error) +
                  "); check folder, permission and free space");
}

/// The content of a small file. Throws UserError.
std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, errno);
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) fail(path, EIO);
  return text.str();
}

/// Paths that the program has read, and those that it has written before.
struct Inputs {
  std::mutex mutex;  // never held while waiting for the disk
  std::set<std::string> read, written;
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

/// Where the content is written.
struct Target {
  std::string path;                   // of the file to replace, links followed
  bool direct = false;                // not a regular file
  std::optional<struct stat> like{};  // the file to replace
};

Target target_of(const std::string& path) {
  struct stat status {};
  // Only a file that is certainly not there is made anew.
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) return {path};
    fail(path, errno);
  }
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (!S_ISREG(status.st_mode)) return {.path = path, .direct = true};
  // A link stays in place; the file that it points to is replaced.
  std::error_code error;
  const std::string file = fs::canonical(path, error).string();
  if (error) fail(path, error.value());
  return {.path = file, .like = status};
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// An open file; a temporary one is removed unless it was kept.
class Output {
 public:
  explicit Output(const Target& target) {
    if (target.direct) {
      file_ = Descriptor(::open(target.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    } else if (!fs::path(target.path).filename().empty()) {
      const std::string folder = folder_of(target.path);
      file_ = Descriptor(make_temporary_file(folder.empty() ? "." : folder, temporary_));
      // Closing the other one shows an error of the disk while this one still holds the lock.
      if (file_) lock_ = Descriptor(::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0));
    } else {
      errno = ENOENT;
    }
    if (!file_) {
      temporary_.clear();
      fail(target.path, errno);
    }
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  /// Zero or an errno.
  int write(std::string_view content) {
    std::size_t done = 0;
    return move_all(content.size(), done, [&](std::size_t at, std::size_t left) {
      return ::write(file_.get(), content.data() + at, left);
    });
  }

  int close(Flush flush) {
    // Pipes and terminals have nothing to flush.
    if (flush == Flush::kYes && ::fsync(file_.get()) != 0 && errno != EINVAL && errno != ENOTSUP &&
        errno != EROFS)
      return errno;
    return ::close(file_.release()) == 0 ? 0 : errno;
  }

  /// Gives the file the permissions of the one that it replaces, or of any new one.
  int permit(const std::optional<struct stat>& like) {
    if (!like) return ::fchmod(file_.get(), 0666 & ~kMask) == 0 ? 0 : errno;
    // Only root may give files away; a group may be one of ours.
    if (::fchown(file_.get(), like->st_uid, like->st_gid) != 0 &&
        ::fchown(file_.get(), static_cast<uid_t>(-1), like->st_gid) != 0 && errno != EPERM)
      return errno;
    return ::fchmod(file_.get(), like->st_mode & 07777) == 0 ? 0 : errno;
  }

  int rename_to(const std::string& path) {
    if (::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
    temporary_.clear();
    return 0;
  }

 private:
  Descriptor lock_, file_;
  std::string temporary_;
};

/// Writes `content` with the permissions of `like` in the place of the file `path`.
void write_like(const std::string& path, std::string_view content, const struct stat& like) {
  Output output({.path = path});
  int error = output.write(content);
  if (error == 0) error = output.permit(like);
  if (error == 0) error = output.close(Flush::kYes);
  if (error == 0) error = output.rename_to(path);
  if (error != 0) fail(path, error);
}

int move(const std::string& from, const std::string& to) {
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// Throws UserError.
void swap_files(const std::string& path, const std::string& kept) {
  if (::renameat2(AT_FDCWD, path.c_str(), AT_FDCWD, kept.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) fail(path, errno);
  const std::string third = kept + ".old";
  const std::string now = content_of(path);
  struct stat like {};
  if (::stat(path.c_str(), &like) != 0) fail(path, errno);
  if (const int error = move(kept, third); error != 0) fail(path, error);
  try {
    write_like(kept, now, like);
  } catch (const UserError&) {
    move(third, kept);
    throw;
  }
  if (const int error = move(third, path); error != 0) fail(path, error);
}

/// Throws UserError.
void require_plain(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) fail(path, errno);
  } else if (!S_ISREG(status.st_mode)) {
    throw UserError(path + ": a link or folder, no plain file; delete it by hand");
  }
}

}  // namespace

struct FileReplacement::State {
  explicit State(const std::string& p) : path(p), target(target_of(p)), output(target) {}
  std::string path;
  Target target;
  Output output;
  std::string waiting;

  int flush() {
    const int error = output.write(waiting);
    waiting.clear();
    return error;
  }
};

FileReplacement::FileReplacement(const std::string& path) {
  require_not_read(path);
  state_ = std::make_unique<State>(path);
}

FileReplacement::~FileReplacement() = default;

void FileReplacement::write(std::string_view content) {
  state_->waiting += content;
  if (state_->waiting.size() < kBlock) return;
  if (const int error = state_->flush(); error != 0) fail(state_->path, error);
}

void FileReplacement::commit(Flush flush) {
  State& s = *state_;
  int error = s.flush();
  if (error == 0 && !s.target.direct) error = s.output.permit(s.target.like);
  if (error == 0) error = s.output.close(flush);
  if (error == 0 && !s.target.direct) error = s.output.rename_to(s.target.path);
  if (error != 0) fail(s.path, error);
  note_written(s.path);
}

void write_file(const std::string& path, std::string_view content, Flush flush) {
  FileReplacement file(path);
  file.write(content);
  file.commit(flush);
}

std::string kept_path(const std::string& path) {
  std::error_code none;
  const fs::path file = fs::canonical(path, none);
  return (none ? path : file.string()) + kKept;
}

void edit_file(const std::string& path, std::string_view content) {
  const Target target = target_of(path);
  if (!target.like) return write_file(path, content);
  // The new text comes under the other name first, so that nothing is lost if it does not fit.
  const std::string kept = target.path + kKept;
  require_plain(kept);
  write_like(kept, content, *target.like);
  swap_files(target.path, kept);
}

void restore_file(const std::string& path) {
  const std::string file = target_of(path).path;
  require_plain(file + kKept);
  swap_files(file, file + kKept);
}

void note_read(const std::string& path) {
  const std::lock_guard lock(inputs().mutex);
  if (!inputs().written.contains(path)) inputs().read.insert(path);
}

void note_written(const std::string& path) {
  const std::lock_guard lock(inputs().mutex);
  inputs().written.insert(path);
}

void require_not_read(const std::string& path) {
  struct stat out {
  }, in{};
  if (::stat(path.c_str(), &out) != 0) {
    if (errno == ENOENT) return;
    fail(path, errno);
  }
  if (!S_ISREG(out.st_mode)) return;
  std::set<std::string> read;
  {
    const std::lock_guard lock(inputs().mutex);
    if (inputs().written.contains(path)) return;
    read = inputs().read;
  }
  for (const std::string& input : read)
    if (::stat(input.c_str(), &in) == 0 && in.st_dev == out.st_dev && in.st_ino == out.st_ino)
      throw UserError(
          path +
          ": this file is read, so nothing is written over it; give another path for the result");
}

void make_folder(const std::string& path, const std::string& option) {
  if (path.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    throw UserError(path + ": cannot create the folder (" + error.message() + "); give another " +
                    option);
}

std::int64_t written_unix_s(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

}  // namespace tp100::text
