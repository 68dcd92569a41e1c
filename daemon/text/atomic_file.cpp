#include "text/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace tp100::text {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = std::size_t{1} << 16;

// Read once, before there is a second thread, because reading the mask changes it for a moment.
const mode_t kMask = [] {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return mask;
}();

[[noreturn]] void fail(const std::string& path, int error) {
  throw SetupError(path + ": cannot be written (" + std::strerror(error) +
                   "); check folder, permission and free space");
}

/// An open file; a temporary one is removed unless it was kept.
class Output {
 public:
  Output(int descriptor, std::string temporary)
      : descriptor_(descriptor), temporary_(std::move(temporary)) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  /// Zero or an errno.
  int write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t n = ::write(descriptor_, content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return errno;
      content.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
  }

  int close(Flush flush) {
    // Pipes and terminals have nothing to flush.
    if (flush == Flush::kYes && ::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP &&
        errno != EROFS)
      return errno;
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    return result == 0 ? 0 : errno;
  }

  /// Gives the file the permissions of an ordinarily created one.
  int open_to_all() { return ::fchmod(descriptor_, 0666 & ~kMask) == 0 ? 0 : errno; }

  int rename_to(const std::string& path) {
    if (::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
    temporary_.clear();
    return 0;
  }

 private:
  int descriptor_;
  std::string temporary_;
};

/// Where the content is written.
struct Target {
  std::string path;     // of the file to replace, links followed
  bool direct = false;  // not a regular file
};

Target target_of(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail(path, EISDIR);
  if (!fs::exists(status)) return {path, false};
  if (!fs::is_regular_file(status)) return {path, true};
  // A link stays in place; the file that it points to is replaced.
  return {fs::canonical(path, error).string(), false};
}

Output open_output(const std::string& path, const Target& target) {
  if (target.direct) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) fail(path, errno);
    return {descriptor, {}};
  }
  std::string temporary = target.path + ".XXXXXX";
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) fail(path, errno);
  return {descriptor, temporary};
}

}  // namespace

struct FileReplacement::State {
  explicit State(const std::string& p)
      : path(p), target(target_of(p)), output(open_output(p, target)) {}
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

FileReplacement::FileReplacement(const std::string& path) : state_(std::make_unique<State>(path)) {}

FileReplacement::~FileReplacement() = default;

void FileReplacement::write(std::string_view content) {
  state_->waiting += content;
  if (state_->waiting.size() < kBlock) return;
  if (const int error = state_->flush(); error != 0) fail(state_->path, error);
}

void FileReplacement::commit(Flush flush) {
  State& s = *state_;
  int error = s.flush();
  if (error == 0 && !s.target.direct) error = s.output.open_to_all();
  if (error == 0) error = s.output.close(flush);
  if (error == 0 && !s.target.direct) error = s.output.rename_to(s.target.path);
  if (error != 0) fail(s.path, error);
}

void write_file(const std::string& path, std::string_view content, Flush flush) {
  FileReplacement file(path);
  file.write(content);
  file.commit(flush);
}

bool is_file_name(std::string_view name, std::size_t most) {
  return !name.empty() && name.size() <= most && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

void make_folder(const std::string& path, const std::string& option) {
  if (path.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    throw SetupError(path + ": cannot create the folder (" + error.message() + "); give another " +
                     option);
}

std::int64_t written_unix_s(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

}  // namespace tp100::text
