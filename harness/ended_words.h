// How a run ended, as the databases have it: words that stay as they are once they were written.
#pragma once

#include <optional>
#include <string_view>

#include "harness/sandbox/process.h"

namespace harness {

std::string_view word_for(Ended ended);

/// Empty for a word that is none of them.
std::optional<Ended> ended_from(std::string_view word);

}  // namespace harness
