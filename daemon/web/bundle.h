#pragma once
// The cockpit page, as built by scripts/web and embedded at build time; no file is read at run
// time.

#include <span>
#include <string_view>

namespace tp100::web {

/// One file of the page. Everything in it lasts as long as the program.
struct File {
  std::string_view path;  ///< as a browser asks for it: "/cockpit.js"; "/index.html" answers "/"
  std::string_view mime;  ///< for Content-Type
  std::string_view etag;  ///< for ETag, quotes included; changes with the content
  std::span<const unsigned char> bytes;   ///< the body
  std::span<const unsigned char> gzip{};  ///< ... as gzip compresses it
};

/// Every file, ascending by path. The same in every call; any thread.
std::span<const File> bundle();

/// The file at `path` ("/" is the page itself), or null.
const File* find(std::string_view path);

}  // namespace tp100::web
