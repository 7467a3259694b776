#include <fmt/format.h>

#include "harness/report/csv_cell.h"
#include "harness/report/report.h"

namespace harness::report {

std::string grades_csv(const std::vector<Graded>& graded) {
    std::string text = "id,outcome,points,max_points";
    if (!graded.empty()) {
        for (const QuestionScore& question : graded.front().score.questions)
            text += fmt::format(",Q{}", question.number);
    }
    text += ",explanation,sandbox\r\n";
    for (const Graded& one : graded) {
        const bool marked = one.outcome != Outcome::not_graded;
        text += fmt::format("{},{},{},{}", csv_cell(one.submission.id), to_string(one.outcome),
                            marked ? points_text(one.score.points) : "", points_text(one.score.max_points));
        for (const QuestionScore& question : one.score.questions)
            text += "," + (marked ? points_text(question.points) : "");
        text += "," + csv_cell(one.explanation) + "," + std::string(to_string(one.tier)) + "\r\n";
    }
    return text;
}

}  // namespace harness::report
