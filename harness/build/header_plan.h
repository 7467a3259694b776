// Decides which precompiled headers to make for a class, before anything is compiled.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "harness/build/header_use.h"

namespace harness {

struct HeaderPlan {
    std::vector<HeaderLines> headers;  ///< the most used first
    /// For each block, the index in `headers` of the header that replaces a part of it; empty for none.
    std::vector<std::optional<std::size_t>> header_of;
};

/// `blocks`: the leading directives of each source. Sources with the same includes, in any order, and the same settings
/// share a header. It is made for four sources or more, because making it takes as long as it saves for 3.5 of them; a
/// kept one is used for any number.
HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks, const std::function<bool(const HeaderLines&)>& is_kept);

}  // namespace harness
