#include "harness/report/text/reading_text.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "harness/mark/score/doubts_text.h"
#include "harness/report/text/columns.h"
#include "harness/report/text/read_lines.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

constexpr std::size_t widest = 56;
constexpr std::size_t most_lines = 2000;

std::string name_of(const QuestionScore& question, const ItemScore& item) {
    return fmt::format("{}.{}", question.number, item.spec.name);
}

/// The answer that was read from a line: "6.t right".
std::string read_as(const ReadAnswer& answer) {
    return answer.item + " " + std::string(to_string(answer.verdict));
}

std::vector<std::string> read_as(const std::vector<ReadAnswer>& answers) {
    std::vector<std::string> names;
    for (const ReadAnswer& answer : answers) names.push_back(read_as(answer));
    return names;
}

}  // namespace

std::string reading_text(std::string_view output, const Score& score) {
    std::string text;
    int number = 0;
    std::map<int, std::vector<ReadAnswer>> answers = answers_by_line(score);
    for (const std::string_view line : printout_lines(output, most_lines)) {
        std::string names;
        for (const ReadAnswer& answer : answers[++number])
            names += (names.empty() ? "" : ", ") + read_as(answer) + (answer.by_order ? " (by order)" : "");
        std::string shown = one_line(std::string(line.substr(0, 4 * widest)));
        if (names.empty()) {
            text += fmt::format("{:>5}  {}\n", number, shown);
        } else {
            text += fmt::format("{:>5}  {}  <- {}\n", number, padded(shown, widest), names);
        }
    }
    std::string missing;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::missing)
                missing += (missing.empty() ? "" : ", ") + name_of(question, item);
        }
    }
    if (!missing.empty()) text += "\nnot found: " + missing + "\n";
    if (const std::string doubts = doubts_text(score, Audience::instructor); !doubts.empty())
        text += "\npossibly misread: " + doubts + "\n";
    return text + fmt::format("\n{} of {} points\n", points_text(score.points), points_text(score.max_points));
}

std::string reading_json(std::string_view output, const Score& score) {
    using nlohmann::ordered_json;
    ordered_json lines = ordered_json::array(), items = ordered_json::array();
    int number = 0;
    std::map<int, std::vector<ReadAnswer>> answers = answers_by_line(score);
    for (const std::string_view line : printout_lines(output, most_lines)) {
        ++number;
        lines.push_back({{"number", number},
                         {"text", escape_control(line.substr(0, 4 * widest))},
                         {"read_as", read_as(answers[number])}});
    }
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            const auto or_null = [](int line) { return line == 0 ? ordered_json() : ordered_json(line); };
            items.push_back({{"question", question.number},
                             {"name", item.spec.name},
                             {"verdict", to_string(item.verdict)},
                             {"printed", escape_control(item.printed)},
                             {"line", or_null(item.line)},
                             {"last_line", or_null(item.last_line)},
                             {"found_by", item.line == 0  ? ordered_json()
                                          : item.by_order ? "order"
                                                          : "label"},
                             {"doubt", item.doubt ? ordered_json(to_string(item.doubt->why)) : ordered_json()},
                             {"look_at", or_null(item.doubt ? item.doubt->line : 0)}});
        }
    }
    const ordered_json all{{"schema", "raygrade/reading/1"},
                           {"points", score.points},
                           {"max_points", score.max_points},
                           {"lines", lines},
                           {"items", items}};
    return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace harness::report
