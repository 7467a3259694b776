// Sockets of an attacker, which send anything, read when they want to and end how they want to.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "harness/machine/file_descriptor.h"

namespace scenario {

/// A connection to 127.0.0.1 from the address 127.0.0.`from`, on which nothing waits.
class Socket {
  public:
    /// Throws std::runtime_error. `received_bytes` of what it has not read are kept; 0 for the usual number.
    Socket(std::uint16_t port, std::uint8_t from, int received_bytes = 0);

    /// Sends what there is room for now, and takes it off `bytes`. False if the server takes no more.
    bool send(std::string_view& bytes) const;
    /// Adds what is there to `received`. False if the server has ended the connection.
    bool receive(std::string& received) const;
    void end_sending() const;
    /// Ends the connection by a reset.
    void reset();
    int get() const { return socket_.get(); }

  private:
    harness::FileDescriptor socket_;
};

/// Sends the bytes, ends its side of the connection and gives what the server sent until its own end. Throws
/// std::runtime_error if that takes longer than `patience`.
std::string exchange(std::uint16_t port, std::uint8_t from, std::string_view bytes, std::chrono::milliseconds patience);

}  // namespace scenario
