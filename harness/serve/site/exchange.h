// What a browser asks and what it gets, apart from how that travels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace harness::serve {

enum class Method { get, head, post, other };

/// What comes before the body. All text is the client's: any bytes, at most as many as the server reads.
struct Head {
    Method method = Method::other;
    std::string path;                   ///< begins with '/', without the query; not decoded
    std::string host;                   ///< empty when there is none, or more than one
    std::string client;                 ///< the address the connection came from
    std::string forwarded_for;          ///< X-Forwarded-For, all of them in order, joined by commas
    std::optional<std::string> origin;  ///< of the page that asks
    std::string fetch_site;             ///< Sec-Fetch-Site
    std::string content_type;
    bool wants_json = false;  ///< a script asks
};

struct Response {
    int status = 200;
    std::string type;  ///< Content-Type
    std::string body;
    std::vector<std::pair<std::string, std::string>> fields{};  ///< beside those that every response has
};

}  // namespace harness::serve
