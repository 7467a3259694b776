#include "tests/scenario/served/attacker.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace scenario {

Socket::Socket(std::uint16_t port, std::uint8_t from, int received_bytes)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (received_bytes > 0) setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &received_bytes, sizeof received_bytes);
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl((INADDR_LOOPBACK & ~0xffU) | from);
    sockaddr_in server = own;
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    server.sin_port = htons(port);
    if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0)
        throw std::runtime_error("can't use the address");
    if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&server), sizeof server) != 0)
        throw std::runtime_error("can't connect");
    fcntl(socket_.get(), F_SETFL, O_NONBLOCK);
}

bool Socket::send(std::string_view& bytes) const {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0) return errno == EAGAIN;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

bool Socket::receive(std::string& received) const {
    for (;;) {
        std::array<char, 65536> bytes;
        const ssize_t got = recv(socket_.get(), bytes.data(), bytes.size(), 0);
        if (got <= 0) return got < 0 && errno == EAGAIN;
        received.append(bytes.data(), static_cast<std::size_t>(got));
    }
}

void Socket::end_sending() const {
    shutdown(socket_.get(), SHUT_WR);
}

void Socket::reset() {
    const linger at_once{1, 0};
    setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    socket_.close();
}

std::string exchange(std::uint16_t port, std::uint8_t from, std::string_view bytes,
                     std::chrono::milliseconds patience) {
    const Socket socket(port, from);
    const auto late = std::chrono::steady_clock::now() + patience;
    std::string received;
    bool is_sending = true;
    while (std::chrono::steady_clock::now() < late) {
        const bool is_taken = !is_sending || socket.send(bytes);
        if (is_sending && (bytes.empty() || !is_taken)) {
            is_sending = false;
            socket.end_sending();
        }
        if (!socket.receive(received)) return received;
        pollfd wait{socket.get(), static_cast<short>(is_sending ? POLLIN | POLLOUT : POLLIN), 0};
        poll(&wait, 1, 100);
    }
    throw std::runtime_error("the connection does not end");
}

}  // namespace scenario
