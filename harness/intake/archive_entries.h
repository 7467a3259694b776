// Reads an archive's entries with libarchive, in the child process of archive.cpp.
#pragma once

#include <string>
#include <string_view>

#include "harness/intake/archive_contents.h"
#include "harness/intake/member_pipe.h"

namespace harness {

/// An archive as an open file, or as bytes if the descriptor is negative.
struct OpenArchive {
    int descriptor = -1;
    std::string_view bytes;
    std::string shown;  ///< its name for messages, printable and in quotes
};

/// Sends the files of the archive. Throws ArchiveError as read_archive does, and std::bad_alloc.
void send_entries(const OpenArchive& opened, const Wanted& wanted, const ArchiveLimits& limits, Shares shares,
                  MemberSender& sender);

/// A name from an archive for a message: printable, in quotes and not too long.
std::string name_in_quotes(std::string_view name);

}  // namespace harness
