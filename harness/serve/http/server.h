// Serves HTTP to many clients, some of them slow, broken or hostile, in bounded memory and with one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "harness/serve/request/service.h"

namespace harness::serve {

/// Limits for clients. A client beyond a limit is told so if possible, and disconnected.
struct ServerLimits {
    /// At the same time. At the limit, connections.h says which of them is closed for a new one.
    std::size_t connections = 256;
    std::size_t connections_of_one_address = 64;  ///< ignored behind a proxy, from which all connections come
    std::size_t head_bytes = 16 << 10;
    std::size_t body_bytes = (1 << 20) + (8 << 10);  ///< a source and the form around it
    std::size_t all_body_bytes = 64 << 20;           ///< of all connections together; see connections.h
    int requests_of_one_connection = 100;
    // Each from the beginning of its phase to the end, however the bytes arrive.
    std::chrono::milliseconds head_time{10'000};  ///< includes the silence before it
    std::chrono::milliseconds body_time{30'000};
    std::chrono::milliseconds answer_time{30'000};
    /// Of a body and of an answer: the longest time without a byte, and the least rate on average after a moment.
    std::chrono::milliseconds silence_time{10'000};
    std::chrono::milliseconds rate_grace{5'000};
    std::size_t least_bytes_a_second = 1 << 10;
    std::chrono::milliseconds linger_time{2'000};  ///< for what a client still sends after its last answer
};

/// The server can't listen at the address. what() says why and what to do.
class ListenError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Server {
  public:
    /// Starts to listen at an IP address of this machine. Port 0 means any free port. Throws ListenError.
    Server(const std::string& address, std::uint16_t port, const ServerLimits& limits, bool behind_proxy,
           Service& service);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::uint16_t port() const;

    /// From now on SIGINT and SIGTERM call stop.
    void stop_on_signals();
    /// Makes run accept no more work and return; a second call makes it return at once. Safe to call from another
    /// thread.
    void stop();
    /// Serves until stop is called, and then on until no work is left or `grace` is over, so that students see their
    /// results.
    void run(std::chrono::milliseconds grace);

  private:
    class Network;
    std::unique_ptr<Network> network_;
};

}  // namespace harness::serve
