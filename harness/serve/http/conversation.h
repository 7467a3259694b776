// Serves one client's connection: reads a request, answers it, then reads the next.
#pragma once

#include <boost/asio/awaitable.hpp>

#include "harness/serve/http/connections.h"
#include "harness/serve/http/server_limits.h"
#include "harness/serve/request/service.h"

namespace harness::serve {

/// What all connections share.
struct Common {
    Service& service;
    const ServerLimits& limits;
    Connections connections;
    bool is_closing = false;  ///< each connection's next answer is its last
};

/// Serves the connection until the client is done, breaks a limit or is gone, and then closes it.
boost::asio::awaitable<void> converse(Connection& connection, Common& common);

}  // namespace harness::serve
