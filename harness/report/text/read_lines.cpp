#include "harness/report/text/read_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/mark/score/doubts_text.h"

namespace harness::report {

std::vector<std::string_view> printout_lines(std::string_view output, std::size_t most) {
    std::vector<std::string_view> lines;
    while (!output.empty() && lines.size() < most) {
        const std::size_t end = std::min(output.find_first_of("\r\n"), output.size());
        lines.push_back(output.substr(0, end));
        output.remove_prefix(end);
        const bool is_pair = output.starts_with("\r\n");
        output.remove_prefix(std::min<std::size_t>(output.size(), is_pair ? 2 : 1));
    }
    return lines;
}

std::string shown_item(std::string_view item) {
    const std::size_t dot = item.find('.');
    const std::string_view name = item.substr(dot + 1);
    return name_in_words(name) == name ? std::string(item) : fmt::format("question {}", item.substr(0, dot));
}

std::map<int, std::vector<ReadAnswer>> answers_by_line(const Score& score) {
    std::map<int, std::vector<ReadAnswer>> answers;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            const std::string name = fmt::format("{}.{}", question.number, item.spec.name);
            for (int line = item.line; item.line != 0 && line <= std::max(item.line, item.last_line); ++line)
                answers[line].push_back({name, item.verdict, line == item.line, item.by_order});
        }
    }
    return answers;
}

}  // namespace harness::report
