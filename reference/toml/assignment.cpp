#include "reference/toml/assignment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "reference/toml/appearance_reader.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/near_names.h"
#include "reference/toml/questions_reader.h"
#include "reference/toml/rubric_reader.h"
#include "reference/toml/scene_reader.h"
#include "reference/toml/toml_table.h"
#include "reference/toml/variants_reader.h"

namespace reference {
namespace {

std::string names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
        if (entry.path().extension() == ".toml" && !entry.is_symlink()) names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<LimitEntry> read_limits(const TomlTable& stages) {
    std::vector<LimitEntry> limits;
    for (const std::string& stage : stages.keys()) {
        if (!stages.is_table(stage)) {  // a limit without its stage; the code that enforces limits reports it
            limits.push_back({stage, stages.decimal(stage).to_double(), stages.place(stage)});
            continue;
        }
        const TomlTable table = stages.table(stage);
        for (const std::string& name : table.keys()) {
            limits.push_back({fmt::format("{}.{}", stage, name), table.decimal(name).to_double(), table.place(name)});
        }
    }
    return limits;
}

Assignment parse(std::string_view toml, const std::filesystem::path& path, PixelKey pixel) {
    const TomlDocument document(toml, path);
    const TomlTable root = document.root();
    std::vector<std::string_view> keys{"title", "camera", "window"};
    for (const Subject kind : objects) keys.push_back(to_string(kind));
    keys.insert(keys.end(), {"question", "rubric", "limits", "light", "material", "render", "student", "variant"});
    root.allow_only(keys);
    Assignment assignment;
    assignment.name = path.stem().string();
    assignment.title = root.has("title") ? root.string("title") : assignment.name;
    assignment.scene = read_scene(root, assignment.notes, pixel);
    ReadQuestions asked = read_questions(root, assignment.scene);
    assignment.rubric = read_rubric(root, asked);
    assignment.questions = std::move(asked.questions);
    if (root.has("limits")) assignment.limits = read_limits(root.table("limits"));
    assignment.variants = read_variants(root, assignment.scene, path);
    assignment.dealt = read_dealt_scenes(root, assignment.scene, path);
    assignment.appearance = read_appearance(root);
    return assignment;
}

std::string read_text(const std::filesystem::path& path) {
    constexpr std::uintmax_t largest_file = 1 << 20;
    std::error_code error;
    if (std::filesystem::file_size(path, error) > largest_file) {
        throw AssignmentError(fmt::format("{} is larger than 1 MiB; name an assignment's .toml file", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw AssignmentError(fmt::format("cannot read {}; check its permissions", path.string()));
    return text.str();
}

/// The end of the file's name in "a6.toml@ada"; npos in a name without a student.
std::size_t end_of_file_name(std::string_view name) {
    constexpr std::string_view before_student = ".toml@";
    const std::size_t at = name.find(before_student);
    return at == std::string_view::npos ? at : at + before_student.size() - 1;
}

}  // namespace

Assignment parse_assignment(std::string_view toml, const std::filesystem::path& path) {
    return parse(toml, path, PixelKey::required);
}

AssignmentFile read_assignment_file(const std::string& name_or_file, const std::filesystem::path& directory) {
    namespace fs = std::filesystem;
    fs::path path = name_or_file;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        path = directory / name_or_file;
        if (path.extension() != ".toml") path += ".toml";
    }
    if (!fs::is_regular_file(path, error)) {
        if (const std::size_t end = end_of_file_name(name_or_file); end != std::string::npos) {
            throw AssignmentError(
                fmt::format("{} is one student's scene, but this command needs the whole assignment: {}", name_or_file,
                            name_or_file.substr(0, end)));
        }
        throw AssignmentError(fmt::format("there is no assignment \"{}\"; name a .toml file, or one of {} (in {})",
                                          name_or_file, names_in(directory), directory.string()));
    }
    path = fs::canonical(path, error);
    return {path, read_text(path)};
}

Assignment of_student(const Assignment& assignment, const std::string& id) {
    const auto own = assignment.dealt.find(id);
    if (own == assignment.dealt.end()) {
        std::vector<std::string> ids;
        for (const auto& [student, scene] : assignment.dealt) ids.push_back(student);
        throw AssignmentError(fmt::format("{} has no scene for \"{}\"; {}", assignment.name, id,
                                          ids.empty() ? "it has one scene for all students" : did_you_mean(id, ids)));
    }
    Assignment result = assignment;
    result.name += "@" + id;
    result.scene = own->second;
    result.dealt.clear();
    return result;
}

Assignment load_assignment(const std::string& name_or_file, const std::filesystem::path& directory) {
    const std::size_t end = end_of_file_name(name_or_file);
    std::error_code error;
    if (end == std::string::npos || std::filesystem::exists(name_or_file, error)) {
        const AssignmentFile file = read_assignment_file(name_or_file, directory);
        return parse_assignment(file.toml, file.path);
    }
    return of_student(load_assignment(name_or_file.substr(0, end), directory), name_or_file.substr(end + 1));
}

Assignment load_scene(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw AssignmentError(fmt::format("there is no file {}; name a scene's .toml file", file.string()));
    }
    return parse(read_text(file), file, PixelKey::optional);
}

}  // namespace reference
