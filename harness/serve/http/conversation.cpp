// Each phase of an exchange has one deadline from its start, so a client that sends a byte a second gains nothing.
// Before the server closes a connection, it reads and drops for a moment what the client still sends: closing at once
// would reset the connection, and the client would never see the answer.
#include "harness/serve/http/conversation.h"

#include <array>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>

#include "harness/machine/say.h"
#include "harness/serve/http/http_message.h"

namespace harness::serve {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;

constexpr auto as_awaitable = asio::as_tuple(asio::use_awaitable);

/// An error status if the body is refused, 0 if the client has disconnected, empty if the whole body was read.
asio::awaitable<std::optional<int>> read_body(Connection& connection, const ServerLimits& limits, Parser& parser) {
    if (parser.content_length().value_or(0) > limits.body_bytes) co_return 413;
    parser.body_limit(limits.body_bytes);
    connection.stream.expires_after(limits.body_time);
    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) {
        constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
        const auto [failure, size] = co_await asio::async_write(connection.stream, asio::buffer(go_on), as_awaitable);
        if (failure) co_return 0;
    }
    // Beast would read 512 bytes at a time, and serve every other connection in between.
    connection.buffer.reserve(connection.buffer.max_size());
    const auto [failure, size] = co_await http::async_read(connection.stream, connection.buffer, parser, as_awaitable);
    if (!failure) co_return std::nullopt;
    if (failure == http::error::body_limit) co_return 413;
    co_return status_of(failure) ? 400 : 0;
}

/// Returns the service's answer. An error of the machine or of raygrade goes to the log and to the client.
template <class Ask>
auto answer_or_fail(Service& service, const Head& head, Ask ask) -> decltype(ask()) {
    try {
        return ask();
    } catch (const std::exception& error) {
        complain(error);
        return service.problem(head, 500);
    }
}

/// Empty if the client has disconnected.
asio::awaitable<std::optional<Response>> answer_request(Connection& connection, Service& service,
                                                        const ServerLimits& limits, Parser& parser) {
    connection.stream.expires_after(limits.head_time);
    const auto [failure, size] =
        co_await http::async_read_header(connection.stream, connection.buffer, parser, as_awaitable);
    const Head head = head_of(parser);
    if (failure) {
        const auto status = status_of(failure);
        if (!status) co_return std::nullopt;
        co_return service.problem(head, *status);
    }
    if (!has_clear_length(parser)) co_return service.problem(head, 400);
    if (auto early = answer_or_fail(service, head, [&] { return service.answer(head); })) co_return early;
    const std::optional<int> refused = co_await read_body(connection, limits, parser);
    if (refused == 0) co_return std::nullopt;
    if (refused) co_return service.problem(head, *refused);
    const std::string body = std::move(parser.get().body());
    co_return answer_or_fail(service, head, [&] { return service.take_in(head, body); });
}

/// Whether the client received it.
asio::awaitable<bool> write(Connection& connection, const ServerLimits& limits, const Message& message,
                            bool only_head) {
    http::response_serializer<http::string_body> serializer(message);
    connection.stream.expires_after(limits.answer_time);
    if (only_head) {
        const auto [failure, size] = co_await http::async_write_header(connection.stream, serializer, as_awaitable);
        co_return !failure;
    }
    const auto [failure, size] = co_await http::async_write(connection.stream, serializer, as_awaitable);
    co_return !failure;
}

asio::awaitable<void> linger(Connection& connection, const ServerLimits& limits) {
    error_code ignored;
    connection.stream.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    connection.stream.expires_after(limits.linger_time);
    std::array<char, 16 * 1024> rest;
    for (std::size_t drained = 0; drained < 4 * limits.body_bytes;) {
        const auto [failure, size] = co_await connection.stream.async_read_some(asio::buffer(rest), as_awaitable);
        if (failure) co_return;
        drained += size;
    }
}

}  // namespace

asio::awaitable<void> converse(Connection& connection, Service& service, const ServerLimits& limits) {
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(limits.head_bytes));
    parser.body_limit(boost::none);  // a limit would refuse the request before its head is known
    if (auto response = co_await answer_request(connection, service, limits, parser)) {
        const bool only_head = parser.get().method() == http::verb::head;
        const Message message = message_of(std::move(*response), parser.get().version());
        if (co_await write(connection, limits, message, only_head)) co_await linger(connection, limits);
    }
    connection.stream.close();
}

}  // namespace harness::serve
