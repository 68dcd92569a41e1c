#include "doctor/disk_speed.h"

#include <stdlib.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/clock.h"
#include "core/time.h"

namespace tp100::doctor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPieceBytes = 1U << 20U;
constexpr int kPieces = 16;

std::string existing(const std::string& folder) {
  std::error_code error;
  fs::path at = folder.empty() ? fs::current_path(error) : fs::absolute(folder, error);
  while (at.has_relative_path() && !fs::is_directory(at, error)) at = at.parent_path();
  return at;
}

bool write_all(int fd) {
  const std::vector<char> piece(kPieceBytes, 'x');
  for (int i = 0; i < kPieces; ++i) {
    for (std::size_t done = 0; done < piece.size();) {
      const ssize_t n = ::write(fd, piece.data() + done, piece.size() - done);
      if (n < 0) return false;
      done += static_cast<std::size_t>(n);
    }
  }
  return ::fsync(fd) == 0;
}

}  // namespace

doctor::Disk try_disk(const std::string& folder) {
  doctor::Disk disk;
  disk.folder = existing(folder);
  std::string name = disk.folder + "/.tp100-doctor-XXXXXX";
  const int fd = ::mkostemp(name.data(), 0);
  if (fd < 0) {
    disk.error = std::strerror(errno);
    return disk;
  }
  ::unlink(name.c_str());
  struct statvfs space {};
  if (::fstatvfs(fd, &space) == 0)
    disk.free_mb = static_cast<double>(space.f_bavail) * static_cast<double>(space.f_frsize) * 1e-6;
  const HostNs begun = monotonic_now();
  if (!write_all(fd)) disk.error = std::strerror(errno);
  const double took_s = to_s(monotonic_now() - begun);
  ::close(fd);
  if (took_s > 0.0)
    disk.written_mb_per_s = kPieces * static_cast<double>(kPieceBytes) * 1e-6 / took_s;
  return disk;
}

}  // namespace tp100::doctor
