// The limits that a server sets for its clients.
#pragma once

#include <chrono>
#include <cstddef>

namespace harness::serve {

/// A client beyond a limit gets a message if possible and is disconnected. Rates for each address are a proxy's job.
struct ServerLimits {
    std::size_t connections = 256;  ///< at the same time; further ones are refused
    std::size_t head_bytes = 16 << 10;
    std::size_t body_bytes = (1 << 20) + (8 << 10);  ///< for a source and the form around it
    // Each covers its whole phase, from beginning to end, however the bytes arrive.
    std::chrono::milliseconds head_time{10'000};
    std::chrono::milliseconds body_time{30'000};
    std::chrono::milliseconds answer_time{30'000};
    std::chrono::milliseconds linger_time{2'000};  ///< for bytes that a client sends after its last answer
};

}  // namespace harness::serve
