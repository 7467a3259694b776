#include "harness/serve/http/http_message.h"

#include <boost/beast/core/string.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>

namespace harness::serve {
namespace {

namespace http = boost::beast::http;

/// A field that occurs several times has all of its values, joined by commas as in RFC 9110: a proxy or a browser may
/// have meant any of them.
template <class Name>
std::string text_of(const Parser& parser, const Name& name) {
    std::string text;
    const auto [first, last] = parser.get().equal_range(name);
    for (auto field = first; field != last; ++field) {
        if (field != first) text += ',';
        text.append(field->value().data(), field->value().size());
    }
    return text;
}

Method method_of(http::verb verb) {
    if (verb == http::verb::get) return Method::get;
    if (verb == http::verb::head) return Method::head;
    if (verb == http::verb::post) return Method::post;
    return Method::other;
}

}  // namespace

Head head_of(const Parser& parser) {
    const auto& fields = parser.get();
    Head head;
    head.method = method_of(fields.method());
    const std::string target(fields.target().data(), fields.target().size());
    head.path = target.substr(0, target.find_first_of("?#"));
    if (fields.count(http::field::host) == 1) head.host = text_of(parser, http::field::host);
    if (fields.count(http::field::origin) > 0) head.origin = text_of(parser, http::field::origin);
    head.fetch_site = text_of(parser, "Sec-Fetch-Site");
    head.content_type = text_of(parser, http::field::content_type);
    head.wants_json = text_of(parser, http::field::accept).find("application/json") != std::string::npos;
    return head;
}

bool has_clear_length(const Parser& parser) {
    if (parser.get().count(http::field::transfer_encoding) == 0) return true;
    constexpr unsigned http_1_1 = 11;
    return parser.get().version() == http_1_1 &&
           boost::beast::iequals(text_of(parser, http::field::transfer_encoding), "chunked");
}

Message message_of(Response response, unsigned version) {
    Message message;
    message.version(version);
    message.result(static_cast<unsigned>(response.status));
    message.set(http::field::content_type, response.type);
    message.set(http::field::cache_control, "no-store");
    message.set("X-Content-Type-Options", "nosniff");
    // Not "no-referrer": browsers would then hide that a form comes from this site.
    message.set("Referrer-Policy", "same-origin");
    message.set("Cross-Origin-Opener-Policy", "same-origin");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
    // For responses that are not pages, in case a browser shows them as pages; pages have their own policy.
    message.set("Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'");
    for (const auto& [name, value] : response.fields) message.set(name, value);
    message.body() = std::move(response.body);
    message.keep_alive(false);
    message.prepare_payload();
    return message;
}

std::optional<int> status_of(const boost::system::error_code& error) {
    if (error == http::error::header_limit || error == http::error::buffer_overflow) return 431;
    if (error == http::error::body_limit) return 413;
    const bool is_gone = error == http::error::end_of_stream || error == http::error::partial_message;
    if (is_gone || error.category() != http::make_error_code(http::error::bad_method).category()) return {};
    return 400;
}

}  // namespace harness::serve
