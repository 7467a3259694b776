#include "harness/serve/http/own_addresses.h"

#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/address.hpp>
#include <cstring>
#include <memory>
#include <optional>

#include "harness/serve/request/host_names.h"

namespace harness::serve {
namespace {

using boost::asio::ip::address;
using boost::asio::ip::address_v4;
using boost::asio::ip::address_v6;

std::optional<address> address_of(const sockaddr* found) {
    if (found == nullptr) return {};
    if (found->sa_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, found, sizeof v4);
        return address_v4(ntohl(v4.sin_addr.s_addr));
    }
    if (found->sa_family != AF_INET6) return {};
    sockaddr_in6 v6{};
    std::memcpy(&v6, found, sizeof v6);
    address_v6::bytes_type bytes;
    std::copy(std::begin(v6.sin6_addr.s6_addr), std::end(v6.sin6_addr.s6_addr), bytes.begin());
    return address_v6(bytes);
}

bool is_for_others(const address& one) {
    constexpr unsigned link_local_net = 0xa9fe;  // 169.254/16
    const bool on_one_link = one.is_v6() ? one.to_v6().is_link_local() : one.to_v4().to_uint() >> 16U == link_local_net;
    return !one.is_loopback() && !on_one_link;
}

}  // namespace

std::vector<std::string> own_addresses() {
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return {};
    const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, freeifaddrs);
    std::vector<address> found;
    for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
        const auto one = (each->ifa_flags & IFF_UP) != 0U ? address_of(each->ifa_addr) : std::nullopt;
        if (one && is_for_others(*one)) found.push_back(*one);
    }
    std::stable_partition(found.begin(), found.end(), [](const address& one) { return one.is_v4(); });
    std::vector<std::string> texts;
    for (const address& one : found) texts.push_back(one.to_string());
    return texts;
}

std::string own_name() {
    constexpr std::size_t longest = 256;
    std::array<char, longest> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return "";
    const std::string host = host_of(name.data());
    return is_loopback(host) ? "" : host;
}

std::string web_address(const std::string& host, std::uint16_t port) {
    const bool is_v6 = host.find(':') != std::string::npos;
    return fmt::format("http://{}{}{}:{}/", is_v6 ? "[" : "", host, is_v6 ? "]" : "", port);
}

std::vector<std::string> web_addresses(const std::string& host, std::uint16_t port) {
    boost::system::error_code error;
    const address at = boost::asio::ip::make_address(host, error);
    if (error || !at.is_unspecified()) return {web_address(host, port)};
    std::vector<std::string> all;
    for (const std::string& own : own_addresses()) {
        const bool is_v6 = own.find(':') != std::string::npos;
        if (at.is_v6() || !is_v6) all.push_back(web_address(own, port));
    }
    if (all.empty()) all.push_back(web_address(at.is_v6() ? "::1" : "127.0.0.1", port));
    return all;
}

}  // namespace harness::serve
