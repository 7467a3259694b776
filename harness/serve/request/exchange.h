// Requests and responses, independent of the HTTP library.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace harness::serve {

enum class Method { get, head, post, other };

/// The request without its body. All text comes from the client: it may contain any bytes, at most as many as the
/// server reads. If a field appears several times, its values are joined by commas.
struct Head {
    Method method = Method::other;
    std::string path;  ///< without the query, not decoded; begins with '/' in a request that the site answers
    std::string host;  ///< empty if there is no Host field, or more than one
    std::optional<std::string> origin;  ///< Origin: the site of the page that sends the request
    std::string fetch_site;             ///< Sec-Fetch-Site
    std::string content_type;
    bool wants_json = false;  ///< the client asks for JSON, as scripts do
};

struct Response {
    int status = 200;
    std::string type;  ///< Content-Type
    std::string body;
    std::vector<std::pair<std::string, std::string>> fields{};  ///< in addition to those that every response has
};

}  // namespace harness::serve
