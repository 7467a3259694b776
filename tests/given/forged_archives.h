// Writes archives byte by byte, so that every field may lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forged {

inline const std::string honest_source = "#include <iostream>\nint main() { std::cout << 1; }\n";

std::string repeated(const std::string& text, std::size_t times);
std::string little_endian(std::uint64_t number, std::size_t bytes);
std::string gzipped(const std::string& bytes);
/// The bytes as deflate packs them, without any header.
std::string deflated(const std::string& bytes);
std::uint32_t crc32(const std::string& bytes);

/// A member of a zip, with every field free to lie.
struct Member {
    std::string name;
    std::string data = honest_source;
    std::uint32_t unpacked = static_cast<std::uint32_t>(honest_source.size());
    std::uint32_t crc = crc32(honest_source);
    std::uint16_t method = 0;
    std::uint16_t flags = 0;
    std::uint32_t attributes = 0100644U << 16U;
    std::string extra = {};
    std::string other_name = {};           ///< in the list at the end, if it differs
    std::uint32_t packed_off_by = 0;       ///< how far the stated packed size is wrong
    std::uint32_t offset_of = 0xFFFFFFFF;  ///< the member whose bytes it has too; none by default
};

std::string zip(const std::vector<Member>& members);
std::string zip_of_names(const std::vector<std::string>& names);

struct TarEntry {
    std::string name;
    std::string data = honest_source;
    char type = '0';
    std::string link = {};
    std::string size_field = {};  ///< 12 bytes in place of the true size
};

/// The entry alone, without the end of a tar.
std::string tar_entry(const TarEntry& entry);
std::string tar(const std::vector<TarEntry>& entries);

std::string pax_record(const std::string& key, const std::string& value);
TarEntry pax(const std::string& records, char type = 'x');

}  // namespace forged
