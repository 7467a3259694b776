// Theory of operation. One thread, one io_context; each connection is a coroutine (conversation.h). The number of
// connections and the limits of each bound the memory.
#include "harness/serve/http/server.h"

#include <fmt/format.h>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <list>

#include "harness/machine/say.h"
#include "harness/serve/http/conversation.h"

namespace harness::serve {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto as_awaitable_accept = asio::as_tuple(asio::use_awaitable);

constexpr std::string_view busy =
    "HTTP/1.1 503 Service Unavailable\r\nContent-Type: text/plain\r\nCache-Control: no-store\r\nRetry-After: 5\r\n"
    "Connection: close\r\n\r\nThere are too many connections right now. Please try again in a moment.\n";

void listen(tcp::acceptor& acceptor, const std::string& address, std::uint16_t port) {
    error_code error;
    const auto parsed = asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, error);
    if (error)
        throw ListenError(fmt::format("{} is not an IP address; give --host an IP address of this machine", address));
    const tcp::endpoint endpoint(parsed, port);
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error == asio::error::address_in_use) {
        throw ListenError(fmt::format(
            "port {} is in use; choose a different one with --port, or let raygrade find a free one with --port 0",
            port));
    }
    if (error == boost::system::errc::address_not_available) {
        throw ListenError(
            fmt::format("{} is not an address of this machine; give --host an address that `ip address` lists, "
                        "127.0.0.1 (this machine only) or 0.0.0.0 (all addresses)",
                        address));
    }
    if (error)
        throw ListenError(
            fmt::format("cannot listen on {}, port {}: {}; choose a different address or port with --host and --port",
                        address, port, error.message()));
}

}  // namespace

class Server::Network {
  public:
    Network(const ServerLimits& limits, Service& service) : limits_(limits), service_(service) {}

    void run();
    void close();

    asio::io_context io{1};
    tcp::acceptor acceptor{io};
    asio::signal_set signals{io};

  private:
    asio::awaitable<void> accept();
    void admit(tcp::socket socket);

    asio::steady_timer last_moment_{io};
    const ServerLimits limits_;
    Service& service_;
    std::list<Connection> connections_;
    bool is_closing_ = false;
};

void Server::Network::run() {
    signals.async_wait([this](error_code error, int) {
        if (!error) close();
    });
    asio::co_spawn(io, accept(), asio::detached);
    io.run();
}

/// Gives current answers a moment to finish. run returns when the last coroutine has ended.
void Server::Network::close() {
    if (is_closing_) return;
    is_closing_ = true;
    error_code ignored;
    acceptor.close(ignored);
    signals.cancel(ignored);
    if (connections_.empty()) return;
    last_moment_.expires_after(limits_.linger_time);
    last_moment_.async_wait([this](error_code error) {
        if (error) return;
        for (Connection& connection : connections_) connection.stream.close();
    });
}

asio::awaitable<void> Server::Network::accept() {
    while (!is_closing_) {
        auto [error, socket] = co_await acceptor.async_accept(as_awaitable_accept);
        if (is_closing_) co_return;
        if (!error) {
            admit(std::move(socket));
            continue;
        }
        // Too many files are open, or the client has disconnected: try again in a moment.
        asio::steady_timer timer(io, 50ms);
        co_await timer.async_wait(as_awaitable_accept);
    }
}

void Server::Network::admit(tcp::socket socket) {
    if (connections_.size() >= limits_.connections) {
        error_code ignored;
        socket.non_blocking(true, ignored);
        socket.write_some(asio::buffer(busy), ignored);
        return;
    }
    // Room for a head, and for the extra bytes of one read.
    boost::beast::flat_buffer buffer(2 * limits_.head_bytes);
    const auto connection = connections_.insert(
        connections_.end(), Connection{boost::beast::tcp_stream(std::move(socket)), std::move(buffer)});
    asio::co_spawn(io, converse(*connection, service_, limits_), [this, connection](const std::exception_ptr& failure) {
        if (failure) say("raygrade: closed a connection because of an internal error\n");
        connections_.erase(connection);
        if (is_closing_ && connections_.empty()) last_moment_.cancel();
    });
}

std::string web_address(const std::string& host, std::uint16_t port) {
    const bool is_v6 = host.find(':') != std::string::npos;
    return fmt::format("http://{}{}{}:{}/", is_v6 ? "[" : "", host, is_v6 ? "]" : "", port);
}

Server::Server(const std::string& address, std::uint16_t port, const ServerLimits& limits, Service& service)
    : network_(std::make_unique<Network>(limits, service)) {
    listen(network_->acceptor, address, port);
}

Server::~Server() = default;

std::uint16_t Server::port() const {
    return network_->acceptor.local_endpoint().port();
}

void Server::stop_on_signals() {
    network_->signals.add(SIGINT);
    network_->signals.add(SIGTERM);
}

void Server::stop() {
    asio::post(network_->io, [this] { network_->close(); });
}

void Server::run() {
    network_->run();
}

}  // namespace harness::serve
