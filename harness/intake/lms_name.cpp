#include "harness/intake/lms_name.h"

#include <re2/re2.h>

namespace harness {
namespace {

re2::StringPiece piece(std::string_view text) {
    return {text.data(), text.size()};
}

}  // namespace

std::optional<LmsName> read_canvas_name(std::string_view file) {
    // The student's name may hold digits and '_', so the match for it is as short as possible.
    static const RE2 of_a_file(R"((?s)(?:(.*?)_)??(LATE_)?(?:(\d+)|anon_([^_]+))_(\d+)_(.+))");
    static const RE2 of_no_file(R"((?s)(?:(.*?)_)??(LATE_)?(?:(\d+)|anon_([^_]+))_(text|link)\.html)");
    LmsName name;
    std::string late, user, anonymous, kind;
    if (RE2::FullMatch(piece(file), of_no_file, &name.student, &late, &user, &anonymous, &kind)) {
        name.is_file = false;
        name.file = kind + ".html";
    } else if (!RE2::FullMatch(piece(file), of_a_file, &name.student, &late, &user, &anonymous, &name.attachment,
                               &name.file)) {
        return std::nullopt;
    }
    name.late = !late.empty();
    name.id = user.empty() ? "anon_" + anonymous : user;
    return name;
}

std::optional<LmsName> read_moodle_name(std::string_view text) {
    static const RE2 pattern(R"((?s)(.*)_(\d+)_assignsubmission_(file|onlinetext)(?:_(.*))?)");
    LmsName name;
    name.system = Lms::moodle;
    std::string kind;
    if (!RE2::FullMatch(piece(text), pattern, &name.student, &name.id, &kind, &name.file)) return std::nullopt;
    name.is_file = kind == "file";
    return name;
}

std::optional<LmsName> read_gradescope_name(std::string_view folder) {
    static const RE2 pattern(R"(submission_(\d+))");
    LmsName name;
    name.system = Lms::gradescope;
    if (!RE2::FullMatch(piece(folder), pattern, &name.id)) return std::nullopt;
    return name;
}

BaseName read_base_name(std::string_view file) {
    static const RE2 pattern(R"((?s)(.*?)(?:-(\d{1,9})| ?\((\d{1,9})\))(\.[^.]*))");
    std::string stem, resubmission, download, ending;
    if (!RE2::FullMatch(piece(file), pattern, &stem, &resubmission, &download, &ending) || stem.empty()) {
        return {std::string(file), 0};
    }
    return {stem + ending, std::stol(resubmission.empty() ? download : resubmission)};
}

}  // namespace harness
