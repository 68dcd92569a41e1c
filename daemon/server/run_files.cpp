#include "server/run_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "text/json_writer.h"

namespace tp100::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxName = 128;
constexpr std::size_t kMaxFiles = 100;  // of one run
constexpr std::size_t kMaxEntries = 20'000;
constexpr auto kFresh = std::chrono::seconds(1);

struct Ending {
  std::string_view end, kind, type;
};
constexpr std::array<Ending, 7> kEndings = {{
    {".mcap", "recording", "application/octet-stream"},
    {".html", "report", "text/html; charset=utf-8"},
    {".json", "metrics", "application/json"},
    {".csv", "table", "text/csv; charset=utf-8"},
    {".tum", "trajectory", "text/plain; charset=utf-8"},
    {".svg", "figure", "image/svg+xml"},
    {".toml", "other", "text/plain; charset=utf-8"},
}};

const Ending* ending_of(std::string_view file) {
  for (const Ending& each : kEndings)
    if (file.ends_with(each.end)) return &each;
  return nullptr;
}

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= kMaxName && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

struct File {
  std::string name;
  std::uint64_t bytes;
};
struct Run {
  std::string name;
  double modified_s = 0.0;
  std::uint64_t bytes = 0;
  std::vector<File> files;
};

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// False: not a folder of its own.
bool look_at(const fs::path& folder, Run& run) {
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return false;
  run.modified_s = seconds(status.st_mtim);
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!is_name(name) || ::lstat(at->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode))
      continue;
    run.files.push_back({name, static_cast<std::uint64_t>(status.st_size)});
    run.bytes += run.files.back().bytes;
    run.modified_s = std::max(run.modified_s, seconds(status.st_mtim));
    if (run.files.size() == kMaxFiles) break;
  }
  std::sort(run.files.begin(), run.files.end(),
            [](const File& a, const File& b) { return a.name < b.name; });
  return true;
}

std::vector<Run> list(const std::string& folder) {
  std::vector<Run> runs;
  std::error_code error;
  std::size_t seen = 0;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (++seen > kMaxEntries) break;
    Run run;
    run.name = at->path().filename().string();
    if (is_name(run.name) && look_at(at->path(), run)) runs.push_back(std::move(run));
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::pair(a.modified_s, a.name) > std::pair(b.modified_s, b.name);
  });
  if (runs.size() > kMaxListedRuns) runs.resize(kMaxListedRuns);
  return runs;
}

std::string runs_json(const std::string& folder, std::string_view active) {
  std::string text;
  text::JsonWriter json(text);
  const std::string name = fs::path(folder + "/").parent_path().filename();
  json.begin_object().field("directory", name).key("runs").begin_array();
  for (const Run& run : folder.empty() ? std::vector<Run>() : list(folder)) {
    json.begin_object()
        .field("run", run.name)
        .field("modified_unix_s", run.modified_s)
        .field("bytes", run.bytes)
        .field("active", !active.empty() && run.name == active)
        .key("files")
        .begin_array();
    for (const File& file : run.files) {
      const Ending* ending = ending_of(file.name);
      json.begin_object()
          .field("name", file.name)
          .field("bytes", file.bytes)
          .field("url", "/runs/" + run.name + "/" + file.name)
          .field("kind", ending == nullptr ? "other" : ending->kind)
          .end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().end_object();
  return text;
}

}  // namespace

const std::string& RunList::json(const std::string& folder, const std::string& active) {
  // The time after reading: a slow disk is not read all the time.
  const auto now = std::chrono::steady_clock::now();
  if (!json_.empty() && folder == folder_ && active == active_ && now - read_ < kFresh)
    return json_;
  json_ = runs_json(folder, active);
  folder_ = folder;
  active_ = active;
  read_ = std::chrono::steady_clock::now();
  return json_;
}

int open_run_file(const std::string& folder, std::string_view run, std::string_view file,
                  std::uint64_t& size) {
  if (folder.empty() || !is_name(run) || !is_name(file)) return -1;
  const int root = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (root < 0) return -1;
  const int inside =
      ::openat(root, std::string(run).c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  ::close(root);
  if (inside < 0) return -1;
  // A pipe must not hold up the opening.
  int fd =
      ::openat(inside, std::string(file).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  ::close(inside);
  struct stat status {};
  if (fd >= 0 && (::fstat(fd, &status) != 0 || !S_ISREG(status.st_mode))) {
    ::close(fd);
    fd = -1;
  }
  if (fd >= 0) size = static_cast<std::uint64_t>(status.st_size);
  return fd;
}

std::string_view content_type(std::string_view file) {
  const Ending* ending = ending_of(file);
  return ending == nullptr ? "application/octet-stream" : ending->type;
}

}  // namespace tp100::server
