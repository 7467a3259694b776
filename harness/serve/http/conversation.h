// Serves one client's connection: reads a request, answers it, then reads the next.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <list>

#include "harness/serve/http/server_limits.h"
#include "harness/serve/request/service.h"

namespace harness::serve {

struct Connection {
    using Clock = std::chrono::steady_clock;

    boost::beast::tcp_stream stream;
    boost::beast::flat_buffer buffer;  ///< read but not yet parsed, e.g. pipelined requests
    bool is_idle = true;               ///< no request is under way
    Clock::time_point idle_since = Clock::now();
};

/// What all connections share.
struct Common {
    Service& service;
    const ServerLimits& limits;
    std::list<Connection> connections{};
    bool is_closing = false;  ///< each connection's next answer is its last
};

/// Serves the connection until the client is done, breaks a limit or is gone, and then closes it.
boost::asio::awaitable<void> converse(Connection& connection, Common& common);

}  // namespace harness::serve
