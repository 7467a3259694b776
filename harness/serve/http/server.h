// Serves HTTP to many clients, some of them slow, broken or hostile, in bounded memory and with one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "harness/serve/http/server_limits.h"
#include "harness/serve/request/service.h"

namespace harness::serve {

/// The address to type in a browser: "http://192.168.1.20:8080/".
std::string web_address(const std::string& host, std::uint16_t port);

/// The server can't listen at the address. what() says why and what to do.
class ListenError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Server {
  public:
    /// Starts to listen at an IP address of this machine. Port 0 means any free port. Throws ListenError.
    Server(const std::string& address, std::uint16_t port, const ServerLimits& limits, Service& service);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::uint16_t port() const;

    /// From now on SIGINT and SIGTERM call stop.
    void stop_on_signals();
    /// Makes run stop accepting connections and return once the current answers are sent, or a moment later. Safe to
    /// call from another thread.
    void stop();
    /// Serves until stop is called.
    void run();

  private:
    class Network;
    std::unique_ptr<Network> network_;
};

}  // namespace harness::serve
