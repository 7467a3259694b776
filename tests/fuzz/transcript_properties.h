// Properties that reading and matching have for every output, whatever its bytes.
#pragma once

#include <string>
#include <string_view>

/// Reads and matches `output`. Returns "" if every property holds: each item occurs once and in order, values have the
/// shapes of their items, lines lie within the output, texts stay within their limits, and every number's kind fits its
/// item. Otherwise returns the first property that fails.
std::string check_transcript(std::string_view output);
