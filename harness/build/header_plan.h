// Decides which precompiled headers to make for a class, before anything is compiled.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "harness/build/header_use.h"

namespace harness {

struct HeaderPlan {
    std::vector<HeaderLines> headers;  ///< the most used first
    /// For each block, the index in `headers` of the header that replaces a part of it; empty if none pays off.
    std::vector<std::optional<std::size_t>> header_of;
};

/// Chooses headers that save much processor time over all `blocks`, the leading directives of each source. Sources that
/// include the same share a header, and so may sources that have only some includes in common. Making a header costs as
/// much as it saves for 3.5 sources; the headers in `made` exist already and cost nothing. Apart from the numbering,
/// the order of the blocks does not matter.
HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks, const std::set<HeaderLines>& made);

/// About how long the compiler takes to read these directives, in milliseconds on a quiet machine of 2022.
double reading_time_ms(const HeaderLines& lines);

}  // namespace harness
