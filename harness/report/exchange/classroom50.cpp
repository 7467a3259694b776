#include "harness/report/exchange/classroom50.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/record/final_mark.h"
#include "harness/report/text/item_text.h"

namespace harness::report {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t longest_output = 5'000;

/// Rounds halves up, even if rounding errors in a sum of shares left it slightly below the half.
long whole(double points) {
    return std::max(0L, std::lround(points + 1e-9));
}

/// The tests with whole points: each test gets the increase of the rounded sum, so that no point is lost or gained.
ordered_json tests_json(const Graded& graded, const Marking& marking) {
    ordered_json tests = ordered_json::array();
    double points = 0, most = 0;
    for (const TestText& test : test_texts(graded, marking)) {
        const long score = whole(points + test.points) - whole(points);
        const long max_score = whole(most + test.max_points) - whole(most);
        points += test.points;
        most += test.max_points;
        tests.push_back({{"test-name", test.name},
                         {"passed", test.is_passed},
                         {"score", std::min(score, max_score)},
                         {"max-score", max_score},
                         {"points", std::round(test.points * 100) / 100},
                         {"output", bounded(test.text, longest_output)}});
    }
    return tests;
}

}  // namespace

std::string classroom50_result(const Graded& graded, const Marking& marking, const Classroom50Submission& submission) {
    const auto mark = final_mark(graded);
    if (!mark) throw std::logic_error("a result.json without points");
    const long max_score = whole(graded.score.max_points);
    ordered_json json{
        {"schema", classroom50_schema}, {"classroom", submission.classroom}, {"assignment", submission.assignment}};
    if (!submission.assignment_type.empty()) json["assignment_type"] = submission.assignment_type;
    if (!submission.owner.empty()) json["owner"] = submission.owner;
    json["submission"] = submission.tag;
    json["commit"] = submission.commit;
    json["release"] = submission.release;
    json["review"] = submission.review;
    json["datetime"] = submission.datetime;
    json["score"] = std::min(whole(mark->points), max_score);
    json["max-score"] = max_score;
    json["tests"] = tests_json(graded, marking);
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace harness::report
