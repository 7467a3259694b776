#include "harness/machine/bounded_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "harness/machine/file_descriptor.h"

namespace harness {

BoundedFile read_bounded(const std::filesystem::path& path, std::uintmax_t most, Links links) {
    BoundedFile result;
    // Without O_NONBLOCK, opening a FIFO waits for its writer.
    const int flags = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | (links == Links::refuse ? O_NOFOLLOW : 0);
    const FileDescriptor file(open(path.c_str(), flags));
    struct stat info {};
    if (!file || fstat(file.get(), &info) != 0) {
        result.error = errno;
        return result;
    }
    if (!S_ISREG(info.st_mode)) {
        result.is_special = true;
        return result;
    }
    // One byte more than wanted, to see whether the file is longer. If the file grows meanwhile, reading continues.
    const std::uintmax_t enough = most + 1;
    std::string& bytes = result.bytes;
    bytes.resize(static_cast<std::size_t>(std::min(static_cast<std::uintmax_t>(info.st_size) + 1, enough)));
    std::size_t size = 0;
    while (size < enough) {
        if (size == bytes.size()) bytes.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(2 * size, enough)));
        const ssize_t got = read(file.get(), bytes.data() + size, bytes.size() - size);
        if (got == 0) break;
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            result.error = errno;
            break;
        }
        size += static_cast<std::size_t>(got);
    }
    result.has_more = size > most;
    bytes.resize(std::min(size, static_cast<std::size_t>(most)));
    bytes.shrink_to_fit();
    return result;
}

std::string why_not_whole(const BoundedFile& file, std::uintmax_t most) {
    if (file.error != 0) return std::generic_category().message(file.error);
    if (file.is_special) return "it is a folder, pipe or device";
    const bool in_mebibytes = most % (std::uintmax_t{1} << 20U) == 0;
    return in_mebibytes ? fmt::format("it is larger than {} MiB", most >> 20U)
                        : fmt::format("it is larger than {} bytes", most);
}

}  // namespace harness
