// The web addresses of this machine, for the person who starts the server.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace harness::serve {

/// The IP addresses at which other machines may reach this machine, IPv4 first. Leaves out loopback and link-local
/// addresses; browsers don't accept the latter.
std::vector<std::string> own_addresses();

/// This machine's host name in lower case; empty if it has no name that a browser could use.
std::string own_name();

/// "http://192.168.1.20:8080/".
std::string web_address(const std::string& host, std::uint16_t port);

/// The web addresses of a server that listens at the IP address `host`. If `host` means all addresses, there is one for
/// each address of this machine. Never empty.
std::vector<std::string> web_addresses(const std::string& host, std::uint16_t port);

}  // namespace harness::serve
