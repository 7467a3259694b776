// Reading one file that anybody may have left: it may be huge, unreadable, a pipe that never ends or a link to
// somewhere else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace harness {

/// Whether a symbolic link is read through: yes for a path a person typed, no for what lies in a student's folder.
enum class Links { follow, refuse };

/// What a file holds, or why it could not be read.
struct BoundedFile {
    std::string bytes;        ///< the first ones, as many as were asked for
    bool has_more = false;    ///< there were more
    bool is_special = false;  ///< it is a folder, pipe or device, of which nothing is read
    int error = 0;            ///< errno where it could not be read, ELOOP for a link that is refused; else 0

    bool is_whole() const { return !has_more && !is_special && error == 0; }
};

/// Never blocks, and never holds more than `most` bytes and one.
BoundedFile read_bounded(const std::filesystem::path& file, std::uintmax_t most, Links links);

/// Why a file is not whole, for a message: "it is larger than 64 MiB". `most` is what was asked for.
std::string why_not_whole(const BoundedFile& file, std::uintmax_t most);

}  // namespace harness
