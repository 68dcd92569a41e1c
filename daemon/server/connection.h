#pragma once
// One accepted TCP connection, in the sockets' thread: HTTP requests, which others answer, until it
// becomes a viewer or ends.

#include <boost/asio/ip/tcp.hpp>

#include "server/shared_state.h"

namespace tp100::server {

/// Serves `socket` until it ends.
void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared);

}  // namespace tp100::server
