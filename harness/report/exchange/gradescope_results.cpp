#include "harness/report/exchange/gradescope_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/record/final_mark.h"
#include "harness/report/text/item_text.h"

namespace harness::report {
namespace {

using nlohmann::ordered_json;

// Together below 100,000.
constexpr std::size_t longest_of_the_whole = 40'000;
constexpr std::size_t longest_of_all_tests = 55'000;

std::size_t longest_of_a_test(const Score& score) {
    return std::min<std::size_t>(5'000, longest_of_all_tests / (score.questions.size() + 1));
}

double two_decimals(double points) {
    return std::round(points * 100) / 100;
}

ordered_json test_json(const TestText& test, std::size_t longest) {
    // Without a number, Gradescope uses the position in the list, which differs from the question's number if the
    // assignment skips questions.
    return {{"name", test.name},
            {"number", std::to_string(test.number)},
            {"score", two_decimals(test.points)},
            {"max_score", two_decimals(test.max_points)},
            {"status", test.is_passed ? "passed" : "failed"},
            {"output", bounded(test.text, longest)},
            {"output_format", "text"},
            {"visibility", "visible"}};
}

/// The settings are the same for all tests. They come before the output, which may be long.
void add_output(ordered_json& json, const std::string& output) {
    json["output_format"] = "text";
    json["test_output_format"] = "text";
    json["test_name_format"] = "text";
    json["visibility"] = "visible";
    json["stdout_visibility"] = "hidden";
    json["output"] = bounded(output, longest_of_the_whole);
}

std::string text_of(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string gradescope_without_score(const std::string& output) {
    ordered_json json;
    add_output(json, output);
    json["extra_data"] = {{"outcome", to_string(Outcome::not_graded)}};
    return text_of(json);
}

std::string gradescope_results(const Graded& graded, const Marking& marking) {
    ordered_json json;
    const auto mark = final_mark(graded);
    if (mark) json["score"] = two_decimals(mark->points);
    json["execution_time"] =
        static_cast<double>((graded.execution.build.wall + graded.execution.run.wall).count()) / 1000.0;
    add_output(json, submission_text(graded));
    json["extra_data"] = {{"outcome", to_string(graded.execution.outcome)}};
    const auto& lms = graded.submission.lms;
    if (lms && lms->late) json["extra_data"]["late"] = *lms->late;
    if (mark && graded.execution.outcome != Outcome::not_graded) {
        json["tests"] = ordered_json::array();
        for (const TestText& test : test_texts(graded, marking))
            json["tests"].push_back(test_json(test, longest_of_a_test(graded.score)));
    }
    return text_of(json);
}

}  // namespace harness::report
