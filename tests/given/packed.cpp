#include "tests/given/packed.h"

#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace {

mode_t mode_of(PackedEntry::Type type) {
    switch (type) {
        case PackedEntry::Type::file:
        case PackedEntry::Type::hard_link: return AE_IFREG;
        case PackedEntry::Type::folder: return AE_IFDIR;
        case PackedEntry::Type::link: return AE_IFLNK;
        case PackedEntry::Type::pipe: return AE_IFIFO;
    }
    return AE_IFREG;
}

/// Sets the locale while it lives, then restores the C locale, in which reading must work.
class Utf8Locale {
  public:
    Utf8Locale() { std::setlocale(LC_CTYPE, "C.UTF-8"); }
    Utf8Locale(const Utf8Locale&) = delete;
    Utf8Locale& operator=(const Utf8Locale&) = delete;
    ~Utf8Locale() { std::setlocale(LC_CTYPE, "C"); }
};

void check(archive* writer, int result) {
    if (result != ARCHIVE_OK) throw std::runtime_error(archive_error_string(writer));
}

void add(archive* writer, const PackedEntry& packed) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), packed.path.c_str());
    archive_entry_set_filetype(entry.get(), mode_of(packed.type));
    archive_entry_set_perm(entry.get(), 0644);
    const bool has_bytes = packed.type == PackedEntry::Type::file;
    archive_entry_set_size(entry.get(), has_bytes ? static_cast<la_int64_t>(packed.bytes.size()) : 0);
    if (packed.type == PackedEntry::Type::link) archive_entry_set_symlink(entry.get(), packed.bytes.c_str());
    if (packed.type == PackedEntry::Type::hard_link) archive_entry_set_hardlink(entry.get(), packed.bytes.c_str());
    check(writer, archive_write_header(writer, entry.get()));
    if (has_bytes) archive_write_data(writer, packed.bytes.data(), packed.bytes.size());
}

std::string pack_bytes(const std::vector<PackedEntry>& entries, bool is_tar, const std::string& password) {
    const Utf8Locale names_are_utf8;
    const std::unique_ptr<archive, int (*)(archive*)> writer(archive_write_new(), archive_write_free);
    if (is_tar) {
        check(writer.get(), archive_write_set_format_pax_restricted(writer.get()));
        check(writer.get(), archive_write_add_filter_gzip(writer.get()));
    } else {
        check(writer.get(), archive_write_set_format_zip(writer.get()));
    }
    if (!password.empty()) {
        check(writer.get(), archive_write_set_options(writer.get(), "zip:encryption=traditional"));
        check(writer.get(), archive_write_set_passphrase(writer.get(), password.c_str()));
    }
    constexpr std::size_t around_an_entry = 2048;
    std::size_t most = 65536;
    for (const PackedEntry& entry : entries) most += around_an_entry + 2 * entry.path.size() + entry.bytes.size();
    std::string bytes(most, '\0');
    std::size_t used = 0;
    check(writer.get(), archive_write_open_memory(writer.get(), bytes.data(), bytes.size(), &used));
    for (const PackedEntry& entry : entries) add(writer.get(), entry);
    check(writer.get(), archive_write_close(writer.get()));
    bytes.resize(used);
    return bytes;
}

}  // namespace

std::filesystem::path pack(const std::filesystem::path& file, const std::vector<PackedEntry>& entries,
                           const std::string& password) {
    std::ofstream(file, std::ios::binary) << pack_bytes(entries, file.extension() == ".tgz", password);
    return file;
}

std::string packed(const std::vector<PackedEntry>& entries) {
    return pack_bytes(entries, false, {});
}
