// A word of a command that is printed for a person to copy into a shell.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The word in single quotes. A line break stays the same.
std::string in_shell_quotes(std::string_view word);

/// The word as a shell reads it back: unchanged if it has no special meaning to a shell, else in quotes. Bytes that are
/// unsafe in a terminal are written as bash's $'\x1b'.
std::string shell_word(std::string_view word);

}  // namespace harness
