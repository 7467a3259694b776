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
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "harness/text/printable.h"
#include "harness/text/utf8_locale.h"

namespace harness {
namespace {

using Reader = std::unique_ptr<archive, int (*)(archive*)>;

/// Allows only formats that students use: every further format exposes more code to untrusted bytes.
Reader open_reader() {
    Reader reader(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(reader.get());
    archive_read_support_format_tar(reader.get());
    archive_read_support_filter_gzip(reader.get());
    return reader;
}

/// Throws std::bad_alloc if libarchive failed for lack of memory.
void fail_for_memory(archive* reader) {
    if (archive_errno(reader) == ENOMEM) throw std::bad_alloc();
}

/// The problem with one entry.
struct Objection {
    std::string what;  ///< follows the name of the archive or of the student: "has … in it, which is a link"
};

/// The used part of an archive's limits.
struct Amounts {
    std::uint64_t entries = 0;
    std::uint64_t path_bytes = 0;
    std::uint64_t unpacked = 0;
    std::uint64_t kept = 0;
};

class ArchiveReader {
  public:
    ArchiveReader(Reader reader, std::string shown, const Wanted& wanted, const ArchiveLimits& limits, Shares shares)
        : reader_(std::move(reader)), shown_(std::move(shown)), wanted_(wanted), of_nobody_(limits), shares_(shares) {}

    void send_to(MemberSender& sender) {
        archive_entry* entry = nullptr;
        for (;;) {
            const int result = archive_read_next_header(reader_.get(), &entry);
            if (result == ARCHIVE_EOF) return;
            if (result != ARCHIVE_OK && result != ARCHIVE_WARN) fail_reading();
            const std::string name = name_of(entry);
            const EntryOwner owner = shares_ == Shares::none ? EntryOwner() : owner_of_entry(name);
            if (refused_.contains(owner.key)) continue;
            used_ = &used_of_[owner.key];
            limits_ = owner.key.empty() ? &of_nobody_ : &limits_of_a_share;
            try {
                const auto file = take(entry, name);
                expect_room_for_all();
                if (file) sender.send(*file);
            } catch (const Objection& objection) {
                if (owner.key.empty()) fail(objection.what);
                refuse(owner, objection.what, sender);
            }
        }
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw ArchiveError(fmt::format("{} {}. It was not read; pack it again.", shown_, what));
    }

    [[noreturn]] static void object(std::string what) { throw Objection{std::move(what)}; }

    void refuse(const EntryOwner& owner, const std::string& what, MemberSender& sender) {
        refused_.insert(owner.key);
        std::vector<std::string_view> names;
        for (std::string_view rest = owner.place; !rest.empty();) {
            names.push_back(rest.substr(0, rest.find('/')));
            rest.remove_prefix(std::min(rest.size(), names.back().size() + 1));
        }
        if (is_of_no_interest(names)) return;
        const std::string_view student = std::string_view(owner.key).substr(owner.key.rfind('/') + 1);
        sender.refuse(owner, fmt::format("{} {}. Nothing in it was read; hand in only the source.",
                                         student == "?" ? "A folder that may belong to several students"
                                                        : name_in_quotes(student),
                                         what));
    }

    void expect_room_for_all() const {
        const auto expect = [&](std::uint64_t used, std::uint64_t most, const char* of) {
            if (used > most) fail(fmt::format("contains too much: more than {} {}", most, of));
        };
        expect(of_all_.entries, limits_of_a_class.entries, "entries");
        expect(of_all_.path_bytes, limits_of_a_class.all_path_bytes, "bytes of paths");
        expect(of_all_.unpacked, limits_of_a_class.unpacked_bytes, "bytes");
        expect(of_all_.kept, limits_of_a_class.kept_bytes, "bytes of sources and archives");
    }

    /// Adds to the amounts of the entry's student. False if they exceed `most`.
    bool count(std::uint64_t Amounts::*amount, std::uint64_t more, std::uint64_t most) {
        std::uint64_t& used = used_->*amount;
        if (more > most - std::min(most, used)) return false;
        used += more;
        of_all_.*amount += more;
        return true;
    }

    [[noreturn]] void fail_reading() const {
        fail_for_memory(reader_.get());
        const char* message = archive_error_string(reader_.get());
        fail(fmt::format("cannot be read{}: {}", last_.empty() ? "" : " after " + name_in_quotes(last_),
                         message == nullptr ? "it is damaged" : printable(message)));
    }

    static std::string name_of(archive_entry* entry) {
        const char* name = archive_entry_pathname(entry);
        if (name == nullptr) name = archive_entry_pathname_utf8(entry);
        std::string text = name == nullptr ? "" : name;
        std::replace(text.begin(), text.end(), '\\', '/');  // some packers on Windows write this
        return text;
    }

    /// The names in a path, without empty and "." ones. Throws if the path leads outside the archive, is too long or
    /// too deep.
    std::vector<std::string_view> checked_names(const std::string& path) {
        const bool has_drive = path.size() > 1 && path[1] == ':';
        if (path.empty()) object(fmt::format("has an entry without a name after {}", name_in_quotes(last_)));
        if (path.size() > limits_->path_bytes)
            object(fmt::format("contains {}, a path longer than {} bytes", name_in_quotes(path), limits_->path_bytes));
        if (!count(&Amounts::path_bytes, path.size(), limits_->all_path_bytes))
            object(fmt::format("contains paths of more than {} bytes in total, from {} on", limits_->all_path_bytes,
                               name_in_quotes(path)));
        if (path.front() == '/' || has_drive)
            object(fmt::format("contains the absolute path {}", name_in_quotes(path)));
        std::vector<std::string_view> names;
        for (std::size_t begin = 0; begin < path.size();) {
            const std::size_t end = std::min(path.find('/', begin), path.size());
            const std::string_view name = std::string_view(path).substr(begin, end - begin);
            begin = end + 1;
            if (name == "..") object(fmt::format("contains {}, a path that leads outside", name_in_quotes(path)));
            if (name.empty() || name == ".") continue;
            names.push_back(name);
            if (names.size() > limits_->path_names)
                object(fmt::format("contains {}, a path of more than {} folders", name_in_quotes(path),
                                   limits_->path_names - 1));
        }
        return names;
    }

    static bool is_of_no_interest(const std::vector<std::string_view>& names) {
        if (names.empty() || (names.size() > 1 && names.front() == "__MACOSX")) return true;
        return std::any_of(names.begin(), names.end(), [](std::string_view name) { return name.front() == '.'; });
    }

    std::optional<ArchiveFile> take(archive_entry* entry, const std::string& name) {
        if (!count(&Amounts::entries, 1, limits_->entries))
            object(fmt::format("contains more than {} entries, from {} on", limits_->entries, name_in_quotes(name)));
        const auto names = checked_names(name);
        last_ = name;
        if (archive_entry_is_encrypted(entry) != 0)
            object(fmt::format("contains {}, which needs a password", name_in_quotes(name)));
        const bool is_link = archive_entry_filetype(entry) == AE_IFLNK || archive_entry_hardlink(entry) != nullptr ||
                             archive_entry_symlink(entry) != nullptr;
        if (is_link) object(fmt::format("contains {}, which is a link", name_in_quotes(name)));
        if (archive_entry_filetype(entry) == AE_IFDIR) return std::nullopt;
        if (archive_entry_filetype(entry) != AE_IFREG)
            object(fmt::format("contains {}, which is not a file", name_in_quotes(name)));
        count_bytes(&Amounts::unpacked,
                    static_cast<std::uint64_t>(std::max<std::int64_t>(archive_entry_size(entry), 0)),
                    limits_->unpacked_bytes, name);
        if (is_of_no_interest(names)) return std::nullopt;
        ArchiveFile file{fmt::format("{}", fmt::join(names, "/")), {}, false};
        if (const std::uint64_t most = wanted_(file.path); most > 0) read_bytes(file, most);
        return file;
    }

    void count_bytes(std::uint64_t Amounts::*amount, std::uint64_t bytes, std::uint64_t most, const std::string& name) {
        if (!count(amount, bytes, most))
            object(fmt::format("contains more than {} MiB in total, from {} on", most >> 20U, name_in_quotes(name)));
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
            count_bytes(&Amounts::kept, static_cast<std::uint64_t>(got), limits_->kept_bytes, file.path);
        }
    }

    Reader reader_;
    std::string shown_;
    const Wanted& wanted_;
    const ArchiveLimits& of_nobody_;
    const Shares shares_;
    std::unordered_map<std::string, Amounts>
        used_of_;                              ///< by owner; the empty owner has the files that belong to nobody
    std::unordered_set<std::string> refused_;  ///< owners
    Amounts of_all_;
    Amounts* used_ = nullptr;                ///< of the entry's owner
    const ArchiveLimits* limits_ = nullptr;  ///< of the entry's owner
    std::string last_;                       ///< the name of the entry read last
};

[[noreturn]] void fail_to_open(archive* reader, const std::string& shown) {
    fail_for_memory(reader);
    const char* message = archive_error_string(reader);
    throw ArchiveError(fmt::format("{} cannot be opened as a zip or tar archive: {}. Pack it again.", shown,
                                   message == nullptr ? "it is another kind of file" : printable(message)));
}

}  // namespace

void send_entries(const OpenArchive& opened, const Wanted& wanted, const ArchiveLimits& limits, Shares shares,
                  MemberSender& sender) {
    const Utf8Names names;
    Reader reader = open_reader();
    constexpr std::size_t block = 65536;
    const int result = opened.descriptor >= 0
                           ? archive_read_open_fd(reader.get(), opened.descriptor, block)
                           : archive_read_open_memory(reader.get(), opened.bytes.data(), opened.bytes.size());
    if (result != ARCHIVE_OK) fail_to_open(reader.get(), opened.shown);
    ArchiveReader(std::move(reader), opened.shown, wanted, limits, shares).send_to(sender);
}

std::string name_in_quotes(std::string_view name) {
    constexpr std::size_t enough = 200;
    return '"' + printable(name.substr(0, enough)) + (name.size() > enough ? "…\"" : "\"");
}

}  // namespace harness
