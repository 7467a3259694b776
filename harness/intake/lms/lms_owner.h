// Whose an entry of a packed download is, by its path alone.
#pragma once

#include <string>
#include <string_view>

namespace harness {

struct EntryOwner {
    /// Equal for all entries of one student: the student's folder in the archive, or in a download without folders the
    /// folder of the file and the student. Empty for what is nobody's.
    std::string key;
    std::string place;       ///< the student's folder, or the path of the file
    bool is_folder = false;  ///< `place` is a folder
};

/// Goes by the outermost name that a learning management system has written, so what a student's own names look like
/// changes nothing below a folder of the system. Files of a download without folders whose names have several readings
/// share one owner.
EntryOwner owner_of_entry(std::string_view path);

}  // namespace harness
