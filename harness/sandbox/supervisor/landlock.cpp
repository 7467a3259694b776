#include "harness/sandbox/supervisor/landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "harness/machine/file_descriptor.h"

namespace harness {
namespace {

// The kernel's definitions, because Debian 12's headers end at version 2.
struct RulesetAttributes {
    std::uint64_t files;
    std::uint64_t network;  // since version 4
    std::uint64_t scopes;   // since version 6
};
constexpr std::uint64_t refer = 1U << 13U;         // since version 2
constexpr std::uint64_t truncate = 1U << 14U;      // since version 3
constexpr std::uint64_t device_ioctl = 1U << 15U;  // since version 5
constexpr std::uint64_t bind_and_connect = 3U;
constexpr std::uint64_t abstract_sockets_and_signals = 3U;

constexpr std::uint64_t execute_and_read =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t of_a_file =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | truncate;

std::uint64_t all_accesses(int version) {
    std::uint64_t all = refer - 1;
    if (version >= 2) all |= refer;
    if (version >= 3) all |= truncate;
    if (version >= 5) all |= device_ioctl;
    return all;
}

FileDescriptor make_ruleset(int version) {
    RulesetAttributes attributes{};
    attributes.files = all_accesses(version);
    std::size_t size = sizeof attributes.files;
    if (version >= 4) {
        attributes.network = bind_and_connect;
        size += sizeof attributes.network;
    }
    if (version >= 6) {
        attributes.scopes = abstract_sockets_and_signals;
        size += sizeof attributes.scopes;
    }
    return FileDescriptor(static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, size, 0)));
}

bool allow(int ruleset, const std::string& path, std::uint64_t accesses) {
    const FileDescriptor file(open(path.c_str(), O_PATH | O_CLOEXEC));
    if (!file) return errno == ENOENT;
    struct stat info {};
    if (fstat(file.get(), &info) != 0) return false;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = S_ISDIR(info.st_mode) ? accesses : accesses & of_a_file;
    rule.parent_fd = file.get();
    return syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

int landlock_version() {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? static_cast<int>(version) : 0;
}

bool restrict_files(const std::vector<std::string>& readable, const std::vector<std::string>& writable) {
    const int version = landlock_version();
    if (version == 0) {
        errno = ENOSYS;
        return false;
    }
    const FileDescriptor ruleset = make_ruleset(version);
    if (!ruleset) return false;
    for (const auto& path : readable) {
        if (!allow(ruleset.get(), path, execute_and_read)) return false;
    }
    for (const auto& path : writable) {
        if (!allow(ruleset.get(), path, all_accesses(version))) return false;
    }
    return syscall(SYS_landlock_restrict_self, ruleset.get(), 0) == 0;
}

}  // namespace harness
