// How often one client may hand in.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <unordered_map>

namespace harness::serve {

/// Every client has a bucket of `burst` turns, which fills up again at an even rate. For one thread.
class RateLimit {
  public:
    using Clock = std::chrono::steady_clock;

    /// Of at most `clients` buckets that are not full the last used ones are remembered, so that memory has a bound.
    RateLimit(double turns_a_minute, int burst, std::size_t clients = 10'000);

    /// How long until the client has a turn, in whole seconds rounded up; 0 when it has one now.
    std::chrono::seconds wait_of(const std::string& client, Clock::time_point now) const;
    /// Takes a turn, which wait_of says there is.
    void take(const std::string& client, Clock::time_point now);
    std::size_t remembered() const { return buckets_.size(); }

  private:
    struct Bucket {
        double turns;
        Clock::time_point at;  ///< when it held so many
    };
    double turns_at(const Bucket& bucket, Clock::time_point now) const;
    void forget_some(Clock::time_point now);

    double turns_a_second_, burst_;
    std::size_t clients_;
    std::unordered_map<std::string, Bucket> buckets_;
};

/// By what a client is counted: an IPv4 address by itself, an IPv6 address by its network of 64 bits, which is what a
/// household or a laptop is given. Text that is no address counts as itself.
std::string client_of(const std::string& address);

}  // namespace harness::serve
