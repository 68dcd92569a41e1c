#include "server/local_daemons.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>

#include "core/error.h"
#include "server/access.h"
#include "text/format.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr std::string_view kMark = "tp100d/";
constexpr std::size_t kMaxDaemons = 64;
constexpr std::size_t kMaxSession = 32;
constexpr std::size_t kMaxTable = 4 << 20;
constexpr std::size_t kMaxPage = 200;
constexpr std::string_view kHostLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:[]";

/// 0: not a port.
std::uint16_t port_in(std::string_view text) {
  return text.starts_with('0') ? 0 : text::number_in<std::uint16_t>(text).value_or(0);
}

bool is_session(std::string_view text) {
  return !text.empty() && text.size() <= kMaxSession &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// ADDRESS/PORT/SESSION.
std::optional<LocalDaemon> announced(std::string_view name) {
  const std::size_t first = name.find('/'), second = name.find('/', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
  LocalDaemon daemon{std::string(name.substr(0, first)),
                     port_in(name.substr(first + 1, second - first - 1)),
                     std::string(name.substr(second + 1))};
  const bool valid = is_address(daemon.address) && daemon.port != 0 && is_session(daemon.session);
  return valid ? std::optional(std::move(daemon)) : std::nullopt;
}

bool is_loopback(std::string_view name) {
  return name == "localhost" || name == "::1" || name.starts_with("127.");
}

/// How a page that is called `name` reaches a daemon; empty: it cannot.
std::string url_of(const LocalDaemon& daemon, std::string_view name) {
  std::string host = daemon.address;
  const bool any = host == "0.0.0.0" || host == "::";
  if (is_loopback(host) && !is_loopback(name)) return {};
  // The page's own name, so that the daemon accepts its Origin.
  if (any || is_loopback(host)) host = name;
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  return "http://" + host + ":" + std::to_string(daemon.port) + "/";
}

}  // namespace

Descriptor announce(const LocalDaemon& daemon) {
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const std::string name = std::string(kMark) + daemon.address + "/" + std::to_string(daemon.port) +
                           "/" + daemon.session;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // Abstract: the first byte of the name stays 0.
  if (!socket || name.size() >= sizeof address.sun_path) return socket;
  std::memcpy(address.sun_path + 1, name.data(), name.size());
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  // It never listens: nobody can connect or send anything.
  ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), size);
  return socket;
}

std::vector<LocalDaemon> daemons_in(std::string_view table) {
  std::vector<LocalDaemon> found;
  while (!table.empty() && found.size() < kMaxDaemons) {
    const std::string_view line = table.substr(0, table.find('\n'));
    table.remove_prefix(std::min(line.size() + 1, table.size()));
    // The name is the last column, and abstract ones begin with '@'.
    const std::string mark = " @" + std::string(kMark);
    const std::size_t at = line.find(mark);
    if (at == std::string_view::npos) continue;
    if (auto daemon = announced(line.substr(at + mark.size()))) found.push_back(std::move(*daemon));
  }
  std::ranges::stable_sort(found, {}, &LocalDaemon::port);
  return found;
}

std::vector<LocalDaemon> local_daemons() {
  std::string table;
  const Descriptor file(::open("/proc/net/unix", O_RDONLY | O_CLOEXEC));
  if (!file) return {};
  char part[16'384];
  while (table.size() < kMaxTable) {
    const ssize_t got = ::read(file.get(), part, sizeof part);
    if (got <= 0) break;
    table.append(part, static_cast<std::size_t>(got));
  }
  return daemons_in(table);
}

std::vector<std::string> robot_pages(std::string_view text) {
  std::vector<std::string> pages = words(text);
  for (std::string& page : pages) {
    std::string_view host = page;
    for (const std::string_view scheme : {"http://", "https://"})
      if (page.starts_with(scheme)) host.remove_prefix(scheme.size());
    const bool scheme = host.size() < page.size();
    if (host.ends_with('/')) host.remove_suffix(1);
    if (!scheme || host_name(host).empty() || page.size() > kMaxPage ||
        host.find_first_not_of(kHostLetters) != std::string_view::npos)
      throw UserError("server.robots: " + one_line(page) +
                      ": not the address of a page; write http://HOST:PORT");
    if (!page.ends_with('/')) page += '/';
  }
  return pages;
}

std::string robots_json(const LocalDaemon& own, const std::vector<LocalDaemon>& found,
                        const std::vector<std::string>& named, std::string_view host) {
  const std::string name = host_name(host);
  std::string text;
  text::JsonWriter json(text);
  json.begin_object().key("robots").begin_array();
  json.begin_object()
      .field("url", "http://" + std::string(host) + "/")
      .field("session", own.session)
      .field("own", true)
      .end_object();
  for (const LocalDaemon& daemon : found) {
    const std::string url = url_of(daemon, name);
    if (daemon.session == own.session || url.empty()) continue;
    json.begin_object().field("url", url).field("session", daemon.session).end_object();
  }
  for (const std::string& page : named) json.begin_object().field("url", page).end_object();
  json.end_array().end_object();
  return text;
}

bool is_page_of(const std::vector<LocalDaemon>& daemons, std::string_view origin,
                std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  if (!origin.starts_with(kScheme)) return false;
  origin.remove_prefix(kScheme.size());
  const std::string name = host_name(origin);
  if (name.empty() || name != host_name(host)) return false;
  const std::size_t colon = origin.rfind(':');
  const bool port_given = colon != std::string_view::npos && !origin.ends_with(']');
  const std::uint16_t port = port_given ? port_in(origin.substr(colon + 1)) : 80;
  return std::ranges::any_of(daemons, [&](const LocalDaemon& each) { return each.port == port; });
}

}  // namespace tp100::server
