#include "harness/intake/lms/lms_name.h"

#include <fmt/format.h>
#include <re2/re2.h>

namespace harness {
namespace {

re2::StringPiece piece(std::string_view text) {
    return {text.data(), text.size()};
}

}  // namespace

std::vector<LmsName> canvas_readings(std::string_view file) {
    static const RE2 after_name(R"((?s)(LATE_)?(?:(\d+)|anon_([^_]+))_(?:(\d+)_(.+)|(text|link)\.html))");
    std::vector<LmsName> readings;
    for (std::size_t begin = 0; begin < file.size(); ++begin) {  // the part after the student's name
        if (begin > 0 && file[begin - 1] != '_') continue;
        LmsName name;
        std::string late, user, anonymous, kind;
        if (!RE2::FullMatch(piece(file.substr(begin)), after_name, &late, &user, &anonymous, &name.attachment,
                            &name.file, &kind)) {
            continue;
        }
        name.student = file.substr(0, begin == 0 ? 0 : begin - 1);
        // Canvas writes students' names in lower case, so a LATE or an "anon" before the number is Canvas's.
        const auto ends_with = [&](std::string_view word) {
            return name.student == word || name.student.ends_with("_" + std::string(word));
        };
        if (ends_with("LATE") || ends_with("anon")) continue;
        name.is_file = kind.empty();
        if (!name.is_file) name.file = kind + ".html";
        name.late = !late.empty();
        name.id = user.empty() ? "anon_" + anonymous : user;
        readings.push_back(std::move(name));
        if (readings.size() == most_readings) break;
    }
    return readings;
}

std::vector<LmsName> moodle_readings(std::string_view text) {
    static const RE2 after_name(R"((?s)_(\d+)_assignsubmission_(file|onlinetext)(?:_(.*))?)");
    std::vector<LmsName> readings;
    for (std::size_t begin = text.size(); begin-- > 0;) {
        if (text[begin] != '_') continue;
        LmsName name;
        name.system = Lms::moodle;
        std::string kind;
        if (!RE2::FullMatch(piece(text.substr(begin)), after_name, &name.id, &kind, &name.file)) continue;
        name.student = text.substr(0, begin);
        name.is_file = kind == "file";
        readings.push_back(std::move(name));
        if (readings.size() == most_readings) break;
    }
    return readings;
}

std::optional<LmsName> read_canvas_name(std::string_view file) {
    const auto readings = canvas_readings(file);
    return readings.empty() ? std::nullopt : std::optional(readings.front());
}

std::optional<LmsName> read_moodle_name(std::string_view name) {
    const auto readings = moodle_readings(name);
    return readings.empty() ? std::nullopt : std::optional(readings.front());
}

std::optional<LmsName> read_gradescope_name(std::string_view folder) {
    static const RE2 pattern(R"(submission_(\d+))");
    LmsName name;
    name.system = Lms::gradescope;
    if (!RE2::FullMatch(piece(folder), pattern, &name.id)) return std::nullopt;
    return name;
}

std::optional<LmsName> read_brightspace_name(std::string_view text) {
    static const RE2 pattern(
        R"((?s)(\d+-\d+ - (.+?)) ?- (\w{3})\w* (\d{1,2}), (\d{4}) (\d{1,2}):?(\d\d)(?: ([AP])M)?(?: ?- (.+))?)");
    static constexpr std::string_view months = "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec ";
    LmsName name;
    name.system = Lms::brightspace;
    std::string month, half;
    int day = 0, year = 0, hour = 0, minute = 0;
    if (!RE2::FullMatch(piece(text), pattern, &name.id, &name.student, &month, &day, &year, &hour, &minute, &half,
                        &name.file))
        return std::nullopt;
    const std::size_t at = months.find(month + ' ');
    if (at == std::string_view::npos) return std::nullopt;
    if (!half.empty()) hour = hour % 12 + (half == "P" ? 12 : 0);
    name.handed_in = fmt::format("{}-{:02}-{:02} {:02}:{:02}", year, at / 4 + 1, day, hour, minute);
    return name;
}

std::optional<LmsName> read_blackboard_name(std::string_view file) {
    static const RE2 pattern(R"((?s)(.*?_([^_]+))_attempt_(\d{4}-\d\d-\d\d)-(\d\d)-(\d\d)-(\d\d)(?:_(.+)|\.txt))");
    LmsName name;
    name.system = Lms::blackboard;
    std::string date, hour, minute, second;
    if (!RE2::FullMatch(piece(file), pattern, &name.id, &name.student, &date, &hour, &minute, &second, &name.file))
        return std::nullopt;
    name.is_file = !name.file.empty();
    if (!name.is_file) name.file = "comment.txt";
    name.handed_in = fmt::format("{} {}:{}:{}", date, hour, minute, second);
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
