#include "harness/intake/archive_entries.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <new>
#include <optional>
#include <vector>

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

/// Throws std::bad_alloc if that is why libarchive failed.
void fail_for_memory(archive* reader) {
    if (archive_errno(reader) == ENOMEM) throw std::bad_alloc();
}

class ArchiveReader {
  public:
    ArchiveReader(Reader reader, std::string shown, const Wanted& wanted, const ArchiveLimits& limits)
        : reader_(std::move(reader)), shown_(std::move(shown)), wanted_(wanted), limits_(limits) {}

    void send_to(MemberSender& sender) {
        archive_entry* entry = nullptr;
        for (;;) {
            const int result = archive_read_next_header(reader_.get(), &entry);
            if (result == ARCHIVE_EOF) return;
            if (result != ARCHIVE_OK && result != ARCHIVE_WARN) fail_reading();
            if (++entries_ > limits_.entries)
                fail(fmt::format("holds more than {} entries, from {} on", limits_.entries,
                                 name_in_quotes(name_of(entry))));
            if (const auto file = take(entry)) sender.send(*file);
        }
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw ArchiveError(fmt::format("{} {}. It is not read; ask whoever packed it for another one.", shown_, what));
    }

    [[noreturn]] void fail_reading() const {
        fail_for_memory(reader_.get());
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

    /// Returns the names of a path, without empty and "." ones. Throws if it leads out of the archive, is too long or
    /// too deep.
    std::vector<std::string_view> checked_names(const std::string& path) {
        const bool has_drive = path.size() > 1 && path[1] == ':';
        if (path.empty()) fail(fmt::format("has an entry without a name after {}", name_in_quotes(last_)));
        if (path.size() > limits_.path_bytes)
            fail(fmt::format("has {} in it, a path longer than {} bytes", name_in_quotes(path), limits_.path_bytes));
        if ((path_bytes_ += path.size()) > limits_.all_path_bytes)
            fail(fmt::format("holds paths of more than {} bytes, with {} the limit is passed", limits_.all_path_bytes,
                             name_in_quotes(path)));
        if (path.front() == '/' || has_drive) fail(fmt::format("has the absolute path {} in it", name_in_quotes(path)));
        std::vector<std::string_view> names;
        for (std::size_t begin = 0; begin < path.size();) {
            const std::size_t end = std::min(path.find('/', begin), path.size());
            const std::string_view name = std::string_view(path).substr(begin, end - begin);
            begin = end + 1;
            if (name == "..") fail(fmt::format("has {} in it, a path that leads out of it", name_in_quotes(path)));
            if (name.empty() || name == ".") continue;
            names.push_back(name);
            if (names.size() > limits_.path_names)
                fail(fmt::format("has {} in it, a path of more than {} folders", name_in_quotes(path),
                                 limits_.path_names - 1));
        }
        return names;
    }

    static bool is_of_no_interest(const std::vector<std::string_view>& names) {
        if (names.empty() || (names.size() > 1 && names.front() == "__MACOSX")) return true;
        return std::any_of(names.begin(), names.end(), [](std::string_view name) { return name.front() == '.'; });
    }

    std::optional<ArchiveFile> take(archive_entry* entry) {
        const std::string name = name_of(entry);
        const auto names = checked_names(name);
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
        if (is_of_no_interest(names)) return std::nullopt;
        ArchiveFile file{fmt::format("{}", fmt::join(names, "/")), {}, false};
        if (const std::uint64_t most = wanted_(file.path); most > 0) read_bytes(file, most);
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
    std::size_t path_bytes_ = 0;
    std::uint64_t unpacked_ = 0;
    std::uint64_t kept_ = 0;
    std::string last_;  ///< the name of the entry read last
};

[[noreturn]] void fail_to_open(archive* reader, const std::string& shown) {
    fail_for_memory(reader);
    const char* message = archive_error_string(reader);
    throw ArchiveError(fmt::format("{} can't be opened as a zip or tar archive: {}.", shown,
                                   message == nullptr ? "it is something else" : printable(message)));
}

}  // namespace

void send_entries(const OpenArchive& opened, const Wanted& wanted, const ArchiveLimits& limits, MemberSender& sender) {
    const Utf8Names names;
    Reader reader = open_reader();
    constexpr std::size_t block = 65536;
    const int result = opened.descriptor >= 0
                           ? archive_read_open_fd(reader.get(), opened.descriptor, block)
                           : archive_read_open_memory(reader.get(), opened.bytes.data(), opened.bytes.size());
    if (result != ARCHIVE_OK) fail_to_open(reader.get(), opened.shown);
    ArchiveReader(std::move(reader), opened.shown, wanted, limits).send_to(sender);
}

std::string name_in_quotes(std::string_view name) {
    constexpr std::size_t enough = 200;
    return '"' + printable(name.substr(0, enough)) + (name.size() > enough ? "…\"" : "\"");
}

}  // namespace harness
