// What a precompiled header may replace in a source.
//
// The standard's headers and GLM's mean the same in any order, so sources that include the same in any order share a
// header. It holds nothing that the source does not include itself: of 22 programs, a common set of headers forced into
// them changed 12. A macro before a header could change it. So the settings, which headers are known to read, are part
// of the precompiled header, and a macro of the source's own, such as PI, ends what the header replaces.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// Directives as in Directive::text, in order.
using HeaderLines = std::vector<std::string>;

struct HeaderUse {
    /// The header's: #define lines of macros that headers read, in order, then #include lines of headers that mean the
    /// same in any order, in angle brackets, sorted, each once. Empty if there is nothing to include.
    HeaderLines lines;
    std::string rest;           ///< the source with these directives overwritten by blanks: each line and column stays
    std::size_t last_line = 0;  ///< of these directives, from 1
};

/// How a source uses a header. What follows another header, a macro of the source's own or a setting behind a header is
/// left in the source.
HeaderUse header_use(std::string_view source);

}  // namespace harness
