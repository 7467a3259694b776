// Reads one untrusted file: it may be huge, unreadable, an endless pipe or a link to another place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace harness {

/// Whether to follow a symbolic link: yes for a path a person typed, no for a file in a student's folder.
enum class Links { follow, refuse };

/// The contents of a file, or why it could not be read.
struct BoundedFile {
    std::string bytes;        ///< the first bytes, at most the requested number
    bool has_more = false;    ///< the file is longer
    bool is_special = false;  ///< it is a folder, pipe or device; nothing was read
    int error = 0;            ///< errno if it could not be read (ELOOP for a refused link), else 0

    bool is_whole() const { return !has_more && !is_special && error == 0; }
};

/// Never blocks, and never keeps more than `most` + 1 bytes.
BoundedFile read_bounded(const std::filesystem::path& file, std::uintmax_t most, Links links);

/// Why a file was not read in full, for a message: "it is larger than 64 MiB". `most` is the limit given to
/// read_bounded.
std::string why_not_whole(const BoundedFile& file, std::uintmax_t most);

}  // namespace harness
