#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/address.hpp>

#include "harness/intake/not_a_source.h"
#include "harness/intake/source_file.h"
#include "harness/serve/http/http_message.h"
#include "harness/serve/http/server_limits.h"
#include "harness/serve/request/host_names.h"
#include "harness/serve/site/form.h"
#include "harness/text/printable.h"
#include "tests/fuzz/properties.h"

namespace {

using namespace harness::serve;

/// What reading a request came to.
struct Request {
    Head head;
    bool has_head = false;
    bool is_whole = false;
    std::string body;
    std::optional<int> status;  ///< of a request that can't be read
};

/// Reads the request as it arrives: in one piece, or the first `piece` bytes and then one at a time.
Request read(std::string_view bytes, std::size_t piece) {
    const ServerLimits limits;
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(limits.head_bytes));
    parser.body_limit(limits.body_bytes);
    boost::system::error_code error;
    std::string arrived;
    std::size_t at = 0;
    while (at < bytes.size() && !parser.is_done() && !error) {
        arrived += bytes.substr(at, at == 0 ? piece : 1);
        at += at == 0 ? std::min(piece, bytes.size()) : 1;
        for (std::size_t taken = 1; taken > 0 && !arrived.empty() && !parser.is_done() && !error;) {
            taken = parser.put(boost::asio::buffer(arrived), error);
            if (error == boost::beast::http::error::need_more) error = {};
            arrived.erase(0, taken);
        }
    }
    Request request{head_of(parser), parser.is_header_done(), parser.is_done(), parser.get().body(), {}};
    if (error) request.status = status_of(error);
    return request;
}

bool is_same(const Head& one, const Head& other) {
    return one.method == other.method && one.path == other.path && one.host == other.host &&
           one.origin == other.origin && one.fetch_site == other.fetch_site && one.content_type == other.content_type &&
           one.wants_json == other.wants_json;
}

bool is_address(const std::string& text) {
    boost::system::error_code error;
    boost::asio::ip::make_address(text, error);
    return !error;
}

bool is_lower_case(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string check_head(const Head& head) {
    if (head.path.find_first_of("?#") != std::string::npos) return "a path with a query";
    for (const std::string& text : {head.path, head.host, head.fetch_site, head.content_type}) {
        if (text.find_first_of("\r\n") != std::string::npos || text.find('\0') != std::string::npos)
            return "a field with a line's end in it";
    }
    const std::string host = host_of(head.host);
    if (!is_lower_case(host) || host.find_first_of(" /@\\") != std::string::npos) return "a host that is none: " + host;
    if (!host.empty() && host_of(host) != host && host.find(':') == std::string::npos)
        return "a host that is another without its port";
    const Reach of_this_machine{true, false, {}};
    const Reach of_a_name{false, false, {"ray.example.edu"}};
    const Reach of_a_proxy{false, true, {"ray.example.edu"}};
    if (is_for_us(head, of_this_machine) && !is_loopback(host)) return "a foreign name for this machine: " + host;
    if (is_for_us(head, of_a_name) && host != "ray.example.edu" && host != "localhost" && !is_address(host))
        return "a foreign name for this server: " + host;
    if (is_for_us(head, of_a_proxy) && host != "ray.example.edu") return "a foreign name behind a proxy: " + host;
    for (const Reach& reach : {of_this_machine, of_a_name, of_a_proxy}) {
        const bool is_foreign = head.fetch_site == "cross-site" || head.origin == "null";
        if (is_foreign && is_from_us(head, reach)) return "a foreign page that counts as ours";
    }
    return {};
}

std::string check_source_of(const HandedIn& handed, std::string_view body) {
    constexpr std::size_t longest_name = 100;
    if (!handed.problem.empty()) return handed.source.empty() ? "" : "a program in spite of a problem";
    if (handed.source.size() > harness::largest_source_bytes) return "a program beyond the limit";
    if (!harness::why_no_source(handed.source).empty()) return "a program that is none";
    if (handed.file.empty() || handed.file.size() > longest_name || handed.file != harness::printable(handed.file))
        return "a file's name that is none: " + handed.file;
    const bool is_of_body = body.find(handed.source) != std::string_view::npos || handed.file == "pasted text";
    return is_of_body ? "" : "a program that was not sent";
}

HandedIn sent(std::string_view disposition, std::string_view content) {
    return source_of("multipart/form-data; boundary=X", "--X\r\nContent-Disposition: form-data; name=\"source\"" +
                                                            std::string(disposition) + "\r\n\r\n" +
                                                            std::string(content) + "\r\n--X--\r\n");
}

/// Sends the text as a file and pastes it, as browsers do.
std::string check_sent(std::string_view text) {
    if (text.find("\n--X") != std::string_view::npos || !harness::why_no_source(text).empty()) return {};
    const HandedIn file = sent("; filename=\"a b.cpp\"", text);
    if (!file.problem.empty()) return "a program is refused: " + file.problem;
    if (file.source != text || file.file != "a b.cpp") return "a program comes out otherwise than it was sent";
    if (text.find('\r') != std::string_view::npos) return {};
    std::string pasted;
    for (const char c : text) pasted += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return sent("", pasted).source == text ? "" : "a program comes out otherwise than it was pasted";
}

std::string check_form(const std::string& content_type, std::string_view body) {
    if (const auto boundary = boundary_of(content_type)) {
        if (const auto parts = parts_of(body, *boundary)) {
            for (const Part& part : *parts) {
                if (part.name.empty()) return "a part without a name";
                if (part.content.find("\r\n--" + *boundary) != std::string_view::npos)
                    return "a part that goes on behind its end";
                const bool is_inside =
                    part.content.empty() || (part.content.data() >= body.data() &&
                                             part.content.data() + part.content.size() <= body.data() + body.size());
                if (!is_inside) return "a part beyond the body";
            }
        }
    }
    return check_source_of(source_of(content_type, body), body);
}

}  // namespace

std::string check_http(std::string_view bytes) {
    const Request whole = read(bytes, bytes.size());
    if (std::string broken = check_head(whole.head); !broken.empty()) return broken;
    for (const std::size_t piece : {std::size_t{1}, bytes.size() / 2}) {
        const Request pieces = read(bytes, std::max<std::size_t>(piece, 1));
        if (pieces.has_head != whole.has_head || (whole.has_head && !is_same(pieces.head, whole.head)))
            return "a head that depends on the pieces in which it arrives";
        if (pieces.is_whole != whole.is_whole || (whole.is_whole && pieces.body != whole.body))
            return "a body that depends on the pieces in which it arrives";
    }
    if (whole.is_whole) {
        if (std::string broken = check_form(whole.head.content_type, whole.body); !broken.empty()) return broken;
    }
    // Without a head, the bytes are a body of the form that the tests send.
    if (std::string broken = check_form("multipart/form-data; boundary=X", bytes); !broken.empty()) return broken;
    return check_sent(bytes);
}
