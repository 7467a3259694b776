// One year's assignment: its scene and marking. Read from a TOML file; the numbers stay exactly as written.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/numbers/decimal.h"
#include "reference/stages/items.h"
#include "reference/stages/scene.h"
#include "reference/toml/appearance.h"
#include "reference/toml/rubric.h"
#include "reference/toml/variant.h"

namespace reference {

/// A limit of [limits] as it was read. The code that enforces the limits checks their names.
struct LimitEntry {
    std::string name;   ///< "run.cpu_seconds"
    double value;       ///< finite
    std::string place;  ///< for messages: file, line and key
};

struct Assignment {
    std::string name;   ///< the file's name without ".toml"
    std::string title;  ///< for people
    Scene<Decimal> scene;
    std::vector<Question> questions = default_questions();  ///< by number; no item is asked twice
    Rubric rubric;
    std::vector<LimitEntry> limits;  ///< in the file's order
    std::vector<Variant> variants;   ///< in the file's order; each is complete, including unchanged parts
    /// The students' own scenes, by student id; empty if all have the same.
    std::map<std::string, Scene<Decimal>> dealt;
    /// Unusual but allowed features of the scene: a mirrored window. Whole sentences.
    std::vector<std::string> notes;
    Appearance appearance;  ///< for pictures; marking never reads it
};

/// Reads an assignment from TOML text; `path` names it in messages. Throws AssignmentError.
Assignment parse_assignment(std::string_view toml, const std::filesystem::path& path);

/// The assignment of this student, without others' scenes. Throws AssignmentError, with similar ids, if the student has
/// no scene.
Assignment of_student(const Assignment& assignment, const std::string& id);

/// Finds and reads an assignment: an existing file, or else the name of one in `directory` (with or without ".toml").
/// "file.toml@s07" is the assignment of student s07. Throws AssignmentError; if the name does not exist, the message
/// lists the existing names.
Assignment load_assignment(const std::string& name_or_file, const std::filesystem::path& directory);

/// Reads a scene file: an assignment that may leave out window.pixel, because no question needs it; its pixel is then
/// the middle one. Throws AssignmentError.
Assignment load_scene(const std::filesystem::path& file);

/// The file of an assignment before it is parsed, for callers that keep its text.
struct AssignmentFile {
    std::filesystem::path path;  ///< canonical
    std::string toml;            ///< its text, for parse_assignment
};

/// Finds the same file as load_assignment and reads its text. Throws AssignmentError like load_assignment.
AssignmentFile read_assignment_file(const std::string& name_or_file, const std::filesystem::path& directory);

}  // namespace reference
