#include "harness/intake/archive.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "harness/text/printable.h"
#include "tests/fuzz/properties.h"
#include "tests/given/packed.h"

namespace {

using harness::ArchiveFile;

constexpr harness::ArchiveLimits limits{50, 1 << 20, 100'000};
constexpr std::uint64_t most_of_a_file = 50'000;

/// What reading came to: the files, or the sentence why not.
struct Read {
    std::vector<ArchiveFile> files;
    std::string why_not;
};

Read read(std::string_view bytes, const harness::Wanted& wanted) {
    try {
        return {harness::read_archive(bytes, "a.zip", wanted, limits), {}};
    } catch (const harness::ArchiveError& error) {
        return {{}, error.what()};
    }
}

std::string check_path(const std::string& path) {
    if (path.empty() || path.find('\0') != std::string::npos) return "a path that is none";
    if (path.find('\\') != std::string::npos) return "a path with a backslash";
    std::size_t at = 0;
    while (at <= path.size()) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        if (end == at) return "a path with an empty name: " + path;
        if (path[at] == '.') return "a path with a name that begins with a dot: " + path;
        at = end + 1;
    }
    return {};
}

std::string check_files(const std::vector<ArchiveFile>& files) {
    if (files.size() > limits.entries) return "more files than the limit";
    std::uint64_t kept = 0;
    for (const ArchiveFile& file : files) {
        if (std::string broken = check_path(file.path); !broken.empty()) return broken;
        if (file.bytes.size() > most_of_a_file) return "a file beyond what was wanted";
        if (file.too_large && !file.bytes.empty()) return "bytes of a file that is too large";
        kept += file.bytes.size();
    }
    return kept > limits.kept_bytes ? "more bytes than the limit" : "";
}

bool is_same(const Read& one, const Read& other) {
    return one.why_not == other.why_not &&
           std::equal(one.files.begin(), one.files.end(), other.files.begin(), other.files.end(),
                      [](const ArchiveFile& a, const ArchiveFile& b) {
                          return a.path == b.path && a.bytes == b.bytes && a.too_large == b.too_large;
                      });
}

/// Packs the files and reads them back.
std::string check_packed(std::string_view lines) {
    std::vector<PackedEntry> entries;
    std::set<std::string> paths;
    while (!lines.empty() && entries.size() < 20) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
        const std::string path(line.substr(0, line.find('=')));
        const bool is_honest = path == harness::printable(path) && check_path(path).empty() &&
                               path.find(':') == std::string::npos && !path.starts_with("__MACOSX/");
        if (is_honest && paths.insert(path).second)
            entries.push_back({path, std::string(line.substr(std::min(line.size(), path.size() + 1)))});
    }
    if (entries.empty()) return {};
    const Read back = read(packed(entries), [](std::string_view) { return most_of_a_file; });
    if (!back.why_not.empty()) return "an honest archive is refused: " + back.why_not;
    const bool all = std::equal(entries.begin(), entries.end(), back.files.begin(), back.files.end(),
                                [](const PackedEntry& entry, const ArchiveFile& file) {
                                    return entry.path == file.path && entry.bytes == file.bytes;
                                });
    return all ? "" : "what was packed is not what is read";
}

}  // namespace

std::string check_archive(std::string_view bytes) {
    constexpr std::string_view pack = "pack\n";
    if (bytes.starts_with(pack)) return check_packed(bytes.substr(pack.size()));
    const auto all = [](std::string_view) { return most_of_a_file; };
    const Read once = read(bytes, all);
    if (std::string broken = check_files(once.files); !broken.empty()) return broken;
    if (!is_same(once, read(bytes, all))) return "it is read differently the second time";
    if (once.why_not != harness::printable(once.why_not)) return "a message with control characters: " + once.why_not;
    constexpr std::size_t longest_message = 2000;
    if (once.why_not.size() > longest_message) return "a message without end";
    if (!once.why_not.empty()) return {};
    const Read names = read(bytes, [](std::string_view) { return std::uint64_t{0}; });
    const bool same_names = std::equal(names.files.begin(), names.files.end(), once.files.begin(), once.files.end(),
                                       [](const ArchiveFile& a, const ArchiveFile& b) { return a.path == b.path; });
    return same_names ? "" : "the files are others if none is wanted";
}
