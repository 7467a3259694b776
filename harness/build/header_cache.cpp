#include "harness/build/header_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <vector>

#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/fingerprint.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* text_ending = ".h";
constexpr const char* header_ending = ".h.gch";
constexpr auto everyone_reads = static_cast<fs::perms>(0444);

std::string text_of(const HeaderLines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

/// Gives the file a second name, or copies it if that is impossible.
bool link_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (error) fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
    return !error;
}

bool synchronise(const fs::path& file) {
    const FileDescriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC));
    return opened && fdatasync(opened.get()) == 0;
}

struct Kept {
    fs::path header;
    fs::file_time_type used;
    std::uint64_t bytes;
};

/// Removes headers that exceed the bounds, and unfinished files of a killed run.
void evict(const fs::path& folder, const HeaderCacheBounds& bounds) {
    std::error_code ignored;
    std::vector<Kept> all;
    const auto now = fs::file_time_type::clock::now();
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const fs::path& file = entry.path();
        const auto used = entry.last_write_time(ignored);
        if (file.extension() == ".gch") {
            all.push_back({file, used, entry.file_size(ignored)});
        } else if (used < now - std::chrono::hours(1)) {
            fs::remove(file, ignored);
        }
    }
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used > b.used; });
    std::uint64_t total = 0;
    for (const Kept& kept : all) {
        total += kept.bytes;
        if (total > bounds.bytes || kept.used < now - bounds.age) fs::remove(kept.header, ignored);
    }
}

}  // namespace

HeaderCache::HeaderCache(const std::optional<fs::path>& cache, const BuildSettings& settings,
                         const std::string& toolchain, const Sandbox& sandbox, const HeaderCacheBounds& bounds)
    : settings_(settings), toolchain_(toolchain), sandbox_(sandbox) {
    if (!cache) return;
    std::error_code error;
    fs::create_directories(*cache / "headers", error);
    if (error || access((*cache / "headers").c_str(), W_OK) != 0) return;
    chmod(cache->c_str(), S_IRWXU);
    kept_ = *cache / "headers";
    evict(kept_, bounds);
}

std::string HeaderCache::name_of(const HeaderLines& lines) const {
    Fingerprint fingerprint("raygrade/header/1");
    fingerprint.add(toolchain_).add(settings_.compiler.string());
    fingerprint.add(static_cast<std::int64_t>(settings_.flags.size()));
    for (const std::string& flag : settings_.flags) fingerprint.add(flag);
    for (const std::string& line : lines) fingerprint.add(line);
    return fingerprint.hex();
}

bool HeaderCache::is_kept(const HeaderLines& lines) const {
    std::error_code ignored;
    return !kept_.empty() && fs::exists(kept_ / (name_of(lines) + header_ending), ignored);
}

std::optional<fs::path> HeaderCache::get(const HeaderLines& lines) const {
    const std::string name = name_of(lines);
    const fs::path folder = sandbox_.workspace().path() / ("header-" + name);
    const fs::path target = folder / (name + header_ending);
    const fs::path header = folder / (name + text_ending);
    std::error_code error;
    if (fs::exists(target, error)) return header;
    fs::create_directory(folder, error);
    fs::permissions(folder, static_cast<fs::perms>(0755), error);
    // The compiler looks for this file, although it reads the precompiled one.
    std::ofstream(header, std::ios::binary) << text_of(lines);
    fs::permissions(header, everyone_reads, error);
    if (fetch(name, target)) return header;
    if (make(lines, name, target)) return header;
    return {};
}

/// Takes the header from the cache. False if no earlier run has kept it.
bool HeaderCache::fetch(const std::string& name, const fs::path& target) const {
    std::error_code error;
    if (kept_.empty() || !link_or_copy(kept_ / (name + header_ending), target)) return false;
    fs::permissions(target, everyone_reads, error);
    fs::last_write_time(kept_ / (name + header_ending), fs::file_time_type::clock::now(), error);
    return true;
}

bool HeaderCache::make(const HeaderLines& lines, const std::string& name, const fs::path& target) const {
    const Scratch scratch(sandbox_.workspace());
    std::error_code error;
    if (!precompile(text_of(lines), name + text_ending, settings_, sandbox_, scratch)) return false;
    const fs::path made = scratch.path() / (name + header_ending);
    // The programs' account may have made the file. It could then write to it later.
    if (chown(made.c_str(), geteuid(), getegid()) != 0) return false;
    fs::permissions(made, everyone_reads, error);
    if (!error) fs::rename(made, target, error);
    if (error) return false;
    keep(name, target);
    return true;
}

void HeaderCache::keep(const std::string& name, const fs::path& made) const {
    if (kept_.empty()) return;
    std::error_code error;
    const fs::path fresh = kept_ / (name + "." + std::to_string(getpid()) + ".new");
    fs::remove(fresh, error);
    if (link_or_copy(made, fresh) && synchronise(fresh)) {
        fs::rename(fresh, kept_ / (name + header_ending), error);
    } else {
        fs::remove(fresh, error);
    }
}

}  // namespace harness
