#include "harness/report/hard_cases/report.h"

#include <fmt/format.h>

#include "harness/report/hard_cases/picture.h"
#include "harness/text/markup.h"
#include "reference/hard_cases/answers.h"

namespace harness::report {
namespace {

using namespace reference::hard_cases;

std::string in_words(const Answer& answer) {
    const auto number = [&](std::size_t i, int digits) {
        return fmt::format("{:.{}g}", answer.numbers[i] == 0 ? 0 : answer.numbers[i], digits);  // no -0
    };
    if (answer.numbers.empty()) return std::string(answer.decision);
    if (answer.decision == "axis") return fmt::format("({}, {}, {})", number(0, 3), number(1, 3), number(2, 3));
    return fmt::format("{} {}", answer.decision, number(0, 8));
}

Answer truth_of(const Case& hard) {
    Answer truth{hard.decision, {}};
    for (const std::string_view number : hard.numbers) truth.numbers.push_back(quoted(number).value);
    return truth;
}

std::string_view kind_of(const Case& hard) {
    constexpr std::array<std::string_view, 5> kinds{"sphere", "triangle", "cylinder", "two objects", "camera"};
    return kinds.at(hard.target.index());
}

constexpr double columns = 8, cell_width = 112, cell_height = 104;

std::string cell(const Case& hard, std::size_t place, const std::array<Answer, 3>& answers,
                 const std::array<bool, 3>& right) {
    std::string words =
        fmt::format("{}, {} {}. True: {}.", hard.id, kind_of(hard), hard.group, in_words(truth_of(hard)));
    std::string verdicts;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const std::string_view name = to_string(arithmetics[i]);
        words += fmt::format(" {}: {}{}.", name, in_words(answers[i]), right[i] ? "" : ", wrong");
        constexpr std::array at{-50, -18, 18};
        verdicts +=
            fmt::format(R"(<text x="{}" y="48" fill="{}"{}>{}</text>)", at.at(i), right[i] ? "#1a6b2f" : "#b3261e",
                        right[i] ? "" : R"( text-decoration="line-through")", name);
    }
    const double x = cell_width * (static_cast<double>(place % 8) + 0.5),
                 y = cell_height * static_cast<double>(place / 8);
    return fmt::format(
        "<g transform=\"translate({} {})\"><title>{}</title><text text-anchor=\"middle\" y=\"-31\" "
        "font-weight=\"bold\">{}</text><g stroke=\"#333\" fill=\"none\" stroke-linejoin=\"round\">{}</g>{}"
        "<text text-anchor=\"middle\" y=\"37\">{}</text></g>\n",
        x, y + 96, escape_markup(words), escape_markup(hard.id), drawing_of(hard), verdicts, escape_markup(hard.group));
}

}  // namespace

HardCasesReport hard_cases_report() {
    HardCasesReport report;
    const std::vector<Case>& all = cases();
    std::array<std::size_t, 3> wrong{};
    report.text = fmt::format("{:<14}{:<28}{:<19}{:<20}{:<20}{}\n", "case", "", "true", "float", "double", "certified");
    std::string cells;
    for (std::size_t place = 0; place < all.size(); ++place) {
        const Case& hard = all[place];
        std::array<Answer, 3> answers;
        std::array<bool, 3> right{};
        std::string row = fmt::format("{:<14}{:<28}{:<19}", hard.id, fmt::format("{}, {}", kind_of(hard), hard.group),
                                      in_words(truth_of(hard)));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            answers[i] = answer(hard, arithmetics[i]);
            right[i] = is_right(hard, answers[i]);
            if (!right[i]) ++wrong[i];
            row += fmt::format("{}{:<19}", right[i] ? " " : "*", in_words(answers[i]));
        }
        report.text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
        cells += cell(hard, place, answers, right);
    }
    report.passes = wrong[2] == 0;
    const std::string result = fmt::format(
        "Of {} hard cases, float gets {} wrong, double {}, and the certified arithmetic {}: {}.", all.size(), wrong[0],
        wrong[1], wrong[2] == 0 ? "none" : std::to_string(wrong[2]), report.passes ? "pass" : "FAIL");
    const std::string advice =
        "Use double. Refuse lengths that are 0 or not finite. Where one sign decides, decide it exactly.";
    report.text +=
        fmt::format("\n{}\n* wrong: a different decision or fewer than 5 right digits.\n{}\n", result, advice);
    const double height = 62 + cell_height * static_cast<double>((all.size() + 7) / 8);
    report.svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"hard-t\" width=\"{0}\" "
        "height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"9\" "
        "fill=\"#333\">\n<title id=\"hard-t\">{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
        "<text x=\"8\" y=\"22\" font-size=\"15\" font-weight=\"bold\">{2}</text>\n<text x=\"8\" y=\"40\" "
        "font-size=\"12\">Struck out: a different decision or fewer than 5 right digits.</text>\n{3}</svg>\n",
        columns * cell_width, height, escape_markup(result), cells);
    report.page = fmt::format(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>Hard cases</title>\n<style>"
        "body {{ margin: 0 auto; max-width: 56rem; padding: 1rem; background: #fff; color: #222; font: 1rem/1.5 "
        "system-ui, sans-serif; }} svg {{ width: 100%; height: auto; }} pre {{ overflow-x: auto; font-size: 0.75rem; }}"
        "</style>\n</head>\n<body>\n<main>\n<h1>Hard cases</h1>\n<p>{}</p>\n{}<details>\n<summary>The answers of each "
        "answers</summary>\n<pre>{}</pre>\n</details>\n</main>\n</body>\n</html>\n",
        advice, report.svg, escape_markup(report.text));
    return report;
}

}  // namespace harness::report
