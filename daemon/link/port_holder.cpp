#include "link/port_holder.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace tp100::link {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& process, const std::string& real_path) {
  std::error_code error;
  for (fs::directory_iterator fd(process / "fd", error), end; !error && fd != end;
       fd.increment(error)) {
    std::error_code unreadable;
    if (fs::read_symlink(fd->path(), unreadable) == real_path) return true;
  }
  return false;
}

}  // namespace

std::string port_holder(const std::string& real_path, const fs::path& proc) {
  std::error_code error;
  for (fs::directory_iterator process(proc, error), end; !error && process != end;
       process.increment(error)) {
    const std::string pid = process->path().filename();
    if (!std::all_of(pid.begin(), pid.end(), [](char c) { return c >= '0' && c <= '9'; })) continue;
    if (pid == std::to_string(::getpid()) || !holds(process->path(), real_path)) continue;
    std::string name;
    std::getline(std::ifstream(process->path() / "comm"), name);
    return (name.empty() ? "a program" : name) + " (pid " + pid + ")";
  }
  return {};
}

}  // namespace tp100::link
