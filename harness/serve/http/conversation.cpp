// Each phase of an exchange has one deadline from its beginning, so a client that sends a byte a second gains nothing.
// Before closing a connection, the server reads and drops for a moment what the client still sends: closing at once
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

/// The status of a body that can't be taken, 0 if the client is gone, empty if the whole body was read.
asio::awaitable<std::optional<int>> read_body(Connection& connection, const ServerLimits& limits, Parser& parser) {
    if (parser.content_length().value_or(0) > limits.body_bytes) co_return 413;
    parser.body_limit(limits.body_bytes);
    connection.stream.expires_after(limits.body_time);
    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) {
        constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
        const auto [failure, size] = co_await asio::async_write(connection.stream, asio::buffer(go_on), as_awaitable);
        if (failure) co_return 0;
    }
    // Beast would read 512 bytes at a time, each after a turn of every other connection.
    connection.buffer.reserve(connection.buffer.max_size());
    const auto [failure, size] = co_await http::async_read(connection.stream, connection.buffer, parser, as_awaitable);
    if (!failure) co_return std::nullopt;
    if (failure == http::error::body_limit) co_return 413;
    co_return status_of(failure) ? 400 : 0;
}

/// Returns the service's answer. An error of the machine or of raygrade goes to the log and to the client.
template <class Ask>
auto answer_or_fail(const Common& common, const Head& head, Ask ask) -> decltype(ask()) {
    try {
        return ask();
    } catch (const std::exception& error) {
        complain(error);
        return common.service.problem(head, 500);
    }
}

struct Answer {
    Response response;
    bool is_whole = false;  ///< the whole request was read, so the next can follow
};

/// Empty if the client is gone.
asio::awaitable<std::optional<Answer>> answer_program(Connection& connection, Common& common, Parser& parser,
                                                      const Head& head) {
    const std::optional<int> refused = co_await read_body(connection, common.limits, parser);
    if (refused) {
        if (*refused == 0) co_return std::nullopt;
        co_return Answer{common.service.problem(head, *refused)};
    }
    const std::string body = std::move(parser.get().body());
    co_return Answer{answer_or_fail(common, head, [&] { return common.service.take_in(head, body); }), true};
}

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

/// Handles one request. Returns false if no further request will be read.
asio::awaitable<bool> exchange(Connection& connection, Common& common) {
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(common.limits.head_bytes));
    parser.body_limit(boost::none);  // a limit would refuse the request before its head is known
    connection.stream.expires_after(common.limits.head_time);
    connection.is_idle = true;
    connection.idle_since = Connection::Clock::now();
    const auto [failure, size] =
        co_await http::async_read_header(connection.stream, connection.buffer, parser, as_awaitable);
    connection.is_idle = false;
    const Head head = head_of(parser);
    std::optional<Answer> answer;
    if (failure) {
        const auto status = status_of(failure);
        if (!status) co_return false;
        answer = Answer{common.service.problem(head, *status)};
    } else if (!has_clear_length(parser)) {
        answer = Answer{common.service.problem(head, 400)};
    } else if (auto early = answer_or_fail(common, head, [&] { return common.service.answer(head); })) {
        answer = Answer{std::move(*early), parser.is_done()};
    } else {
        answer = co_await answer_program(connection, common, parser, head);
        if (!answer) co_return false;
    }
    const bool goes_on = answer->is_whole && !common.is_closing && parser.keep_alive();
    const Message message = message_of(std::move(answer->response), parser.get().version(), goes_on);
    if (!co_await write(connection, common.limits, message, head.method == Method::head)) co_return false;
    if (!goes_on) co_await linger(connection, common.limits);
    // The server may have begun to close meanwhile, which closes only idle connections at once.
    co_return goes_on && !common.is_closing;
}

}  // namespace

asio::awaitable<void> converse(Connection& connection, Common& common) {
    for (bool goes_on = true; goes_on;) goes_on = co_await exchange(connection, common);
    connection.stream.close();
}

}  // namespace harness::serve
