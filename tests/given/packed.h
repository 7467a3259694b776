// Writes archives for tests entry by entry, including archives that no honest packer would write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

struct PackedEntry {
    std::string path;
    std::string bytes;
    enum class Type { file, folder, link, hard_link, pipe } type = Type::file;
};

/// Writes a zip, or a gzipped tar if the name ends in .tgz. Returns its path.
std::filesystem::path pack(const std::filesystem::path& archive, const std::vector<PackedEntry>& entries,
                           const std::string& password = {});

/// The bytes of a zip with these entries.
std::string packed(const std::vector<PackedEntry>& entries);
