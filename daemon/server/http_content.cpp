#include "server/http_content.h"

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"
#include "server/gzip.h"
#include "text/file_name.h"
#include "text/format.h"

namespace tp100::server {
namespace {

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
constexpr std::string_view kZip = ".zip";
constexpr std::size_t kMaxZipName = 255;
constexpr std::string_view kHistory = "/api/history/";
constexpr std::string_view kSetupList = "/api/setup";
constexpr std::string_view kRobots = "/api/robots";

bool is_setup(std::string_view path) {
  return path == kSetupList || path.starts_with("/courses/") || path.starts_with("/robots/");
}

/// Nothing: not an address.
std::optional<std::string> path_of(std::string_view target) {
  return text::percent_decoded(target.substr(0, target.find_first_of("?#")));
}

constexpr std::size_t kWorthGzip = 4096;

HttpAnswer json_answer(std::string json, bool gzip = false) {
  gzip = gzip && json.size() >= kWorthGzip;
  HttpAnswer answer = http_text(200, gzip ? gzipped(json) : std::move(json));
  if (gzip) answer.headers.emplace_back("Content-Encoding", "gzip");
  answer.type = "application/json";
  answer.headers.emplace_back("Cache-Control", "no-store");
  return answer;
}

HttpAnswer page_answer(const web::File& file, const HttpRequest& request) {
  HttpAnswer answer;
  answer.type = file.mime;
  answer.headers.emplace_back("ETag", file.etag);
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.headers.emplace_back("Content-Security-Policy", kPagePolicy);
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  if (request.none_match == file.etag) {
    answer.status = 304;
    return answer;
  }
  answer.bytes = request.gzip ? file.gzip : file.bytes;
  if (request.gzip) answer.headers.emplace_back("Content-Encoding", "gzip");
  answer.length = answer.bytes.size();
  return answer;
}

/// Of `?span_s=60`; everything without it.
double span_s(const HttpRequest& request) {
  constexpr std::string_view kName = "?span_s=";
  const std::size_t at = request.target.find(kName);
  if (at == std::string::npos) return std::numeric_limits<double>::infinity();
  return text::number_in<unsigned>(std::string_view(request.target).substr(at + kName.size()))
      .value_or(0);
}

HttpAnswer zip_answer(const std::string& folder, std::string_view run) {
  try {
    HttpAnswer answer;
    answer.zip = std::make_unique<runs::RunZip>(folder, std::string(run));
    answer.length = answer.zip->size();
    answer.type = "application/zip";
    answer.headers.emplace_back("Cache-Control", "no-store");
    // RFC 6266: the first name is for programs that do not know the second form.
    answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" +
                                                           text::file_name_of(run, kMaxZipName) +
                                                           ".zip\"; filename*=UTF-8''" +
                                                           text::percent_encoded(run) + ".zip");
    return answer;
  } catch (const UserError& error) {
    return http_text(404, error.what());
  }
}

/// The part of a file of `size` bytes that a Range header requests.
struct ByteRange {
  std::uint64_t first = 0;
  std::uint64_t length = 0;  ///< 0: it lies outside of the file
};

/// Nothing: there is no header that can be served as one range.
std::optional<ByteRange> byte_range(std::string_view header, std::uint64_t size) {
  static constexpr std::string_view kUnit = "bytes=";
  if (!header.starts_with(kUnit)) return std::nullopt;
  header.remove_prefix(kUnit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos)
    return std::nullopt;
  const auto first = text::number_in<std::uint64_t>(header.substr(0, dash)),
             last = text::number_in<std::uint64_t>(header.substr(dash + 1));
  if (dash == 0) {  // the last bytes
    if (!last) return std::nullopt;
    const std::uint64_t length = std::min(*last, size);
    return ByteRange{size - length, length};
  }
  if (!first || (!last && dash + 1 != header.size()) || (last && *last < *first))
    return std::nullopt;
  if (*first >= size) return ByteRange{};
  const std::uint64_t most = size - *first;
  return ByteRange{*first, last && *last - *first < most ? *last - *first + 1 : most};
}

HttpAnswer file_answer(const HttpRequest& request, std::string_view path,
                       const HttpSources& sources) {
  const std::size_t slash = path.find('/');
  if (slash == std::string_view::npos)
    return path.ends_with(kZip)
               ? zip_answer(sources.runs_folder, path.substr(0, path.size() - kZip.size()))
               : http_text(404, "no such file");
  const std::string_view name = path.substr(slash + 1);
  std::uint64_t size = 0;
  Descriptor file = runs::open_run_file(sources.runs_folder, std::string(path.substr(0, slash)),
                                        std::string(name), size);
  if (!file) return http_text(404, "no such file");
  HttpAnswer answer;
  answer.type = runs::kind_of(name).media_type;
  answer.headers.emplace_back("Accept-Ranges", "bytes");
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.headers.emplace_back("Content-Security-Policy", kReportPolicy);
  answer.length = size;
  if (const auto part = byte_range(request.range, size)) {
    if (part->length == 0) {
      HttpAnswer refusal = http_text(416, "the range lies outside the file");
      refusal.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
      return refusal;
    }
    answer.status = 206;
    answer.offset = part->first;
    answer.length = part->length;
    answer.headers.emplace_back("Content-Range",
                                "bytes " + std::to_string(part->first) + "-" +
                                    std::to_string(part->first + part->length - 1) + "/" +
                                    std::to_string(size));
  }
  answer.file = std::move(file);
  return answer;
}

}  // namespace

std::optional<std::size_t> HttpAnswer::read(std::span<char> into) {
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(length, into.size()));
  std::optional<std::size_t> got;
  if (zip) {
    got = zip->read(into);
  } else if (const ssize_t n = ::pread(file.get(), into.data(), wanted, static_cast<off_t>(offset));
             n > 0) {
    got = static_cast<std::size_t>(n);
  }
  offset += got.value_or(0);
  length -= got.value_or(0);
  return got;
}

HttpAnswer http_text(unsigned status, std::string text) {
  HttpAnswer answer;
  answer.status = status;
  answer.body = std::move(text);
  answer.length = answer.body.size();
  return answer;
}

bool needs_disk(std::string_view target) {
  const std::string path = path_of(target).value_or("");
  return path == kRunList || path.starts_with(kRuns) || is_setup(path);
}

HttpAnswer http_answer(const HttpRequest& request, const HttpSources& sources) {
  if (request.method != "GET" && request.method != "HEAD") {
    HttpAnswer answer = http_text(405, "only GET and HEAD are served");
    answer.headers.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  const std::optional<std::string> decoded = path_of(request.target);
  if (!decoded) return http_text(404, "a % without two hexadecimal digits in the address");
  const std::string_view path = *decoded;
  if (path == "/healthz") return json_answer(sources.health());
  if (path.starts_with(kHistory)) {
    std::optional<std::string> content;
    if (sources.history) content = sources.history(path.substr(kHistory.size()), span_s(request));
    return content ? json_answer(std::move(*content), request.gzip)
                   : http_text(404, "no history of that topic");
  }
  if (path == kRobots)
    return sources.robots ? json_answer(sources.robots(request.host))
                          : http_text(404, "no page is served");
  if (path == kRunList)
    return sources.runs ? json_answer(sources.runs(), request.gzip)
                        : http_text(404, "nothing is recorded");
  if (path.starts_with(kRuns)) return file_answer(request, path.substr(kRuns.size()), sources);
  if (is_setup(path)) {
    std::optional<std::string> content;
    if (sources.setup) content = sources.setup(path);
    if (!content) return http_text(404, "no such file");
    return path == kSetupList ? json_answer(std::move(*content), request.gzip)
                              : http_text(200, std::move(*content));
  }
  if (const web::File* file = sources.page ? sources.page(path) : nullptr)
    return page_answer(*file, request);
  return http_text(404, "nothing is served at this address");
}

}  // namespace tp100::server
