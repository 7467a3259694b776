// The contents read from an archive, and their limits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "harness/intake/confined_child.h"

namespace harness {

/// The archive is broken or malicious. what() is a sentence that names the entry.
class ArchiveError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct ArchiveFile {
    std::string path;        ///< within the archive, with '/' between names; never with "..", never absolute
    std::string bytes;       ///< empty if not wanted
    bool too_large = false;  ///< it has more bytes than wanted; none are kept
    /// Why nothing of a student in a class's archive was read, as a sentence; else empty. `path` is then the student's
    /// folder or, in a download without folders, one of the student's files.
    std::string refusal{};
    bool is_folder = false;  ///< true only with a refusal
};

/// Limits of an archive's contents and of reading it. The defaults are for entries whose path does not identify a
/// student.
struct ArchiveLimits {
    std::size_t entries = 20'000;
    std::uint64_t unpacked_bytes = std::uint64_t{4} << 30U;
    std::uint64_t kept_bytes = std::uint64_t{512} << 20U;
    std::size_t path_bytes = 1000;           ///< per path
    std::size_t path_names = 32;             ///< folders in a path, plus the file
    std::size_t all_path_bytes = 4'000'000;  ///< all paths together
    ChildLimits reading{std::uint64_t{512} << 20U, std::chrono::seconds(60), std::chrono::seconds(600)};
};

/// The limits of one student's archive.
constexpr ArchiveLimits limits_of_a_student{
    .unpacked_bytes = std::uint64_t{1} << 30U,
    .kept_bytes = std::uint64_t{64} << 20U,
    .all_path_bytes = 2'000'000,
    .reading = {std::uint64_t{256} << 20U, std::chrono::seconds(5), std::chrono::seconds(60)},
};

/// The limits of one student's files in a class's archive, if the system has unpacked them there.
constexpr ArchiveLimits limits_of_a_share{
    .unpacked_bytes = std::uint64_t{1} << 30U,
    .kept_bytes = std::uint64_t{32} << 20U,
    .all_path_bytes = 2'000'000,
};

/// The limits of a class's whole archive, including all students' files.
constexpr ArchiveLimits limits_of_a_class{
    .entries = 400'000,
    .unpacked_bytes = std::uint64_t{256} << 30U,
    .kept_bytes = std::uint64_t{1} << 30U,
    .all_path_bytes = 100'000'000,
};

/// Returns how many bytes of a file are wanted, 0 for none. If the file has more, none are kept.
using Wanted = std::function<std::uint64_t(std::string_view path)>;

}  // namespace harness
