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

/// Prevents DNS rebinding, in which an attacker's DNS name points to this machine: a name must be in `reach`. Addresses
/// can't be rebound, so any address is accepted, except that a loopback-only server accepts only loopback addresses,
/// and a server behind a proxy accepts none.
bool is_for_us(const Head& head, const Reach& reach);

/// Whether a POST was sent by one of this server's pages or by no page at all. Browsers give the origin of a request in
/// Sec-Fetch-Site or Origin.
bool is_from_us(const Head& head, const Reach& reach);

}  // namespace harness::serve
