#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "harness/text/escape.h"

namespace harness {

/// Writes a message to stderr. Unlike fmt::print it does not throw if stderr can't be written to, e.g. because it is a
/// log on a full disk: a lost message must not stop the work.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = fmt::format(format, std::forward<Args>(args)...);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

/// Writes an error's message to stderr. It may quote strangers' text, so its control characters are escaped.
inline void complain(const std::exception& error) {
    say("raygrade: {}\n", escape_control(error.what()));
}

}  // namespace harness
