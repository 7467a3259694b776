// What an attacker may send to a server on one connection. The same seed gives the same attack.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace harness::serve {

/// Stands in everything hostile that a page might repeat. No page may hold it unescaped.
inline const std::string hostile_markup = "\"'><script>x7351()</script><img src=x7351 onerror=x7351()>";

/// What the attacker aims at.
struct Target {
    std::string host;     ///< the server's own name
    std::string result;   ///< a stranger's result, "/result/…"; only near misses of it are sent
    std::string planted;  ///< the path of a file of this machine that no answer may hold
    std::string program;  ///< a source that the server accepts; the same each time, so it is compiled once
};

struct HostileRequest {
    std::string what;   ///< the attack, for a test's message
    std::string bytes;  ///< of the whole connection
    /// The statuses that an answer may have. 0: the connection may end without an answer.
    std::set<int> statuses;
    std::size_t most_answers = 1;
    bool is_to_head = false;  ///< answers have no body
    bool is_upload = false;   ///< what is accepted leads to a result, whose page must show the hostile name as text
    bool is_damaged = false;  ///< any status below 500 is right, and any number of answers
    bool resets = false;      ///< the attacker resets the connection and reads nothing
};

/// How many attacks there are. The seeds below it give each once and undamaged.
std::uint32_t hostile_request_kinds();

/// Attack number `seed` modulo hostile_request_kinds(). Later seeds vary it, and every third round is also damaged:
/// bits flipped, cut off, parts repeated.
HostileRequest hostile_request(std::uint32_t seed, const Target& target);

}  // namespace harness::serve
