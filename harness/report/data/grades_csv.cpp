#include "harness/report/data/grades_csv.h"

#include <fmt/format.h>

#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/data/csv_cell.h"
#include "harness/text/points.h"

namespace harness::report {

namespace {

/// The places where the instructor has overridden automatic marks: "6.t 8".
std::string overridden(const Graded& graded) {
    std::string places;
    for (const Override& given : graded.review.overrides) {
        if (points_at(graded.score, given)) places += (places.empty() ? "" : " ") + place_of(given);
    }
    return places;
}

/// The flags that an instructor should still check, by name.
std::string flags_of(const Graded& graded) {
    std::string kinds;
    for (const Flag& flag : open_flags(graded)) kinds += (kinds.empty() ? "" : " ") + flag.kind;
    return kinds;
}

}  // namespace

std::string grades_csv(const std::vector<Graded>& graded) {
    std::string text = "id,outcome,points,max_points";
    if (!graded.empty()) {
        for (const QuestionScore& question : graded.front().score.questions)
            text += fmt::format(",Q{}", question.number);
    }
    const bool has_scenes = !graded.empty() && graded.front().score.variants;
    text += fmt::format(",explanation,sandbox,automatic_points,late_deduction,overridden{},flags,name\r\n",
                        has_scenes ? ",other_scenes" : "");
    for (const Graded& result : graded) {
        const bool marked = result.execution.outcome != Outcome::not_graded;
        const auto mark = final_mark(result);
        text += fmt::format("{},{},{},{}", csv_cell(result.submission.id), to_string(result.execution.outcome),
                            mark ? points_text(mark->points) : "", points_text(result.score.max_points));
        for (const QuestionScore& question : result.score.questions)
            text += "," + (marked ? points_text(final_points(result, question)) : "");
        text += fmt::format(",{},{},{},{},{}", csv_cell(result.execution.explanation), to_string(result.execution.tier),
                            marked ? points_text(result.score.points) : "",
                            mark ? points_text(mark->late_deduction) : "", csv_cell(overridden(result)));
        if (has_scenes) text += "," + (marked ? points_text(final_scenes_points(result)) : "");
        text += "," + csv_cell(flags_of(result)) + "," + csv_cell(result.submission.name) + "\r\n";
    }
    return text;
}

}  // namespace harness::report
