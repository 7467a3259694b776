#include "tests/given/serve/client.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace harness::serve {

Client::Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval half_a_minute{30, 0};
    setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &half_a_minute, sizeof half_a_minute);
    setsockopt(socket_.get(), SOL_SOCKET, SO_SNDTIMEO, &half_a_minute, sizeof half_a_minute);
    if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        throw std::runtime_error("can't connect");
}

bool Client::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

void Client::reset() {
    const linger at_once{1, 0};
    setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    socket_.close();
}

bool Client::receive_more() {
    std::array<char, 65536> bytes;
    const ssize_t got = recv(socket_.get(), bytes.data(), bytes.size(), 0);
    was_reset_ = was_reset_ || (got < 0 && errno == ECONNRESET);
    if (got <= 0) return false;
    received_.append(bytes.data(), static_cast<std::size_t>(got));
    return true;
}

HttpAnswer Client::answer(bool to_head) {
    HttpAnswer answer;
    std::size_t end = 0;
    while ((end = received_.find("\r\n\r\n")) == std::string::npos) {
        if (!receive_more()) return {};
    }
    const std::string head = received_.substr(0, end + 2);
    received_.erase(0, end + 4);
    if (!head.starts_with("HTTP/1.1 ") && !head.starts_with("HTTP/1.0 ")) return {};
    for (std::size_t line = head.find("\r\n") + 2; line < head.size(); line = head.find("\r\n", line) + 2) {
        const std::size_t colon = head.find(": ", line);
        std::string name = head.substr(line, colon - line);
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
        answer.fields[name] = head.substr(colon + 2, head.find("\r\n", line) - colon - 2);
    }
    int status = 0;
    std::from_chars(head.data() + sizeof "HTTP/1.1", head.data() + head.size(), status);
    const auto length = answer.fields.find("content-length");
    const std::size_t size = to_head || length == answer.fields.end() ? 0 : std::stoul(length->second);
    while (received_.size() < size) {
        if (!receive_more()) return {};
    }
    answer.body = received_.substr(0, size);
    received_.erase(0, size);
    answer.status = status;
    return answer;
}

std::string Client::rest() {
    while (receive_more()) {
    }
    return std::exchange(received_, {});
}

bool Client::ends_within(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        pollfd wait{socket_.get(), POLLIN, 0};
        if (left.count() <= 0 || poll(&wait, 1, static_cast<int>(left.count())) <= 0) return false;
        if (!receive_more()) return true;
    }
}

HttpAnswer ask(std::uint16_t port, std::string_view request) {
    Client client(port);
    client.send(request);
    return client.answer(request.starts_with("HEAD"));
}

std::string exchange(std::uint16_t port, std::string_view bytes) {
    Client client(port);
    client.send(bytes);
    shutdown(client.socket_.get(), SHUT_WR);
    if (!client.ends_within(soon)) throw std::runtime_error("the connection does not end");
    return std::move(client.received_);
}

std::string get(const std::string& path, const std::string& more) {
    return "GET " + path + " HTTP/1.1\r\nHost: localhost\r\nUser-Agent: test\r\n" + more + "\r\n";
}

std::string upload(const std::string& source, const std::string& more) {
    const std::string body =
        "--cut\r\nContent-Disposition: form-data; name=\"source\"; filename=\"ray_cast.cpp\"\r\n\r\n" + source +
        "\r\n--cut--\r\n";
    return "POST /check HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; boundary=cut\r\n" + more +
           "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

std::string head_of_upload(const std::string& length) {
    return "POST /check HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; boundary=cut\r\n" + length +
           "\r\n";
}

}  // namespace harness::serve
