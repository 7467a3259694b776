// The literal #define and #include lines a source begins with: what a precompiled header may stand for.
//
// A precompiled header must never change what a source means, so nothing is taken that was not written there in this
// order, and where in doubt nothing is taken. The rules are those of a study that compared 22 programs: a bundle of
// headers forced into them changed 12, their own leading block none.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// One directive of the block.
struct Directive {
    std::string text;   ///< with blanks in one form and without the comment behind it, e.g. "#include <cmath>"
    std::size_t begin;  ///< where it stands in the source: from its '#'
    std::size_t end;    ///< to behind its last character that is no blank
};

/// The source's leading directives, in order; comments and empty lines may stand between. Only plain ones are taken: no
/// directive or comment goes on in the next line by a backslash, no #define holds a literal, each #include names a
/// header of the system (in angle brackets, or in quotes with a folder, such as "glm/glm.hpp"). The first anything else
/// ends the block. Empty when the source asks where it is or how often (__COUNTER__, __FILE__, __DATE__ and the like)
/// or has a pragma: then an included header could see a difference.
std::vector<Directive> include_block(std::string_view source);

/// The source with its block's first `count` directives overwritten by blanks, so that every line and column stays.
std::string without_directives(std::string_view source, const std::vector<Directive>& block, std::size_t count);

}  // namespace harness
