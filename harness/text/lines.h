// A text line by line.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace harness {

/// The lines of `text`, at most `most` of them, without the "\n" that ends each. The last may have none. They are valid
/// as long as `text` is.
std::vector<std::string_view> lines_of(std::string_view text, std::size_t most = std::string_view::npos);

}  // namespace harness
