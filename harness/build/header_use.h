// What a precompiled header may replace in a source.
//
// The standard's headers and GLM's mean the same in any order, so a header replaces them wherever they stand among the
// source's leading directives, and between whatever others. It holds nothing that the source does not include itself:
// of 22 programs, a common set of headers forced into them changed 12. A macro before a header could change it. So the
// settings, which headers are known to read, are part of the precompiled header; and of a macro of the source's own,
// such as PI, g++ proves that the header does not mention it, or refuses the header.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/build/include_block.h"

namespace harness {

/// Directives as in Directive::text, in order.
using HeaderLines = std::vector<std::string>;

HeaderLines header_lines(const std::vector<Directive>& block);

/// The directives that precompiled headers may replace in a source.
struct HeaderParts {
    HeaderLines settings;  ///< #define lines of macros that headers read, in order
    HeaderLines includes;  ///< of headers that mean the same in any order: in angle brackets, sorted, each once

    friend bool operator==(const HeaderParts&, const HeaderParts&) = default;
};

/// The parts of a source's leading directives. What follows another header, a setting behind a header, or a very long
/// macro is left out.
HeaderParts header_parts(const HeaderLines& directives);

/// A header's lines: its settings, then its includes.
HeaderLines lines_of(const HeaderParts& parts);

struct Macro {
    std::string name;
    std::string option;  ///< "-DSQUARE(x)= x*x": the option of the compiler that defines it
};

/// A precompiled header in place of some of a source's leading directives.
struct HeaderUse {
    std::vector<std::size_t> replaced;  ///< the places of the directives that it replaces, in order
    std::vector<Macro> own_macros;      ///< that the source defines before the last of these
};

/// Empty if a source with these leading directives does not include all that the header holds, or has other settings.
std::optional<HeaderUse> use_of_header(const HeaderLines& header, const HeaderLines& directives);

}  // namespace harness
