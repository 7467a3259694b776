// Why a file of an LMS is refused.
#pragma once

#include <string>

#include "harness/report/exchange/roster.h"

namespace harness::report {

/// The message of the RosterError that `read` throws.
template <typename Read>
std::string refusal(Read read) {
    try {
        read();
    } catch (const RosterError& error) {
        return error.what();
    }
    return "no RosterError";
}

}  // namespace harness::report
