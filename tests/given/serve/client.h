// A client for tests that says what it likes: bytes over a socket, and answers read by what RFC 9112 says of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "harness/sandbox/file_descriptor.h"

namespace harness::serve {

struct HttpAnswer {
    int status = 0;                             ///< 0: the connection ended without a whole answer
    std::map<std::string, std::string> fields;  ///< by their name in lower case
    std::string body;
};

class Client {
  public:
    /// Connects to 127.0.0.1. Throws std::runtime_error.
    explicit Client(std::uint16_t port);

    /// False when the server does not take it any more.
    bool send(std::string_view bytes);
    /// The next answer; to a HEAD one without a body. Waits for half a minute at the most.
    HttpAnswer answer(bool to_head = false);
    /// Whether the server ends the connection within the time, whatever it still sends.
    bool ends_within(std::chrono::milliseconds time);
    /// Whether a read met a reset, which takes the answer from some clients before they have read it.
    bool was_reset() const { return was_reset_; }
    /// Whether there is something to read within the time.
    bool is_told_within(std::chrono::milliseconds time) const;

  private:
    bool receive_more();

    FileDescriptor socket_;
    std::string received_;
    bool was_reset_ = false;
};

/// One request on a connection of its own.
HttpAnswer ask(std::uint16_t port, std::string_view request);

/// "GET path HTTP/1.1" with the fields that every browser sends, and `more` ("Name: value\r\n").
std::string get(const std::string& path, const std::string& more = "");
/// A form with a file in it.
std::string upload(const std::string& source, const std::string& more = "");

}  // namespace harness::serve
