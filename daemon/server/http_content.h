#pragma once
// Answers an HTTP request, from method and target: the page, the list of runs and their files. No
// socket.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/descriptor.h"
#include "runs/run_folder.h"
#include "runs/run_zip.h"
#include "web/bundle.h"

namespace tp100::server {

struct HttpRequest {
  std::string method;  ///< "GET", ...
  std::string target;
  std::string range;       ///< header Range, empty: none
  std::string none_match;  ///< header If-None-Match
  std::string host{};      ///< header Host
  bool gzip = false;       ///< the client takes content that gzip has compressed
};

struct HttpAnswer {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;                        ///< the body, unless one of the next three has it
  std::span<const unsigned char> bytes{};  ///< of a file of the page
  Descriptor file{};                       ///< a part of a file on the disk
  std::unique_ptr<runs::RunZip> zip{};     ///< an archive, made while it is sent
  std::uint64_t offset = 0;                ///< of the part in the file
  std::uint64_t length = 0;                ///< of the body, wherever it is

  /// Whether read() has the body.
  bool on_disk() const { return file || zip; }
  /// Reads the next bytes of a body on the disk, waiting for it, and returns how many; 0: call it
  /// again. Nothing: the body cannot be completed.
  std::optional<std::size_t> read(std::span<char> into);
};

/// Sources of the content; an empty one has none. `runs` and `setup` may wait for the disk, and are
/// called in another thread than the server's.
struct HttpSources {
  /// The page's file for the `path` that a browser requests, or null.
  std::function<const web::File*(std::string_view path)> page;
  std::string runs_folder;
  std::function<std::string()> runs;  ///< the list of runs, JSON
  /// The content of /api/setup, /courses/NAME.toml and /robots/NAME.toml, or nothing.
  std::function<std::optional<std::string>(std::string_view path)> setup;
  std::function<std::string()> health;  ///< JSON; never empty
  /// JSON, for a page that is called by this Host.
  std::function<std::string(std::string_view host)> robots;
  /// A JSON array by the topic without its slash, of the last seconds, or nothing.
  std::function<std::optional<std::string>(std::string_view topic, double span_s)> history;
};

/// Whether the answer to `target` is read from the disk, so that http_answer() may block.
bool needs_disk(std::string_view target);
HttpAnswer http_answer(const HttpRequest& request, const HttpSources& sources);
HttpAnswer http_text(unsigned status, std::string text);

}  // namespace tp100::server
