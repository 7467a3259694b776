// A date with its time, as in an assignment's `due` and a table of hand-ins.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace reference {

struct Moment {
    std::int64_t minutes;  ///< since 1970, in UTC if `has_zone`, else by the writer's clock
    bool has_zone;
    std::int64_t offset = 0;  ///< minutes that the zone's clock is ahead of UTC
};

/// Reads "2026-11-05 23:59", also with T for the blank, with seconds, which are left out, and with a time zone: Z, UTC,
/// +01:00 or +0100, perhaps after a blank. Empty for anything else and for a day or time that does not exist.
std::optional<Moment> parse_moment(std::string_view text);

/// Whether the clock is past the minute of `moment`; without a zone, `moment` is by this machine's clock.
bool is_over(const Moment& moment, std::chrono::system_clock::time_point clock);

}  // namespace reference
