#include "harness/intake/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "harness/text/printable.h"
#include "harness/text/utf8_locale.h"

namespace harness {
namespace {

using Reader = std::unique_ptr<archive, int (*)(archive*)>;

/// Allows only the formats in which students submit: every further format exposes more code to untrusted bytes.
Reader open_reader() {
    Reader reader(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(reader.get());
    archive_read_support_format_tar(reader.get());
    archive_read_support_filter_gzip(reader.get());
    return reader;
}

std::string name_in_quotes(std::string_view name) {
    constexpr std::size_t enough = 200;
    return '"' + printable(name.substr(0, enough)) + (name.size() > enough ? "…\"" : "\"");
}

class ArchiveReader {
  public:
    ArchiveReader(Reader reader, std::string shown, const Wanted& wanted, const ArchiveLimits& limits)
        : reader_(std::move(reader)), shown_(std::move(shown)), wanted_(wanted), limits_(limits) {}

    std::vector<ArchiveFile> read() {
        std::vector<ArchiveFile> files;
        archive_entry* entry = nullptr;
        for (;;) {
            const int result = archive_read_next_header(reader_.get(), &entry);
            if (result == ARCHIVE_EOF) break;
            if (result != ARCHIVE_OK && result != ARCHIVE_WARN) fail_reading();
            if (++entries_ > limits_.entries)
                fail(fmt::format("holds more than {} entries, from {} on", limits_.entries,
                                 name_in_quotes(name_of(entry))));
            if (auto file = take(entry)) files.push_back(std::move(*file));
        }
        return files;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw ArchiveError(fmt::format("{} {}. It is not read; ask whoever packed it for another one.", shown_, what));
    }

    [[noreturn]] void fail_reading() const {
        const char* message = archive_error_string(reader_.get());
        fail(fmt::format("can't be read{}: {}", last_.empty() ? "" : " after " + name_in_quotes(last_),
                         message == nullptr ? "it is broken" : printable(message)));
    }

    static std::string name_of(archive_entry* entry) {
        const char* name = archive_entry_pathname(entry);
        if (name == nullptr) name = archive_entry_pathname_utf8(entry);
        std::string text = name == nullptr ? "" : name;
        std::replace(text.begin(), text.end(), '\\', '/');  // some packers on Windows write this
        return text;
    }

    /// Returns the path without empty and "." names. Throws if it leads out of the archive.
    std::string checked_path(const std::string& name) const {
        const bool has_drive = name.size() > 1 && name[1] == ':';
        if (name.empty()) fail(fmt::format("has an entry without a name after {}", name_in_quotes(last_)));
        if (name.front() == '/' || has_drive) fail(fmt::format("has the absolute path {} in it", name_in_quotes(name)));
        std::string path;
        for (const auto& part : std::filesystem::path(name)) {
            if (part == "..") fail(fmt::format("has {} in it, a path that leads out of it", name_in_quotes(name)));
            if (part.empty() || part == ".") continue;
            path += (path.empty() ? "" : "/") + part.string();
        }
        return path;
    }

    static bool is_of_no_interest(const std::string& path) {
        if (path.starts_with("__MACOSX/")) return true;
        const auto parts = std::filesystem::path(path);
        return std::any_of(parts.begin(), parts.end(),
                           [](const std::filesystem::path& part) { return part.native().starts_with('.'); });
    }

    std::optional<ArchiveFile> take(archive_entry* entry) {
        const std::string name = name_of(entry);
        const std::string path = checked_path(name);
        last_ = name;
        if (archive_entry_is_encrypted(entry) != 0)
            fail(fmt::format("has {} in it, which needs a password", name_in_quotes(name)));
        const bool is_link = archive_entry_filetype(entry) == AE_IFLNK || archive_entry_hardlink(entry) != nullptr ||
                             archive_entry_symlink(entry) != nullptr;
        if (is_link) fail(fmt::format("has {} in it, which is a link", name_in_quotes(name)));
        if (archive_entry_filetype(entry) == AE_IFDIR) return std::nullopt;
        if (archive_entry_filetype(entry) != AE_IFREG)
            fail(fmt::format("has {} in it, which is no file", name_in_quotes(name)));
        count(unpacked_, static_cast<std::uint64_t>(std::max<std::int64_t>(archive_entry_size(entry), 0)),
              limits_.unpacked_bytes, name);
        if (path.empty() || is_of_no_interest(path)) return std::nullopt;
        ArchiveFile file{path, {}, false};
        if (const std::uint64_t most = wanted_(path); most > 0) read_bytes(file, most);
        return file;
    }

    void count(std::uint64_t& total, std::uint64_t bytes, std::uint64_t most, const std::string& name) const {
        total = bytes > most - std::min(most, total) ? most + 1 : total + bytes;
        if (total > most)
            fail(fmt::format("holds more than {} MiB, with {} the limit is passed", most >> 20U, name_in_quotes(name)));
    }

    /// Does not trust the size that the entry claims.
    void read_bytes(ArchiveFile& file, std::uint64_t most) {
        std::array<char, 16384> buffer{};
        for (;;) {
            const la_ssize_t got = archive_read_data(reader_.get(), buffer.data(), buffer.size());
            if (got == 0) return;
            if (got < 0) fail_reading();
            file.bytes.append(buffer.data(), static_cast<std::size_t>(got));
            if (file.bytes.size() > most) {
                file.too_large = true;
                std::string().swap(file.bytes);
                return;
            }
            count(kept_, static_cast<std::uint64_t>(got), limits_.kept_bytes, file.path);
        }
    }

    Reader reader_;
    std::string shown_;
    const Wanted& wanted_;
    const ArchiveLimits& limits_;
    std::size_t entries_ = 0;
    std::uint64_t unpacked_ = 0;
    std::uint64_t kept_ = 0;
    std::string last_;  ///< the name of the entry read last
};

[[noreturn]] void fail_to_open(archive* reader, const std::string& shown) {
    const char* message = archive_error_string(reader);
    throw ArchiveError(fmt::format("{} can't be opened as a zip or tar archive: {}.", shown,
                                   message == nullptr ? "it is something else" : printable(message)));
}

}  // namespace

bool is_archive_name(std::string_view name) {
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::array endings = {".zip", ".tar", ".tar.gz", ".tgz"};
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return lower.ends_with(ending); });
}

std::vector<ArchiveFile> read_archive(const std::filesystem::path& file, const Wanted& wanted,
                                      const ArchiveLimits& limits) {
    const Utf8Names names;
    Reader reader = open_reader();
    constexpr std::size_t block = 65536;
    if (archive_read_open_filename(reader.get(), file.c_str(), block) != ARCHIVE_OK)
        fail_to_open(reader.get(), in_quotes(file));
    return ArchiveReader(std::move(reader), in_quotes(file), wanted, limits).read();
}

std::vector<ArchiveFile> read_archive(std::string_view bytes, std::string_view shown, const Wanted& wanted,
                                      const ArchiveLimits& limits) {
    const Utf8Names names;
    Reader reader = open_reader();
    if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
        fail_to_open(reader.get(), name_in_quotes(shown));
    return ArchiveReader(std::move(reader), name_in_quotes(shown), wanted, limits).read();
}

}  // namespace harness
