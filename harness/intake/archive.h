// Reads untrusted archives: zip, and tar with or without gzip. Unpacks nothing to disk. Each is read in a process of
// its own (confined_child.h), and what that process says of it is checked like the archive itself.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "harness/intake/archive_contents.h"
#include "harness/machine/bounded_file.h"

namespace harness {

/// Whether the name is that of an archive: .zip, .tar, .tar.gz or .tgz in any case, also handed in again
/// ("a.tar-1.gz").
bool is_archive_name(std::string_view name);

/// Returns the files of an archive in its order, without folders, names that begin with a dot and files that macOS
/// adds. Throws ArchiveError, which names the entry, for paths that lead out of the archive (.., absolute), links,
/// devices, encrypted entries, and an archive beyond `limits`; HarnessError if this machine has no process or memory to
/// read it. Waits for no pipe. `links` is for the archive's own path. `shown` is the archive's name for messages.
std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, Links links, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});
std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});

/// The same for a class, where an entry that is refused or beyond the limits costs its student alone, as far as its
/// path says whose it is (lms_owner.h): there is one ArchiveFile with the refusal, and nothing else of that student
/// counts.
std::vector<ArchiveFile> read_class_archive(const std::filesystem::path& file, const Wanted& wanted);

}  // namespace harness
