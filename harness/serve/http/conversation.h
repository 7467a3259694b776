// One client's connection: its requests one after the other, each answered before the next is read.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <optional>
#include <string>

#include "harness/serve/server.h"
#include "harness/serve/site.h"

namespace harness::serve {

struct Connection {
    boost::beast::tcp_stream stream;
    std::string client;                ///< its address
    boost::beast::flat_buffer buffer;  ///< read and not yet parsed: of pipelined requests the next ones
    /// Since when no request is under way; empty while one is.
    std::optional<std::chrono::steady_clock::time_point> idle_since{};
};

/// What all connections share.
struct Common {
    Site& site;
    const ServerLimits& limits;
    std::size_t body_bytes = 0;  ///< held for all of them
    bool is_closing = false;     ///< the next answer of each is its last
};

/// Ends when the client is done, breaks a limit or is gone; the connection is closed then.
boost::asio::awaitable<void> converse(Connection& connection, Common& common);

}  // namespace harness::serve
