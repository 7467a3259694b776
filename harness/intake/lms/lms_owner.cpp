#include "harness/intake/lms/lms_owner.h"

#include <algorithm>

#include "harness/intake/lms/lms_name.h"

namespace harness {
namespace {

bool is_folder_of_a_student(std::string_view name) {
    if (read_gradescope_name(name)) return true;
    if (const auto read = read_brightspace_name(name)) return read->file.empty();
    const auto readings = moodle_readings(name);
    return std::any_of(readings.begin(), readings.end(), [](const LmsName& read) { return read.file.empty(); });
}

/// The student of a file; empty if the name does not come from a download, "?" if it is ambiguous.
std::string student_of_file(std::string_view name) {
    auto readings = canvas_readings(name);
    if (readings.empty()) readings = moodle_readings(name);
    for (const auto& read : {read_brightspace_name(name), read_blackboard_name(name)}) {
        if (readings.empty() && read) readings.push_back(*read);
    }
    std::erase_if(readings, [](const LmsName& read) { return read.file.empty(); });
    if (readings.empty()) return "";
    return readings.size() > 1 ? "?" : readings.front().student + "_" + readings.front().id;
}

}  // namespace

EntryOwner owner_of_entry(std::string_view path) {
    constexpr std::size_t longest = 1000;  // names of these systems are shorter
    constexpr int deepest = 9;
    std::string place;
    for (int depth = 0; depth < deepest && !path.empty() && place.size() <= longest; ++depth) {
        const std::string_view name = path.substr(0, path.find('/'));
        const bool is_last = name.size() == path.size();
        path.remove_prefix(std::min(path.size(), name.size() + 1));
        if (name == ".." || name.size() > longest) return {};
        if (name.empty() || name == ".") continue;
        const std::string folder = place.empty() ? "" : place + '/';
        place = folder + std::string(name);
        if (!is_last && is_folder_of_a_student(name)) return {place, place, true};
        if (!is_last) continue;
        const std::string student = student_of_file(name);
        return student.empty() ? EntryOwner() : EntryOwner{folder + student, place, false};
    }
    return {};
}

}  // namespace harness
