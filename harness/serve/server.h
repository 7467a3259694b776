// HTTP over TCP for many clients, some of them slow, broken or hostile, with bounded memory and one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "harness/serve/desk.h"
#include "harness/serve/site.h"

namespace harness::serve {

/// What clients may use. Whoever goes beyond it is told where that is possible, and cut off.
struct ServerLimits {
    /// At one time. At the limit a connection that has asked nothing for the longest time makes room for a new one.
    std::size_t connections = 256;
    std::size_t connections_of_one_address = 64;  ///< behind a proxy all come from one, and this does not count
    std::size_t head_bytes = 16 << 10;
    std::size_t body_bytes = (1 << 20) + (8 << 10);  ///< a source and the form around it
    std::size_t all_body_bytes = 64 << 20;           ///< of all connections together
    int requests_of_one_connection = 100;
    // From its begin to its end, however the bytes are spread.
    std::chrono::milliseconds head_time{10'000};  ///< also of silence before it
    std::chrono::milliseconds body_time{30'000};
    std::chrono::milliseconds answer_time{30'000};
    std::chrono::milliseconds linger_time{2'000};  ///< for what a client still sends that was told to stop
};

/// The address can't be listened at: what() says why and the way out.
class ListenError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Server {
  public:
    /// Listens from now on: at an IP address of this machine, at port 0 for any free one. Throws ListenError.
    Server(const std::string& address, std::uint16_t port, const ServerLimits& limits, bool behind_proxy, Site& site,
           Desk& desk);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::uint16_t port() const;

    /// From now on SIGINT and SIGTERM do what stop does.
    void stop_on_signals();
    /// Makes run take no more programs, and return; called once more, at once. Safe to call from another thread.
    void stop();
    /// Serves until it is stopped and then on, so that students see their results, until nothing waits at the desk or
    /// `grace` is over.
    void run(std::chrono::milliseconds grace);

  private:
    class Network;
    std::unique_ptr<Network> network_;
};

}  // namespace harness::serve
