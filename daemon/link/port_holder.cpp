#include "link/port_holder.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

namespace tp100::link {
namespace {

namespace fs = std::filesystem;

/// Whether the process has it open; nothing if that cannot be seen.
std::optional<bool> holds(const fs::path& process, const std::string& real_path) {
  std::error_code error;
  fs::directory_iterator fd(process / "fd", error);
  if (error == std::errc::permission_denied) return std::nullopt;
  for (const fs::directory_iterator end; !error && fd != end; fd.increment(error)) {
    std::error_code unreadable;
    if (fs::read_symlink(fd->path(), unreadable) == real_path) return true;
  }
  return false;
}

}  // namespace

PortHolder port_holder(const std::string& real_path, const fs::path& proc) {
  PortHolder holder;
  std::error_code error;
  for (fs::directory_iterator process(proc, error), end; !error && process != end;
       process.increment(error)) {
    const std::string pid = process->path().filename();
    if (!std::all_of(pid.begin(), pid.end(), [](char c) { return c >= '0' && c <= '9'; })) continue;
    if (pid == std::to_string(::getpid())) continue;
    const std::optional<bool> held = holds(process->path(), real_path);
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
