// Decides which part of a source a precompiled header may replace.
//
// The standard headers and GLM's mean the same in any order, so sources that include the same headers in any order
// share one. A precompiled header contains only headers that the source includes itself: a common set of headers forced
// into 22 programs changed 12 of them. A macro before a header could change it. So the settings that headers are known
// to read are part of the precompiled header, and a macro of the source's own, such as PI, ends the replaced part.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// Directives as in Directive::text, in order.
using HeaderLines = std::vector<std::string>;

struct HeaderUse {
    /// The header's directives: #define lines of macros that headers read, in order, then #include lines of headers
    /// that mean the same in any order, in angle brackets, sorted, each once. Empty if there is nothing to include.
    HeaderLines lines;
    std::string rest;           ///< the source with these directives overwritten by blanks: each line and column stays
    std::size_t last_line = 0;  ///< of these directives, from 1
};

/// How a source uses a header. Directives after any other header, after a macro of the source's own or after a setting
/// that follows a header stay in the source.
HeaderUse header_use(std::string_view source);

}  // namespace harness
