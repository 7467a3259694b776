#include "harness/intake/archive.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "harness/intake/archive_entries.h"
#include "harness/intake/confined_child.h"
#include "harness/intake/lms/lms_name.h"
#include "harness/intake/member_pipe.h"
#include "harness/machine/file_descriptor.h"
#include "harness/text/lower_case.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

FileDescriptor open_file(const std::filesystem::path& file, Links links) {
    // Without O_NONBLOCK, opening a FIFO waits for its writer.
    FileDescriptor opened(
        open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | (links == Links::refuse ? O_NOFOLLOW : 0)));
    struct stat info {};
    if (!opened || fstat(opened.get(), &info) != 0) {
        throw ArchiveError(
            fmt::format("Cannot open {}: {}.", in_quotes(file.filename()), std::generic_category().message(errno)));
    }
    if (!S_ISREG(info.st_mode)) {
        throw ArchiveError(in_quotes(file.filename()) +
                           " is a folder, pipe or device, not an archive. Put the archive itself there.");
    }
    return opened;
}

std::vector<ArchiveFile> read(const OpenArchive& opened, const Wanted& wanted, const ArchiveLimits& limits,
                              Shares shares) {
    ConfinedChild child(limits.reading, opened.descriptor, [&](int pipe) {
        MemberSender sender(pipe);
        try {
            send_entries(opened, wanted, limits, shares, sender);
            sender.finish();
        } catch (const ArchiveError& error) {
            sender.refuse(error.what());
        }
    });
    return receive_members(child, opened.shown, wanted, shares == Shares::none ? limits : limits_of_a_class);
}

}  // namespace

bool is_archive_name(std::string_view name) {
    const std::string small = lower_case(read_base_name(name).name);
    const std::array endings = {".zip", ".tar", ".tar.gz", ".tgz"};
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return small.ends_with(ending); });
}

std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, Links links, const Wanted& wanted,
                                      const ArchiveLimits& limits) {
    const FileDescriptor opened = open_file(file, links);
    return read({opened.get(), {}, in_quotes(file.filename())}, wanted, limits, Shares::none);
}

std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits) {
    return read({-1, bytes, name_in_quotes(shown)}, wanted, limits, Shares::none);
}

std::vector<ArchiveFile> read_class_archive(const std::filesystem::path& file, const Wanted& wanted) {
    const FileDescriptor opened = open_file(file, Links::follow);
    return read({opened.get(), {}, in_quotes(file.filename())}, wanted, {}, Shares::of_students);
}

}  // namespace harness
