// The limits of a server for its clients.
#pragma once

#include <chrono>
#include <cstddef>

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

}  // namespace harness::serve
