// The connections of a server, and which of them makes room when there are too many or their bodies are too large.
//
// What is scarce goes to all clients in equal shares: the client that holds most gives up what has been silent the
// longest. While nobody else needs the room, one client may hold more than its share, as a lab behind one address does.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <cstddef>
#include <list>
#include <map>
#include <string>

#include "harness/serve/http/server_limits.h"

namespace harness::serve {

struct Connection {
    using Clock = std::chrono::steady_clock;

    boost::beast::tcp_stream stream;
    std::string client;                             ///< see client_of
    boost::beast::flat_buffer buffer;               ///< read but not yet parsed, e.g. pipelined requests
    Clock::time_point silent_since = Clock::now();  ///< since the last byte of a body or an answer, or the last answer
    bool is_idle = true;                            ///< no request is under way
    std::size_t body_bytes = 0;                     ///< of the request under way
    bool is_displaced = false;                      ///< it was closed, because others need its room
    bool is_refused_body = false;                   ///< the reading of its body was cancelled, because others need room
};

/// Use it from one thread only.
class Connections {
  public:
    using Iterator = std::list<Connection>::iterator;

    /// Behind a proxy all connections come from one address, so the limit for one address is ignored.
    Connections(const ServerLimits& limits, bool behind_proxy) : limits_(limits), behind_proxy_(behind_proxy) {}

    /// Whether there is room for one more connection of the client; another connection may be closed for it.
    bool make_room_for(const std::string& client);
    Iterator add(boost::asio::ip::tcp::socket socket, const std::string& client);
    void remove(Iterator connection);

    /// Says how much of its body a connection holds, or has given up. Where all bodies become too large, the reading of
    /// others may be cancelled. False if this one itself must give up its body.
    bool hold_body(Connection& connection, std::size_t bytes);

    bool empty() const { return all_.empty(); }
    Iterator begin() { return all_.begin(); }
    Iterator end() { return all_.end(); }

  private:
    std::size_t count_of(const std::string& client) const;
    Connection* longest_silent(const std::string* client);
    const std::string& largest_client() const;

    const ServerLimits& limits_;
    const bool behind_proxy_;
    std::list<Connection> all_;
    std::map<std::string, std::size_t> counts_;  ///< how many connections each client has that are not displaced
    std::size_t body_bytes_ = 0;                 ///< of all connections together
};

}  // namespace harness::serve
