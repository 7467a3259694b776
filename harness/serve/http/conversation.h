// Serves one client's connection: reads a request, answers it and closes the connection.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>

#include "harness/serve/http/server_limits.h"
#include "harness/serve/request/service.h"

namespace harness::serve {

struct Connection {
    boost::beast::tcp_stream stream;
    boost::beast::flat_buffer buffer;  ///< read but not yet parsed
};

/// Answers one request, unless the client breaks a limit or is gone, and then closes the connection. With one request
/// per connection, later bytes are never read as a request, no matter where a proxy sees the request's end.
boost::asio::awaitable<void> converse(Connection& connection, Service& service, const ServerLimits& limits);

}  // namespace harness::serve
