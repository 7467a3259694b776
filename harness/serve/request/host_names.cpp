#include "harness/serve/request/host_names.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cctype>

namespace harness::serve {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool is_port(std::string_view text) {
    constexpr std::size_t longest = 5;
    return text.size() <= longest && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_address(const std::string& host) {
    boost::system::error_code error;
    boost::asio::ip::make_address(host, error);
    return !error;
}

}  // namespace

bool is_loopback(const std::string& address) {
    boost::system::error_code error;
    const auto parsed = boost::asio::ip::make_address(address, error);
    return address == "localhost" || (!error && parsed.is_loopback());
}

std::string host_of(std::string_view host) {
    std::string_view name;
    if (host.starts_with('[')) {
        const auto end = host.find(']');
        if (end == std::string_view::npos) return {};
        name = host.substr(1, end - 1);
        host.remove_prefix(end + 1);
        if (!is_address(std::string(name)) || name.find(':') == std::string_view::npos) return {};
    } else {
        name = host.substr(0, host.find(':'));
        host.remove_prefix(name.size());
    }
    if (!host.empty() && (host.front() != ':' || !is_port(host.substr(1)))) return {};
    constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789-._:";
    std::string result = lower(name);
    if (result.find_first_not_of(allowed) != std::string::npos) return {};
    return result;
}

bool is_for_us(const Head& head, const Reach& reach) {
    const std::string host = host_of(head.host);
    if (host.empty()) return false;
    if (std::find(reach.names.begin(), reach.names.end(), host) != reach.names.end()) return true;
    if (reach.behind_proxy) return false;
    return is_loopback(host) || (!reach.loopback && is_address(host));
}

bool is_from_us(const Head& head, const Reach& reach) {
    if (!head.fetch_site.empty() && head.fetch_site != "same-origin" && head.fetch_site != "none") return false;
    if (!head.origin) return true;  // browsers always send Origin with a POST
    const std::string origin = lower(*head.origin);
    const std::string host = lower(head.host);
    return origin == "http://" + host || (reach.behind_proxy && origin == "https://" + host);
}

}  // namespace harness::serve
