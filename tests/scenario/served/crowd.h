// Hundreds of connections that take a server's room: silent ones, slow ones, large bodies, readers that stop.
#pragma once

#include <cstdint>
#include <list>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/given/serve/hostile_requests.h"
#include "tests/scenario/served/attacker.h"

namespace scenario {

class Crowd {
  public:
    /// The crowd comes from 127.0.0.1, with some idle connections, and in numbers from four addresses beside it.
    Crowd(std::uint16_t port, unsigned seed, const harness::serve::Target& target);
    /// Closes all connections.
    ~Crowd();
    Crowd(const Crowd&) = delete;
    Crowd& operator=(const Crowd&) = delete;

    /// What the server has sent to all of them. Call it after end().
    const std::string& received() const { return received_; }
    std::size_t opened() const { return opened_; }
    void end();

  private:
    enum class Kind { silent, asks_once, slow_head, slow_body, large_body, does_not_read };
    struct Member {
        Kind kind;
        Socket socket;
        std::string bytes;  ///< all that it has to send
        std::size_t sent = 0;
    };

    void add(std::uint8_t from);
    bool goes_on(Member& member);
    void work(const std::stop_token& stop);

    const std::uint16_t port_;
    const harness::serve::Target target_;
    std::mt19937 random_;
    std::list<std::pair<std::uint8_t, Member>> members_;  ///< with their addresses
    std::string received_;
    std::size_t opened_ = 0;
    std::jthread thread_;
};

}  // namespace scenario
