#pragma once
// The daemons that serve a page on this machine, found without configuration and without files:
// each binds an abstract Unix socket whose name holds address, port and session. The kernel drops
// the name with the process, however that ends, and shows it in one network namespace only: where
// 127.0.0.1 is the same machine.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/descriptor.h"

namespace tp100::server {

/// What a daemon announces. Every account of the machine can announce anything: it is a hint where
/// to look and does not prove who answers there.
struct LocalDaemon {
  std::string address{};   ///< where it listens: an IPv4 or IPv6 address
  std::uint16_t port = 0;  ///< not 0
  std::string session{};   ///< its sessionId: lower-case hexadecimal digits, at most 32
  bool operator==(const LocalDaemon&) const = default;
};

/// Makes a daemon known for as long as the descriptor lives. If the kernel refuses, nothing is
/// announced; then only other pages do not list this daemon.
Descriptor announce(const LocalDaemon& daemon);

/// The daemons in a table of Unix sockets like /proc/net/unix: the first 64, by port. Whatever is
/// not announced in exactly this form is skipped. Pure.
std::vector<LocalDaemon> daemons_in(std::string_view table);

/// The daemons that run now. Reads a table of the kernel and no disk.
std::vector<LocalDaemon> local_daemons();

/// Splits the text of `server.robots` into addresses of pages, each with a '/' at the end. Throws
/// UserError for one that is not http://HOST or https://HOST, with or without a port.
std::vector<std::string> robot_pages(std::string_view text);

/// The answer to GET /api/robots for a page whose Host is `host`: `own`, the other `found` ones
/// that are reached by the same name or by an address of their own, and the `named` pages.
std::string robots_json(const LocalDaemon& own, const std::vector<LocalDaemon>& found,
                        const std::vector<std::string>& named, std::string_view host);

/// Whether `origin` is the page of one of `daemons`, reached by the same name as this daemon, which
/// the browser calls `host`.
bool is_page_of(const std::vector<LocalDaemon>& daemons, std::string_view origin,
                std::string_view host);

}  // namespace tp100::server
