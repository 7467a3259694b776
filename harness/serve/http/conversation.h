// Serves one client's connection: reads a request, answers it, then reads the next.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <optional>
#include <string>

#include "harness/serve/http/server.h"
#include "harness/serve/site/site.h"

namespace harness::serve {

struct Connection {
    boost::beast::tcp_stream stream;
    std::string client;                ///< its address
    boost::beast::flat_buffer buffer;  ///< read but not yet parsed, e.g. pipelined requests
    /// When the connection became idle; empty while a request is under way.
    std::optional<std::chrono::steady_clock::time_point> idle_since{};
};

/// What all connections share.
struct Common {
    Site& site;
    const ServerLimits& limits;
    std::size_t body_bytes = 0;  ///< held by all connections together
    bool is_closing = false;     ///< each connection's next answer is its last
};

/// Serves the connection until the client is done, breaks a limit or is gone, and then closes it.
boost::asio::awaitable<void> converse(Connection& connection, Common& common);

}  // namespace harness::serve
