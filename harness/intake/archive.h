// Reads untrusted archives: zip, and tar with or without gzip. Unpacks nothing to disk. Each is read in a process of
// its own (confined_child.h), and what that process says of it is checked like the archive itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "harness/intake/confined_child.h"
#include "harness/machine/bounded_file.h"

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

/// Limits of an archive's contents and of reading it. These are a class's: an honest class of a thousand has a few
/// thousand entries and some hundred megabytes.
struct ArchiveLimits {
    std::size_t entries = 20'000;
    std::uint64_t unpacked_bytes = std::uint64_t{4} << 30U;
    std::uint64_t kept_bytes = std::uint64_t{512} << 20U;
    std::size_t path_bytes = 1000;           ///< of one path
    std::size_t path_names = 32;             ///< folders of one path, and the file
    std::size_t all_path_bytes = 4'000'000;  ///< of all paths together
    ChildLimits reading{std::uint64_t{512} << 20U, std::chrono::seconds(60), std::chrono::seconds(600)};
};

/// The limits of one student's archive.
constexpr ArchiveLimits limits_of_a_student{
    .unpacked_bytes = std::uint64_t{1} << 30U,
    .kept_bytes = std::uint64_t{64} << 20U,
    .all_path_bytes = 2'000'000,
    .reading = {std::uint64_t{256} << 20U, std::chrono::seconds(5), std::chrono::seconds(60)},
};

/// Says how many bytes of a file are wanted, 0 for none. If the file has more, none are kept.
using Wanted = std::function<std::uint64_t(std::string_view path)>;

/// Whether the name is that of an archive: .zip, .tar, .tar.gz or .tgz in any case.
bool is_archive_name(std::string_view name);

/// Returns the files of an archive in its order, without folders, names that begin with a dot and files that macOS
/// adds. Throws ArchiveError, which names the entry, for paths that lead out of the archive (.., absolute), links,
/// devices, encrypted entries, and an archive beyond `limits`; HarnessError if this machine has no process or memory to
/// read it. Waits for no pipe. `links` is for the archive's own path. `shown` is the archive's name for messages.
std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, Links links, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});
std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});

}  // namespace harness
