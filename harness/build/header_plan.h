// Decides which precompiled headers to make for a class, before anything is compiled.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "harness/build/header_use.h"

namespace harness {

/// Sources are identified by their places in the class.
struct HeaderPlan {
    struct SharedHeader {
        HeaderLines lines;
        std::vector<std::size_t> sources;
    };
    std::vector<SharedHeader> headers;     ///< the most used first
    std::vector<std::size_t> without_one;  ///< all other sources
};

/// `wanted`: the lines of each source's header, empty for a source that wants none. A header is made for four sources
/// or more, because making it takes as long as it saves for 3.5 of them; a kept one is used for any number.
HeaderPlan plan_headers(const std::vector<HeaderLines>& wanted, const std::function<bool(const HeaderLines&)>& is_kept);

}  // namespace harness
