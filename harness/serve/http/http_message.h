// Between HTTP as Boost.Beast reads and writes it and exchange.h.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>
#include <string>

#include "harness/serve/exchange.h"

namespace harness::serve {

using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
using Message = boost::beast::http::response<boost::beast::http::string_body>;

/// Of a parser that has read the head. `client` is the address of the connection.
Head head_of(const Parser& parser, const std::string& client);

/// With the fields that every response has: nothing of it is kept by browsers, guessed at, framed or told to others.
Message message_of(Response response, unsigned version, bool keep_alive);

/// The status that answers what could not be read; empty where the client is gone and there is nobody to answer.
std::optional<int> status_of(const boost::system::error_code& error);

}  // namespace harness::serve
