#include "server/http_content.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <utility>
#include <vector>

#include "text/atomic_file.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileName = 128;
constexpr std::size_t kMaxFiles = 100;  // per run
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

bool is_name(std::string_view name) { return text::is_file_name(name, kMaxFileName); }

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

// Only the page's own files and server; no framing.
constexpr std::string_view kPagePolicy =
    "default-src 'self'; connect-src 'self' ws: wss:; img-src 'self' data: blob:; style-src 'self' "
    "'unsafe-inline'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";
// A report contains its script and must not reach the server.
constexpr std::string_view kReportPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:; font-src data:; sandbox allow-scripts allow-downloads";

constexpr std::string_view kRunList = "/api/runs";
constexpr std::string_view kRuns = "/runs/";
constexpr std::string_view kHistory = "/api/history/";
constexpr std::string_view kSetupList = "/api/setup";

bool is_setup(std::string_view path) {
  return path == kSetupList || path.starts_with("/courses/") || path.starts_with("/robots/");
}

std::string_view path_of(std::string_view target) {
  return target.substr(0, target.find_first_of("?#"));
}

HttpAnswer fresh_answer(std::string text, std::string type) {
  HttpAnswer answer = http_text(200, std::move(text));
  answer.type = std::move(type);
  answer.headers.emplace_back("Cache-Control", "no-store");
  return answer;
}

HttpAnswer json_answer(std::string json) {
  return fresh_answer(std::move(json), "application/json");
}

HttpAnswer page_answer(const PageFile& file, std::string_view none_match) {
  HttpAnswer answer;
  answer.type = file.mime;
  answer.headers.emplace_back("ETag", file.etag);
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.headers.emplace_back("Content-Security-Policy", kPagePolicy);
  if (none_match == file.etag) {
    answer.status = 304;
    return answer;
  }
  if (!file.encoding.empty()) answer.headers.emplace_back("Content-Encoding", file.encoding);
  answer.bytes = file.bytes;
  answer.length = file.bytes.size();
  return answer;
}

HttpAnswer file_answer(const HttpRequest& request, std::string_view path,
                       const HttpSources& sources) {
  const std::size_t slash = path.find('/');
  if (slash == std::string_view::npos) return http_text(404, "no such file");
  const std::string_view name = path.substr(slash + 1);
  std::uint64_t size = 0;
  OpenFile file(open_run_file(sources.runs_folder, path.substr(0, slash), name, size));
  if (!file) return http_text(404, "no such file");
  HttpAnswer answer;
  answer.type = content_type(name);
  answer.headers.emplace_back("Accept-Ranges", "bytes");
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.headers.emplace_back("Content-Security-Policy", kReportPolicy);
  answer.length = size;
  bool outside = false;
  const auto part = byte_range(request.range, size, outside);
  if (outside) {
    HttpAnswer refusal = http_text(416, "the range lies outside the file");
    refusal.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
    return refusal;
  }
  if (part) {
    answer.status = 206;
    answer.offset = part->first;
    answer.length = part->second;
    answer.headers.emplace_back("Content-Range",
                                "bytes " + std::to_string(part->first) + "-" +
                                    std::to_string(part->first + part->second - 1) + "/" +
                                    std::to_string(size));
  }
  answer.file = std::move(file);
  return answer;
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

const std::string& RunList::json(const std::string& folder, const std::string& active) {
  // The time after reading, so that a slow disk is not read continuously.
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
  // Opening a pipe must not block.
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

OpenFile::~OpenFile() {
  if (fd_ >= 0) ::close(fd_);
}

HttpAnswer http_text(unsigned status, std::string text) {
  HttpAnswer answer;
  answer.status = status;
  answer.body = std::move(text);
  answer.length = answer.body.size();
  return answer;
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> byte_range(std::string_view header,
                                                                  std::uint64_t size,
                                                                  bool& outside) {
  outside = false;
  static constexpr std::string_view kUnit = "bytes=";
  if (!header.starts_with(kUnit)) return std::nullopt;
  header.remove_prefix(kUnit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos)
    return std::nullopt;
  const auto first = number(header.substr(0, dash)), last = number(header.substr(dash + 1));
  if (dash == 0) {  // the last bytes
    if (!last) return std::nullopt;
    outside = *last == 0 || size == 0;
    const std::uint64_t length = std::min(*last, size);
    return outside ? std::nullopt : std::optional(std::pair(size - length, length));
  }
  if (!first || (!last && dash + 1 != header.size())) return std::nullopt;
  if (last && *last < *first) return std::nullopt;
  outside = *first >= size;
  if (outside) return std::nullopt;
  const std::uint64_t end = last ? std::min(*last, size - 1) : size - 1;
  return std::pair(*first, end - *first + 1);
}

bool needs_disk(std::string_view target) {
  const std::string_view path = path_of(target);
  return path == kRunList || path.starts_with(kRuns) || is_setup(path);
}

HttpAnswer http_answer(const HttpRequest& request, const HttpSources& sources) {
  if (request.method != "GET" && request.method != "HEAD") {
    HttpAnswer answer = http_text(405, "only GET and HEAD are served");
    answer.headers.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  const std::string_view path = path_of(request.target);
  if (path == "/healthz") return json_answer(sources.health());
  if (path == "/metrics")
    return fresh_answer(sources.metrics(), "text/plain; version=0.0.4; charset=utf-8");
  if (path.starts_with(kHistory)) {
    std::optional<std::string> content;
    if (sources.history) content = sources.history(path.substr(kHistory.size()));
    return content ? json_answer(std::move(*content)) : http_text(404, "no history of that topic");
  }
  if (path == kRunList)
    return json_answer(sources.runs->json(sources.runs_folder, sources.active_run()));
  if (path.starts_with(kRuns)) return file_answer(request, path.substr(kRuns.size()), sources);
  if (is_setup(path)) {
    std::optional<std::string> content;
    if (sources.setup) content = sources.setup(path);
    if (!content) return http_text(404, "no such file");
    return path == kSetupList ? json_answer(std::move(*content))
                              : http_text(200, std::move(*content));
  }
  if (const auto file = sources.page ? sources.page(path) : std::nullopt)
    return page_answer(*file, request.none_match);
  return http_text(404, "nothing is served at this address");
}

}  // namespace tp100::server
