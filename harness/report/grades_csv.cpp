#include <csv.h>
#include <fmt/format.h>

#include "harness/clean_text.h"
#include "harness/report/report.h"

namespace harness::report {
namespace {

/// A quoted cell. What a spreadsheet would compute is text behind an apostrophe.
std::string cell(const std::string& text) {
    std::string safe = escape_control(text);
    // Some spreadsheets overlook blanks before a formula.
    const std::size_t first = safe.find_first_not_of(' ');
    if (first != std::string::npos && std::string_view("=+-@\t\r").find(safe[first]) != std::string_view::npos)
        safe.insert(0, 1, '\'');
    std::string quoted(2 * safe.size() + 2, '\0');
    quoted.resize(csv_write(quoted.data(), quoted.size(), safe.data(), safe.size()));
    return quoted;
}

}  // namespace

std::string grades_csv(const std::vector<Graded>& graded) {
    std::string text = "id,outcome,points,max_points";
    if (!graded.empty()) {
        for (const QuestionScore& question : graded.front().score.questions)
            text += fmt::format(",Q{}", question.number);
    }
    text += ",explanation,sandbox\r\n";
    for (const Graded& one : graded) {
        const bool marked = one.outcome != Outcome::not_graded;
        text += fmt::format("{},{},{},{}", cell(one.submission.id), to_string(one.outcome),
                            marked ? points_text(one.score.points) : "", points_text(one.score.max_points));
        for (const QuestionScore& question : one.score.questions)
            text += "," + (marked ? points_text(question.points) : "");
        text += "," + cell(one.explanation) + "," + std::string(to_string(one.tier)) + "\r\n";
    }
    return text;
}

}  // namespace harness::report
