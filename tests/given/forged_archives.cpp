#include "tests/given/forged_archives.h"

#include <archive.h>
#include <archive_entry.h>

#include <functional>
#include <memory>
#include <stdexcept>

namespace forged {
namespace {

/// What libarchive's packer makes of `write`.
std::string packed_by_libarchive(const std::function<void(archive*)>& choose, const std::string& name,
                                 const std::string& bytes) {
    const std::unique_ptr<archive, int (*)(archive*)> writer(archive_write_new(), archive_write_free);
    choose(writer.get());
    std::string all(bytes.size() + 65536, '\0');
    std::size_t used = 0;
    if (archive_write_open_memory(writer.get(), all.data(), all.size(), &used) != ARCHIVE_OK)
        throw std::runtime_error(archive_error_string(writer.get()));
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_write_header(writer.get(), entry.get());
    archive_write_data(writer.get(), bytes.data(), bytes.size());
    archive_write_close(writer.get());
    all.resize(used);
    return all;
}

std::string octal(std::uint64_t number, std::size_t width) {
    std::string text(width, '\0');
    for (std::size_t i = width - 1; i-- > 0; number >>= 3U) text[i] = static_cast<char>('0' + (number & 7U));
    return text;
}

}  // namespace

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    all.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

std::string little_endian(std::uint64_t number, std::size_t bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xFFU);
    return text;
}

std::string gzipped(const std::string& bytes) {
    const auto raw = [](archive* writer) {
        archive_write_set_format_raw(writer);
        archive_write_add_filter_gzip(writer);
    };
    return packed_by_libarchive(raw, "data", bytes);
}

std::string deflated(const std::string& bytes) {
    const std::string whole = gzipped(bytes);
    constexpr std::size_t head = 10, tail = 8;
    return whole.substr(head, whole.size() - head - tail);
}

std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) crc = crc >> 1U ^ (0xEDB88320U & (0U - (crc & 1U)));
    }
    return ~crc;
}

std::string zip(const std::vector<Member>& members) {
    std::string all, list;
    std::vector<std::size_t> offsets;
    for (const Member& member : members) {
        const auto packed = static_cast<std::uint32_t>(member.data.size()) + member.packed_off_by;
        const std::string about = little_endian(20, 2) + little_endian(member.flags, 2) +
                                  little_endian(member.method, 2) + std::string(4, '\0') +
                                  little_endian(member.crc, 4) + little_endian(packed, 4) +
                                  little_endian(member.unpacked, 4);
        const bool shares = member.offset_of < offsets.size();
        offsets.push_back(shares ? offsets[member.offset_of] : all.size());
        const auto lengths = [&](const std::string& name) {
            return little_endian(name.size(), 2) + little_endian(member.extra.size(), 2);
        };
        if (!shares) all += "PK\x03\x04" + about + lengths(member.name) + member.name + member.extra + member.data;
        const std::string& name = member.other_name.empty() ? member.name : member.other_name;
        list += "PK\x01\x02" + little_endian(0x0314, 2) + about + lengths(name) + std::string(6, '\0') +
                little_endian(member.attributes, 4) + little_endian(offsets.back(), 4) + name + member.extra;
    }
    const std::string count = little_endian(members.size(), 2);
    return all + list + "PK\x05\x06" + std::string(4, '\0') + count + count + little_endian(list.size(), 4) +
           little_endian(all.size(), 4) + std::string(2, '\0');
}

std::string zip_of_names(const std::vector<std::string>& names) {
    std::vector<Member> members;
    for (const std::string& name : names) members.push_back({name});
    return zip(members);
}

std::string tar_entry(const TarEntry& entry) {
    std::string head = entry.name.substr(0, 100);
    head.resize(100, '\0');
    head += octal(0644, 8) + octal(0, 8) + octal(0, 8);
    head += entry.size_field.empty() ? octal(entry.data.size(), 12) : entry.size_field;
    head += octal(0, 12) + "        " + entry.type;
    std::string link = entry.link.substr(0, 100);
    link.resize(100, '\0');
    head += link + std::string("ustar\00000", 8);
    head.resize(512, '\0');
    unsigned sum = 0;
    for (const char c : head) sum += static_cast<unsigned char>(c);
    head.replace(148, 8, octal(sum, 7) + ' ');
    std::string data = entry.data;
    data.resize((data.size() + 511) / 512 * 512, '\0');
    return head + data;
}

std::string tar(const std::vector<TarEntry>& entries) {
    std::string all;
    for (const TarEntry& entry : entries) all += tar_entry(entry);
    return all + std::string(1024, '\0');
}

std::string pax_record(const std::string& key, const std::string& value) {
    const std::size_t rest = key.size() + value.size() + 3;
    std::size_t length = rest + 1;
    while (std::to_string(length).size() + rest != length) length = std::to_string(length).size() + rest;
    return std::to_string(length) + ' ' + key + '=' + value + '\n';
}

TarEntry pax(const std::string& records, char type) {
    return {"PaxHeader", records, type};
}

}  // namespace forged
