// Archives for tests, written entry by entry, also such as no honest packer writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

struct PackedEntry {
    std::string path;
    std::string bytes;
    enum class Type { file, folder, link, hard_link, pipe } type = Type::file;
};

/// A zip, or a gzipped tar where the name ends in .tgz. Returns its path.
std::filesystem::path pack(const std::filesystem::path& archive, const std::vector<PackedEntry>& entries,
                           const std::string& password = {});

/// The bytes of such a zip.
std::string packed(const std::vector<PackedEntry>& entries);
