// What holds of every output, whatever its bytes.
#pragma once

#include <string>
#include <string_view>

/// Reads and matches `output`. Empty if all holds: each item once and in order, values of their items' shapes, lines
/// within the output, texts within their limits, every number of a kind with its item. Else the first that does not.
std::string check_transcript(std::string_view output);
