// Finds the owner of an entry of a packed download by its path alone.
#pragma once

#include <string>
#include <string_view>

namespace harness {

struct EntryOwner {
    /// Equal for all entries of one student: the student's folder in the archive, or in a download without folders the
    /// file's folder and the student. Empty for an entry without an owner.
    std::string key;
    std::string place;       ///< the student's folder, or the path of the file
    bool is_folder = false;  ///< `place` is a folder
};

/// Uses the outermost name that a learning management system wrote, so students' own names in the system's folders have
/// no effect. In a download without folders, files whose names have several readings share one owner.
EntryOwner owner_of_entry(std::string_view path);

}  // namespace harness
