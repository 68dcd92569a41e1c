#pragma once
// What an HTTP request gets: from method and target to an answer. No socket.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/run_files.h"

namespace tp100::server {

/// One file of the page; lasts as long as the program.
struct PageFile {
  std::string_view mime;
  std::span<const unsigned char> bytes;
  std::string_view etag;      ///< quotes included
  std::string_view encoding;  ///< for Content-Encoding; empty: bytes as they are
};
/// The file that a browser asks for by `path`, or nothing.
using Page = std::function<std::optional<PageFile>(std::string_view path)>;

/// An open file that closes itself.
class OpenFile {
 public:
  explicit OpenFile(int fd = -1) : fd_(fd) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }

 private:
  int fd_;
};

struct HttpRequest {
  std::string_view method;  ///< "GET", ...
  std::string_view target;
  std::string_view range;       ///< header Range, empty: none
  std::string_view none_match;  ///< header If-None-Match
};

struct HttpAnswer {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;                        ///< or
  std::span<const unsigned char> bytes{};  ///< or
  OpenFile file{};
  std::uint64_t offset = 0;  ///< of the file's part
  std::uint64_t length = 0;  ///< of the body, whichever it is
};

/// What the content is made of.
struct HttpSources {
  Page page;
  std::string runs_folder;  ///< empty: none
  std::shared_ptr<RunList> runs = std::make_shared<RunList>();
  std::function<std::string()> active_run;  ///< the run that is being recorded; "": none
  std::function<std::string()> health;      ///< JSON
};

/// Whether the answer to `target` comes from the disk: then http_answer() may wait for that.
bool needs_disk(std::string_view target);
HttpAnswer http_answer(const HttpRequest& request, const HttpSources& sources);
/// An answer of plain text.
HttpAnswer http_text(unsigned status, std::string text);

/// The part of a file of `size` bytes that a Range header asks for: first byte and length; nothing
/// if there is no header that can be served as one range, or it lies outside (`outside`).
std::optional<std::pair<std::uint64_t, std::uint64_t>> byte_range(std::string_view header,
                                                                  std::uint64_t size,
                                                                  bool& outside);

}  // namespace tp100::server
