// Checks that a request is meant for this server and comes from its own pages, so that other sites open in a student's
// browser can't use it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/serve/request/exchange.h"

namespace harness::serve {

/// How the server can be reached.
struct Reach {
    bool loopback = true;            ///< only this machine can reach it
    bool behind_proxy = false;       ///< requests come from a proxy with a certificate
    std::vector<std::string> names;  ///< lower-case DNS names of the server, besides localhost
};

/// Whether only this machine can reach a server that listens at `address`.
bool is_loopback(const std::string& address);

/// The Host field without port and brackets, in lower case; empty if it is neither a name nor an address.
std::string host_of(std::string_view host);

/// Prevents DNS rebinding, in which an attacker's DNS name leads to this machine: a name must be one of `reach`.
/// Addresses can't be rebound, so any is accepted, but only loopback addresses if the server is loopback-only, and none
/// behind a proxy.
bool is_for_us(const Head& head, const Reach& reach);

/// Whether a POST was sent by one of this server's pages or by no page at all. Browsers say in Sec-Fetch-Site or Origin
/// where a request comes from.
bool is_from_us(const Head& head, const Reach& reach);

}  // namespace harness::serve
