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

/// Rounds halves up, also if rounding in a sum of shares left it slightly below the half.
long whole(double points) {
    return std::max(0L, std::lround(points + 1e-9));
}

/// The tests with whole points: each gets what the rounded sum so far grows by, so that no point is lost or gained.
class Tests {
  public:
    void add(const std::string& name, double own, double own_most, bool passed, const std::string& output) {
        const long score = whole(points_ + own) - whole(points_);
        const long max_score = whole(most_ + own_most) - whole(most_);
        points_ += own;
        most_ += own_most;
        json_.push_back({{"test-name", name},
                         {"passed", passed},
                         {"score", std::min(score, max_score)},
                         {"max-score", max_score},
                         {"points", std::round(own * 100) / 100},
                         {"output", bounded(output, longest_output)}});
    }
    const ordered_json& json() const { return json_; }

  private:
    ordered_json json_ = ordered_json::array();
    double points_ = 0, most_ = 0;
};

ordered_json tests_json(const Graded& graded, const Marking& marking) {
    Tests tests;
    for (const QuestionScore& question : graded.score.questions) {
        const double own = final_points(graded, question);
        std::string output;
        for (const ItemScore& item : question.items) output += item_text(graded, question, item, marking);
        tests.add(fmt::format("Question {}: {}", question.number, question.title), own, question.max_points,
                  is_passed(own, question.max_points, question.verdict), output);
    }
    if (graded.score.variants) {
        const double own = final_scenes_points(graded), most = graded.score.variants->max_points;
        tests.add("Other scenes", own, most, is_passed(own, most, ItemVerdict::wrong), scenes_text(graded));
    }
    return tests.json();
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
