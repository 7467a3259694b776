// How browsers reach what this machine serves, for the person who starts it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace harness::serve {

/// The IP addresses of this machine by which others may reach it, those of IPv4 first; none of loopback, and none that
/// holds on one link alone, as browsers take no such address.
std::vector<std::string> own_addresses();

/// This machine's host name in lower case; empty where it has none that a browser could ask for.
std::string own_name();

/// "http://192.168.1.20:8080/".
std::string web_address(const std::string& host, std::uint16_t port);

/// What to open in a browser for what listens at the IP address `host`: for that of all, one web address for each of
/// this machine's. Never empty.
std::vector<std::string> web_addresses(const std::string& host, std::uint16_t port);

}  // namespace harness::serve
