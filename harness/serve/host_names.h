// Whether a request is meant for this server and comes from its own pages: what keeps other sites that the student's
// browser has open from using this one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/serve/exchange.h"

namespace harness::serve {

/// How the server can be reached.
struct Reach {
    bool loopback = true;            ///< only from this machine
    bool behind_proxy = false;       ///< requests come from a proxy that has the browser's address and a certificate
    std::vector<std::string> names;  ///< lower-case DNS names that browsers may know it by, beside localhost
};

/// Whether only this machine reaches what listens at `address`.
bool is_loopback(const std::string& address);

/// Host without its port, lower-case and without brackets; empty when it is neither a name nor an address.
std::string host_of(std::string_view host);

/// Against DNS rebinding, where a stranger's name leads to this machine: a name has to be one of `reach`'s. An address
/// can't be rebound; from loopback it has to be one of loopback's.
bool is_for_us(const Head& head, const Reach& reach);

/// Whether what changes something was sent by one of our own pages, or by no page at all. Browsers say in
/// Sec-Fetch-Site or in Origin where a request is from.
bool is_from_us(const Head& head, const Reach& reach);

/// By what a client is counted: the address of the connection; behind a proxy, what that put last into X-Forwarded-For,
/// as all before it is whatever the client wrote.
std::string client_address(const Head& head, const Reach& reach);

}  // namespace harness::serve
