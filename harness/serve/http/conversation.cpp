// Heads have one deadline from their beginning, bodies and answers a least rate besides, so a client that sends a byte
// a second gains nothing. Before closing a connection, the server reads and drops for a moment what the client still
// sends: closing at once would reset the connection, and the client would never see the answer.
#include "harness/serve/http/conversation.h"

#include <fmt/format.h>

#include <algorithm>
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

/// The time by which something must have moved in a body or an answer.
class Pace {
  public:
    using Clock = Connection::Clock;

    Pace(const ServerLimits& limits, std::chrono::milliseconds whole) : limits_(limits), end_(Clock::now() + whole) {}

    /// To be called before each read or write, with the bytes moved so far.
    void expect_more(Connection& connection, std::size_t moved) const {
        connection.silent_since = Clock::now();
        const auto paid = std::chrono::milliseconds(1000 * moved / limits_.least_bytes_a_second);
        connection.stream.expires_at(
            std::min({end_, connection.silent_since + limits_.silence_time, begin_ + limits_.rate_grace + paid}));
    }

  private:
    const ServerLimits& limits_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point end_;
};

/// How reading a body ended.
enum class Body { whole, too_large, no_room, malformed, gone };

asio::awaitable<Body> read_body(Connection& connection, Common& common, Parser& parser) {
    const ServerLimits& limits = common.limits;
    if (parser.content_length().value_or(0) > limits.body_bytes) co_return Body::too_large;
    parser.body_limit(limits.body_bytes);
    const Pace pace(limits, limits.body_time);
    pace.expect_more(connection, 0);
    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) {
        constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
        const auto [failure, size] = co_await asio::async_write(connection.stream, asio::buffer(go_on), as_awaitable);
        if (failure) co_return Body::gone;
    }
    std::size_t moved = 0;
    // Beast would read 512 bytes at a time, each after a turn of every other connection.
    connection.buffer.reserve(connection.buffer.max_size());
    while (!parser.is_done()) {
        pace.expect_more(connection, moved);
        const auto [failure, size] =
            co_await http::async_read_some(connection.stream, connection.buffer, parser, as_awaitable);
        if (failure == http::error::body_limit) co_return Body::too_large;
        if (connection.is_refused_body) co_return Body::no_room;
        if (failure) co_return status_of(failure) ? Body::malformed : Body::gone;
        moved += size;
        if (!common.connections.hold_body(connection, parser.get().body().size())) co_return Body::no_room;
    }
    co_return Body::whole;
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
    const Body read = co_await read_body(connection, common, parser);
    const std::string body = std::move(parser.get().body());
    common.connections.hold_body(connection, 0);
    switch (read) {
        case Body::whole: break;
        case Body::too_large: co_return Answer{common.service.problem(head, 413)};
        case Body::no_room: co_return Answer{common.service.problem(head, 503)};
        case Body::malformed: co_return Answer{common.service.problem(head, 400)};
        case Body::gone: co_return std::nullopt;
    }
    co_return Answer{answer_or_fail(common, head, [&] { return common.service.take_in(head, body); }), true};
}

asio::awaitable<bool> write(Connection& connection, const ServerLimits& limits, const Message& message,
                            bool only_head) {
    http::response_serializer<http::string_body> serializer(message);
    serializer.split(only_head);
    const Pace pace(limits, limits.answer_time);
    std::size_t moved = 0;
    while (only_head ? !serializer.is_header_done() : !serializer.is_done()) {
        pace.expect_more(connection, moved);
        const auto [failure, size] = co_await http::async_write_some(connection.stream, serializer, as_awaitable);
        if (failure) co_return false;
        moved += size;
    }
    connection.silent_since = Connection::Clock::now();
    co_return true;
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
asio::awaitable<bool> exchange(Connection& connection, Common& common, bool is_last) {
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(common.limits.head_bytes));
    parser.body_limit(boost::none);  // a limit would refuse the request before its head is known
    connection.stream.expires_after(common.limits.head_time);
    connection.is_idle = true;
    connection.is_refused_body = false;
    const auto [failure, size] =
        co_await http::async_read_header(connection.stream, connection.buffer, parser, as_awaitable);
    connection.is_idle = false;
    const Head head = head_of(parser, connection.client);
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
    const bool goes_on = answer->is_whole && !is_last && !common.is_closing && parser.keep_alive();
    const Message message = message_of(std::move(answer->response), parser.get().version(), goes_on);
    if (!co_await write(connection, common.limits, message, head.method == Method::head)) co_return false;
    if (!goes_on) co_await linger(connection, common.limits);
    // The server may have begun to close meanwhile, which closes only idle connections at once.
    co_return goes_on && !common.is_closing;
}

}  // namespace

asio::awaitable<void> converse(Connection& connection, Common& common) {
    for (int i = 1; co_await exchange(connection, common, i >= common.limits.requests_of_one_connection); ++i) {
    }
    connection.stream.close();
}

}  // namespace harness::serve
