// Reading archives that strangers packed: zip, and tar with or without gzip. Nothing is unpacked to disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// The archive is broken, or it is made to harm: what() is a sentence that names the entry.
class ArchiveError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct ArchiveFile {
    std::string path;        ///< in the archive, its names joined by '/'; never "..", never absolute
    std::string bytes;       ///< empty where they were not wanted
    bool too_large = false;  ///< there were more bytes than wanted; they are not kept
};

/// What an archive may hold. An honest class of a thousand has a few thousand entries and some hundred megabytes.
struct ArchiveLimits {
    std::size_t entries = 20'000;
    std::uint64_t unpacked_bytes = std::uint64_t{4} << 30U;
    std::uint64_t kept_bytes = std::uint64_t{512} << 20U;
};

/// How many bytes of a file are wanted; 0 for none. Of one with more, none are kept.
using Wanted = std::function<std::uint64_t(std::string_view path)>;

/// Whether the name is that of an archive: .zip, .tar, .tar.gz or .tgz in any case.
bool is_archive_name(std::string_view name);

/// The files of an archive, in its order; folders, names that begin with a dot and what macOS adds are left out.
/// Refuses, with the entry named, what leaves the archive (.., absolute paths), links, devices, encrypted entries, and
/// more than `limits`. `shown` is the archive's name for messages. Throws ArchiveError.
std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});
std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});

}  // namespace harness
