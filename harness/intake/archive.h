// Reads untrusted archives: zip, and tar with or without gzip. Unpacks nothing to disk. Each archive is read in its own
// process (confined_child.h), whose messages are checked like the archive itself.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "harness/intake/archive_contents.h"
#include "harness/machine/bounded_file.h"

namespace harness {

/// Whether the name is an archive's: .zip, .tar, .tar.gz or .tgz in any case, also with a resubmission's number
/// ("a.tar-1.gz").
bool is_archive_name(std::string_view name);

/// Returns the files of an archive in its order, without folders, names that begin with a dot and files that macOS
/// adds. Throws ArchiveError, which names the entry, for paths that lead out of the archive (.., absolute), links,
/// devices, encrypted entries, and an archive beyond `limits`; HarnessError if this machine lacks a process or memory
/// to read it. Never waits for a pipe. `links` applies to the archive's own path. `shown` is the archive's name in
/// messages.
std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, Links links, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});
std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits = {});

/// Same for a class's archive. If an entry is refused or beyond the limits, only its student is refused, if its path
/// identifies the student (lms_owner.h): the result has one ArchiveFile with the refusal and no other files of that
/// student.
std::vector<ArchiveFile> read_class_archive(const std::filesystem::path& file, const Wanted& wanted);

}  // namespace harness
