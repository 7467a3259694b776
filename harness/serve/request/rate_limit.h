// Limits how often a client may submit.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <unordered_map>

namespace harness::serve {

/// Each client has a bucket of `burst` turns, which refills at an even rate. Use it from one thread only.
class RateLimit {
  public:
    using Clock = std::chrono::steady_clock;

    /// Remembers at most `clients` buckets that are not full, those used last, so that memory is bounded.
    RateLimit(double turns_a_minute, int burst, std::size_t clients = 10'000);

    /// How long until the client has a turn, in whole seconds rounded up; 0 if it has a turn now.
    std::chrono::seconds wait_of(const std::string& client, Clock::time_point now) const;
    /// Takes a turn. Call it only if wait_of returned 0.
    void take(const std::string& client, Clock::time_point now);
    std::size_t remembered() const { return buckets_.size(); }

  private:
    struct Bucket {
        double turns;
        Clock::time_point at;  ///< when the bucket held `turns`
    };
    double turns_at(const Bucket& bucket, Clock::time_point now) const;
    void forget_some(Clock::time_point now);

    double turns_a_second_, burst_;
    std::size_t clients_;
    std::unordered_map<std::string, Bucket> buckets_;
};

/// The name under which a client is counted: an IPv4 address itself, or the 64-bit network of an IPv6 address, because
/// a household or a laptop gets such a network. Other text is returned unchanged.
std::string client_of(const std::string& address);

}  // namespace harness::serve
