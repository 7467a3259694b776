// Reads untrusted archives: zip, and tar with or without gzip. Unpacks nothing to disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// The archive is broken or malicious. what() is a sentence that names the entry.
class ArchiveError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct ArchiveFile {
    std::string path;        ///< within the archive, with '/' between names; never with "..", never absolute
    std::string bytes;       ///< empty if they were not wanted
    bool too_large = false;  ///< it has more bytes than wanted; none are kept
};

/// Limits of an archive's contents. An honest class of a thousand has a few thousand entries and some hundred
/// megabytes.
struct ArchiveLimits {
    std::size_t entries = 20'000;
    std::uint64_t unpacked_bytes = std::uint64_t{4} << 30U;
    std::uint64_t kept_bytes = std::uint64_t{512} << 20U;
};

/// Says how many bytes of a file are wanted, 0 for none. If the file has more, none are kept.
using Wanted = std::function<std::uint64_t(std::string_view path)>;

/// Whether the name is that of an archive: .zip, .tar, .tar.gz or .tgz in any case.
bool is_archive_name(std::string_view name);

/// Returns the files of an archive in its order, without folders, names that begin with a dot and files that macOS
/// adds. Throws ArchiveError, which names the entry, for paths that lead out of the archive (.., absolute), links,
/// devices, encrypted entries, and an archive beyond `limits`. `shown` is the archive's name for messages.
std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});
std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});

}  // namespace harness
