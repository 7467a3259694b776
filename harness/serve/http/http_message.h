// Converts between Boost.Beast's HTTP messages and exchange.h.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>
#include <string>

#include "harness/serve/request/exchange.h"

namespace harness::serve {

using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
using Message = boost::beast::http::response<boost::beast::http::string_body>;

/// The head of the request. `parser` must have read it.
Head head_of(const Parser& parser);

/// Whether a proxy in front of this server reads the same bytes as the body. A proxy that reads Transfer-Encoding
/// differently would pass on a stranger's next request as the rest of this one (RFC 9112, section 6.3). The parser
/// rejects a request with both a length and chunks.
bool has_clear_length(const Parser& parser);

/// Adds the fields that every response has. They keep browsers from caching the response, guessing its type, framing it
/// and sending its address to other sites.
Message message_of(Response response, unsigned version);

/// The status for a request that could not be read; empty if the client is gone.
std::optional<int> status_of(const boost::system::error_code& error);

}  // namespace harness::serve
