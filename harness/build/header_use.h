// Decides which part of a source a precompiled header may replace.
//
// A precompiled header contains those of the source's headers that take long to compile, <iostream> and <glm/glm.hpp>
// for most programs, so that nearly the whole class shares one. The standard headers and GLM's mean the same in any
// order, so these can come before the others. No header is added that the source does not include itself: a common set
// of headers forced into 22 programs changed 12 of them. A macro before a header could change it. So the settings that
// headers are known to read are part of the precompiled header, and a macro of the source's own, such as PI, ends the
// replaced part.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// Directives as in Directive::text, in order.
using HeaderLines = std::vector<std::string>;

struct HeaderUse {
    /// The header's directives: #define lines of macros that headers read, in order, then #include lines of slow
    /// headers, in angle brackets, sorted, each once. Empty if the source includes no slow header.
    HeaderLines lines;
    std::string rest;           ///< the source with these directives overwritten by blanks: each line and column stays
    std::size_t last_line = 0;  ///< of these directives, from 1
};

/// How a source uses a header. Directives after any other header, after a macro of the source's own or after a setting
/// that follows a header stay in the source.
HeaderUse header_use(std::string_view source);

}  // namespace harness
