// Tells before CBOR is parsed whether a parser that calls itself for each list within a list can take it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace harness {

/// Lists and maps within each other.
inline constexpr std::size_t deepest_cbor = 32;

/// Whether the bytes are one value of at most deepest_cbor levels, each list, map and text with its length before it
/// and without tags, as nlohmann::json::to_cbor writes. Takes linear time and little memory.
bool is_shallow_cbor(const std::vector<std::uint8_t>& bytes);

}  // namespace harness
