// Why a file of an LMS is refused.
#pragma once

#include <string>

#include "harness/report/exchange/roster.h"
#include "tests/given/message_of.h"

namespace harness::report {

/// The message of the RosterError that `read` throws.
template <typename Read>
std::string refusal(Read read) {
    return message_of<RosterError>(read, "no RosterError");
}

}  // namespace harness::report
