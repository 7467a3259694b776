// Reads what a server sent on a connection, and judges it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/given/serve/hostile_requests.h"

namespace scenario {

struct Answer {
    int status = 0;
    std::map<std::string, std::string> fields;  ///< by name in lower case
    std::string body;
};

struct Answers {
    std::vector<Answer> all;
    std::string problem;  ///< why the bytes are no sequence of whole answers; else empty
};

Answers answers_in(std::string_view received, bool to_head);

/// Which of these texts stands in the bytes; empty if none does.
std::string told(std::string_view received, const std::vector<std::string>& secrets);

/// What is wrong with a page or another answer, whoever asked for it: a field that is missing or that nobody sets,
/// markup of a stranger that is not escaped, control bytes, no UTF-8. Empty if nothing is.
std::string wrong_with(const Answer& answer);

/// What is wrong with what the server sent to an attacker; empty if nothing is.
std::string wrong_with(const std::string& received, const harness::serve::HostileRequest& attack,
                       const std::vector<std::string>& secrets);

}  // namespace scenario
