// A word of a command that is printed for a person to copy into a shell.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The word in single quotes. A line break stays as it is.
std::string in_shell_quotes(std::string_view word);

/// The word as a shell reads it back: unchanged where nothing in it means anything to a shell, else in quotes. Bytes
/// that a terminal may not get are written as bash's $'\x1b'.
std::string shell_word(std::string_view word);

}  // namespace harness
