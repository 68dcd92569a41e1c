#include "analysis/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace tp100::analysis {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw SetupError(path + ": cannot be written (" + std::strerror(error) +
                   "); check folder, permission and free space");
}

/// An open file that goes away, if it is temporary, unless it was kept.
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

  int close() {
    // Pipes and terminals have nothing to flush.
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
      return errno;
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    return result == 0 ? 0 : errno;
  }

  int rename_to(const std::string& path) {
    if (::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
    temporary_.clear();
    return 0;
  }

 private:
  int descriptor_;
  std::string temporary_;
};

void write_directly(const std::string& path, std::string_view content) {
  Output output(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY), {});
  int error = errno;
  if (fs::is_directory(path)) fail(path, EISDIR);
  if ((error = output.write(content)) != 0 || (error = output.close()) != 0) fail(path, error);
}

}  // namespace

void write_file(const std::string& path, std::string_view content) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_directly(path, content);
    return;
  }
  // A link keeps its place; the file that it points to is replaced.
  const std::string target = fs::exists(status) ? fs::canonical(path, error).string() : path;
  std::string temporary = target + ".XXXXXX";
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) fail(path, errno);
  Output output(descriptor, temporary);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  int problem = output.write(content);
  if (problem == 0 && ::fchmod(descriptor, 0666 & ~mask) != 0) problem = errno;
  if (problem == 0) problem = output.close();
  if (problem == 0) problem = output.rename_to(target);
  if (problem != 0) fail(path, problem);
}

}  // namespace tp100::analysis
