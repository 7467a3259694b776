// Which precompiled headers a class is worth, before anything is compiled.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace harness {

/// The directives a precompiled header stands for, in order, as in Directive::text.
using HeaderLines = std::vector<std::string>;

struct HeaderPlan {
    std::vector<HeaderLines> headers;  ///< the most used first
    /// For each block, the header that stands for its beginning: an index in `headers`; empty where none pays.
    std::vector<std::optional<std::size_t>> header_of;
};

/// The headers that save the most computing over all `blocks`, the leading directives of each source. A header stands
/// for a source's whole block or the beginning of it, so sources that begin alike may share one. To make one costs as
/// much as 3.5 sources save by it; one of those `made` before costs nothing. The same for the same blocks in any order,
/// but for the numbering.
HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks, const std::set<HeaderLines>& made);

/// About how long the compiler takes to read these directives, in milliseconds on a quiet machine of 2022.
double reading_time_ms(const HeaderLines& lines);

}  // namespace harness
