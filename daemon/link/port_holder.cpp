#include "link/port_holder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

namespace tp100::link {
namespace {

namespace fs = std::filesystem;

// The initial process namespace, in which all others lie; PROC_PID_INIT_INO of the kernel.
constexpr const char* kWholeMachine = "pid:[4026531836]";

/// True if /proc shows all processes: not within a container, nor with hidden accounts.
bool lists_all(const fs::path& proc) {
  std::error_code error;
  return fs::read_symlink(proc / "self/ns/pid", error) == kWholeMachine &&
         fs::exists(proc / "1", error);
}

/// Status of the device behind `path`; nothing if it is no device.
std::optional<struct stat> device_at(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISCHR(status.st_mode)) return std::nullopt;
  return status;
}

/// Whether an open file, of which `target` is the name, is the device.
bool is_same(const fs::path& file, const std::string& target, const struct stat& device) {
  // Only in /dev: elsewhere the look-up may wait for a disk.
  if (!target.starts_with("/dev/")) return false;
  const std::optional<struct stat> open = device_at(file);
  // Several nodes may lead to one device, but each container numbers its own terminals.
  return open && open->st_rdev == device.st_rdev &&
         (!target.starts_with("/dev/pts/") || open->st_dev == device.st_dev);
}

/// Whether the process has the device, or else any file of that name, open; nothing if that cannot
/// be determined.
std::optional<bool> holds(const fs::path& process, const std::string& real_path,
                          const std::optional<struct stat>& device) {
  std::error_code error;
  fs::directory_iterator fd(process / "fd", error);
  if (error == std::errc::permission_denied) return std::nullopt;
  for (const fs::directory_iterator end; !error && fd != end; fd.increment(error)) {
    std::error_code unreadable;
    const std::string target = fs::read_symlink(fd->path(), unreadable);
    if (device ? is_same(fd->path(), target, *device) : target == real_path) return true;
  }
  return false;
}

}  // namespace

PortHolder port_holder(const std::string& real_path, const fs::path& proc) {
  PortHolder holder;
  holder.others_hidden = !lists_all(proc);
  const std::optional<struct stat> device = device_at(real_path);
  std::error_code error;
  for (fs::directory_iterator process(proc, error), end; !error && process != end;
       process.increment(error)) {
    const std::string pid = process->path().filename();
    if (!std::all_of(pid.begin(), pid.end(), [](char c) { return c >= '0' && c <= '9'; })) continue;
    if (pid == std::to_string(::getpid())) continue;
    const std::optional<bool> held = holds(process->path(), real_path, device);
    if (!held) holder.others_hidden = true;
    if (!held.value_or(false)) continue;
    std::string name;
    std::getline(std::ifstream(process->path() / "comm"), name);
    holder.name = (name.empty() ? "a program" : name) + " (pid " + pid + ")";
    break;
  }
  return holder;
}

}  // namespace tp100::link
