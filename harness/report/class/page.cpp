#include "harness/report/class/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "harness/execution/tier.h"
#include "harness/report/class/sheet.h"
#include "harness/report/class/statistics.h"
#include "harness/report/class/table.h"
#include "harness/report/class/wrong_answers.h"
#include "harness/report/page/page_template.h"
#include "harness/report/page/templates.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

PageData tiles_of(const ClassStatistics& statistics) {
    PageData tiles(PageData::type::list);
    const auto add = [&](const char* what, const std::string& value, const char* filter = "") {
        PageData tile;
        set_text(tile, "filter", filter);
        tile["what"] = what;
        tile["value"] = value;
        tiles.push_back(tile);
    };
    add("submissions", std::to_string(statistics.handed_in), "all");
    if (statistics.marked != statistics.handed_in) add("with a mark", std::to_string(statistics.marked));
    const std::string most = " of " + points_text(statistics.max_points);
    if (statistics.mean) add("mean", points_text(*statistics.mean) + most);
    if (statistics.median) add("median", points_text(*statistics.median) + most);
    if (statistics.late > 0) add("late", std::to_string(statistics.late), "late");
    if (statistics.to_review > 0) add("to review", std::to_string(statistics.to_review), "review");
    if (statistics.overridden > 0) add("with an override", std::to_string(statistics.overridden), "override");
    return tiles;
}

PageData outcomes_of(const ClassStatistics& statistics, const Students& students) {
    return list_of(statistics.outcomes, [&](PageData& outcome, const OutcomeCount& outcome_count) {
        outcome["outcome"] = outcome_words(outcome_count.outcome);
        outcome["filter"] = std::string(to_string(outcome_count.outcome));
        outcome["count"] = std::to_string(outcome_count.who.size());
        // Most programs finished; the table lists those anyway.
        outcome["who"] = outcome_count.outcome == Outcome::graded ? "all others" : students.links_to(outcome_count.who);
    });
}

/// The number of students by points: the bars, and the choices of the filter.
PageData bins_of(const ClassStatistics& statistics) {
    PageData bins(PageData::type::list);
    for (std::size_t bin = 0; bin < statistics.distribution.size(); ++bin) {
        const double from = statistics.bin_width * static_cast<double>(bin), below = from + statistics.bin_width;
        const bool is_last = bin + 1 == statistics.distribution.size();
        PageData page_data;
        page_data["from"] = points_text(from);
        page_data["count"] = std::to_string(statistics.distribution[bin]);
        page_data["below"] = is_last ? "Infinity" : points_text(below);
        page_data["words"] = is_last ? points_text(from) + " or more"
                                     : fmt::format("{} to below {}", points_text(from), points_text(below));
        bins.push_back(page_data);
    }
    return bins;
}

PageData items_of(const ClassStatistics& statistics) {
    return list_of(statistics.items, [&](PageData& item, const ItemTally& tally) {
        item["number"] = std::to_string(tally.spec.question);
        item["question_title"] = tally.question_title;
        item["name"] = name_in_question(tally.spec);
        item["right"] = std::to_string(tally.right);
        item["follow"] = std::to_string(tally.follow);
        item["wrong"] = std::to_string(tally.wrong);
        item["missing"] = std::to_string(tally.missing);
    });
}

/// The wrong answers of all questions that the most students share.
PageData most_shared(const std::vector<QuestionMistakes>& mistakes) {
    constexpr std::size_t most = 6;
    std::vector<const WrongAnswer*> answers;
    for (const QuestionMistakes& question : mistakes) {
        for (const WrongAnswer& answer : question.answers) {
            const bool explains = answer.verdict != ItemVerdict::missing && !answer.differing;
            if (explains && answer.who.size() > 1) answers.push_back(&answer);
        }
    }
    std::stable_sort(answers.begin(), answers.end(),
                     [](const WrongAnswer* a, const WrongAnswer* b) { return a->who.size() > b->who.size(); });
    answers.resize(std::min(answers.size(), most));
    PageData shared(PageData::type::list);
    for (const WrongAnswer* answer : answers) {
        PageData page_data;
        page_data["question"] = std::to_string(answer->spec.question);
        page_data["shared_count"] = std::to_string(answer->who.size());
        page_data["shared_item"] = name_in_question(answer->spec);
        set_text(page_data, "shared_name", answer->diagnosis);
        page_data["shared_sentence"] = answer->sentence;
        shared.push_back(page_data);
    }
    return shared;
}

void fill_in_group(PageData& group, const WrongAnswer& answer, const Students& students) {
    constexpr std::size_t many = 12;
    group["count"] = std::to_string(answer.who.size());
    group["name"] = answer.whole_question ? "whole question" : name_in_question(answer.spec);
    group["verdict"] = std::string(to_string(answer.verdict));
    group["verdict_word"] = answer.differing ? "wrong, each differently" : std::string(word_of(answer.verdict));
    set_text(group, "diagnosis", answer.diagnosis);
    set_text(group, "printed", answer.printed);
    set_text(group, "sentence", answer.sentence);
    if (answer.who.size() > many) group["many"] = fmt::format("{} students", answer.who.size());
    group["who"] = students.links_to(answer.who);
}

PageData overview(const Students& students, bool has_sheets, const Marking& marking, Tier tier,
                  const std::string& compilers, const ClassStatistics& statistics,
                  const std::vector<QuestionMistakes>& mistakes) {
    const std::string style = std::string(templates::page_css) + std::string(templates::class_css);
    PageData data;
    data["policy"] = security_policy({style}, templates::class_js);
    data["style"] = style;
    data["script"] = std::string(templates::class_js);
    data["title"] = marking.assignment.title;
    data["assignment"] = marking.assignment.name;
    data["has_sheets"] = has_sheets;
    set_text(data, "compiler", compilers);
    set_text(data, "warning", sandbox_warning(tier));
    data["tiles"] = tiles_of(statistics);
    data["bins"] = bins_of(statistics);
    data["tallest"] = std::to_string(std::max<std::size_t>(1, std::ranges::max(statistics.distribution)));
    set_text(data, "marked", statistics.marked > 0 ? std::to_string(statistics.marked) : "");
    data["outcomes"] = outcomes_of(statistics, students);
    PageData shared = most_shared(mistakes);
    data["has_shared"] = shared.is_non_empty_list();
    data["shared"] = std::move(shared);
    data["has_items"] = !statistics.items.empty();
    data["printed"] = std::to_string(statistics.printed);
    data["items"] = items_of(statistics);
    return data;
}

void write_mistakes(std::ostream& out, const Students& students, const std::vector<QuestionMistakes>& mistakes) {
    PageTemplate section(templates::class_groups_mustache);
    out << "<section aria-labelledby=\"mistakes\">\n<h2 id=\"mistakes\">Mistakes by question</h2>\n";
    for (const QuestionMistakes& question : mistakes) {
        if (question.answers.empty()) continue;
        PageData data;
        data["number"] = std::to_string(question.question);
        data["question_title"] = question.title;
        if (question.following > 0) {
            data["following"] = fmt::format("Wrong in {} more {} only because of earlier answers.", question.following,
                                            question.following == 1 ? "program" : "programs");
        }
        data["groups"] = list_of(question.answers, [&](PageData& group, const WrongAnswer& answer) {
            fill_in_group(group, answer, students);
        });
        out << section.fill_in(data);
    }
    const bool none = std::all_of(mistakes.begin(), mistakes.end(),
                                  [](const QuestionMistakes& question) { return question.answers.empty(); });
    out << (none ? "<p>There are none.</p>\n</section>\n" : "</section>\n");
}

/// The filter and the table of students.
void write_students(std::ostream& out, const Students& students, bool has_sheets, const Marking& marking,
                    const ClassStatistics& statistics) {
    ClassTable table(students);
    PageData data;
    data["has_sheets"] = has_sheets;
    data["most_sheets"] = std::to_string(most_sheets);
    data["named"] = table.columns().named;
    data["dated"] = table.columns().dated;
    PageData numbers(PageData::type::list);
    for (const reference::KeyQuestion& question : marking.key.questions)
        numbers.push_back(std::to_string(question.number));
    data["numbers"] = std::move(numbers);
    data["outcomes"] = list_of(statistics.outcomes, [&](PageData& outcome, const OutcomeCount& outcome_count) {
        outcome["outcome"] = std::string(to_string(outcome_count.outcome));
        outcome["outcome_words"] = outcome_words(outcome_count.outcome);
    });
    data["bins"] = bins_of(statistics);
    out << PageTemplate(templates::class_table_mustache).fill_in(data);
    for (std::size_t i = 0; i < students.graded.size(); ++i) out << table.row(i);
    out << "</tbody></table></div>\n</section>\n";
}

void write_sheets(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking) {
    ClassSheets sheets(marking);
    out << "<section id=\"each\" aria-labelledby=\"each-title\">\n"
           "<h2 id=\"each-title\">Each student</h2>\n";
    for (std::size_t i = 0; i < graded.size(); ++i) out << sheets.sheet(graded[i], i);
    out << "</section>\n";
}

}  // namespace

void write_class_report(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier,
                        const PageOfStudent& page_of) {
    const bool has_sheets = graded.size() <= most_sheets;
    Students students{graded, {}};
    for (std::size_t i = 0; i < graded.size(); ++i)
        students.addresses.push_back(has_sheets ? fmt::format("#s{}", i + 1) : page_of(i));
    const std::vector<QuestionMistakes> mistakes = mistakes_by_question(graded);
    const ClassStatistics statistics = class_statistics(graded);
    const PageData data = overview(students, has_sheets, marking, tier, compilers_of(graded), statistics, mistakes);
    out << page_beginning << PageTemplate(templates::class_head_mustache).fill_in(data);
    write_students(out, students, has_sheets, marking, statistics);
    out << PageTemplate(templates::class_answers_mustache).fill_in(data);
    write_mistakes(out, students, mistakes);
    if (has_sheets) write_sheets(out, graded, marking);
    out << "</main>\n" << (has_sheets ? templates::class_panel_mustache : "") << "</body>\n</html>\n";
}

}  // namespace harness::report
