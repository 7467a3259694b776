// An HTTP client for tests. It can send any bytes over a socket, and reads answers as RFC 9112 defines them.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "harness/machine/file_descriptor.h"

namespace harness::serve {

/// Long enough for a busy machine. The tests only check that the connection ends at all.
constexpr auto soon = std::chrono::seconds(20);

struct HttpAnswer {
    int status = 0;                             ///< 0: the connection ended before a complete answer
    std::map<std::string, std::string> fields;  ///< by name in lower case
    std::string body;
};

class Client {
  public:
    /// Connects to 127.0.0.1. Throws std::runtime_error.
    explicit Client(std::uint16_t port);

    /// Returns false if the server no longer accepts bytes.
    bool send(std::string_view bytes);
    /// Ends the connection by a reset.
    void reset();
    /// The next answer. An answer to a HEAD request has no body. Waits at most half a minute.
    HttpAnswer answer(bool to_head = false);
    /// All bytes that the server still sends. Waits at most half a minute for each piece.
    std::string rest();
    /// Whether the server ends the connection within the time. Bytes that it still sends are read and dropped.
    bool ends_within(std::chrono::milliseconds time);
    /// Whether a read met a connection reset. A reset makes some clients lose an answer that they have not read yet.
    bool was_reset() const { return was_reset_; }

  private:
    friend std::string exchange(std::uint16_t port, std::string_view bytes);
    bool receive_more();

    FileDescriptor socket_;
    std::string received_;
    bool was_reset_ = false;
};

/// Sends one request on a new connection.
HttpAnswer ask(std::uint16_t port, std::string_view request);

/// Sends any bytes on a new connection, ends its side of it, and returns all that the server sends until its own end.
/// Throws std::runtime_error if the server does not end the connection soon.
std::string exchange(std::uint16_t port, std::string_view bytes);

/// "GET path HTTP/1.1" with the fields that every browser sends, and further fields `more` ("Name: value\r\n").
std::string get(const std::string& path, const std::string& more = "");
/// A request that posts the form with a file.
std::string upload(const std::string& source, const std::string& more = "");

/// The head of such a request, with `length` ("Content-Length: 9\r\n").
std::string head_of_upload(const std::string& length);
}  // namespace harness::serve
