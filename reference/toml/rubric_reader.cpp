#include "reference/toml/rubric_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

/// Refuses a question that is not asked, so that its points are not silently lost.
const Question& read_question(const TomlTable& table, const std::string& key, const std::vector<Question>& questions) {
    const auto found =
        std::ranges::find(questions, key, [](const Question& question) { return std::to_string(question.number); });
    if (found != questions.end()) return *found;
    std::vector<int> numbers;
    for (const Question& question : questions) numbers.push_back(question.number);
    table.fail(key,
               fmt::format("is not a question of this assignment; its questions are {}", fmt::join(numbers, ", ")));
}

/// Refuses a name that is not an item of the question, so that a misspelt name is not silently ignored.
void check_item(const TomlTable& items, const Question& question, const std::string& item) {
    std::vector<std::string_view> names;
    for (const ItemSpec& spec : asked_items({question})) names.push_back(spec.name);
    if (std::ranges::find(names, item) != names.end()) return;
    items.fail(item,
               fmt::format("is not an item of question {}; there are {}", question.number, fmt::join(names, ", ")));
}

void read_points(const TomlTable& table, const std::vector<Question>& questions, Rubric& rubric) {
    for (const std::string& key : table.keys()) {
        const Question& question = read_question(table, key, questions);
        if (rubric.points.contains(question.number)) table.fail(key, "also has points in its [[question]]; keep one");
        if (!table.is_table(key)) {
            rubric.points[question.number] = table.amount(key, 0, most_points);
            continue;
        }
        const TomlTable items = table.table(key);
        double sum = 0;
        for (const std::string& item : items.keys()) {
            check_item(items, question, item);
            sum += rubric.item_points[question.number][item] = items.amount(item, 0, most_points);
        }
        rubric.points[question.number] = sum;
    }
}

void read_tolerance(const TomlTable& table, const std::vector<Question>& questions, Rubric& rubric) {
    constexpr double widest = 1e6;
    for (const std::string& key : table.keys()) {
        if (key == "default") {
            rubric.tolerance = table.amount(key, 0, widest);
            continue;
        }
        const Question& question = read_question(table, key, questions);
        if (!table.is_table(key)) {
            rubric.item_tolerance[key] = table.amount(key, 0, widest);
            continue;
        }
        const TomlTable items = table.table(key);
        for (const std::string& item : items.keys()) {
            check_item(items, question, item);
            rubric.item_tolerance[fmt::format("{}.{}", key, item)] = items.amount(item, 0, widest);
        }
    }
}

std::string in_american_spelling(std::string name) {
    for (const auto& [british, american] : {std::pair("centre", "center"), std::pair("ormalise", "ormalize")}) {
        for (std::size_t at = name.find(british); at != std::string::npos; at = name.find(british, at))
            name.replace(at, std::string_view(british).size(), american);
    }
    return name;
}

void read_mistakes(const TomlTable& table, Rubric& rubric) {
    for (const std::string& key : table.keys()) {
        if (!table.is_table(key)) {
            rubric.mistakes.push_back({in_american_spelling(key), table.amount(key, 0, 1), table.place(key)});
            continue;
        }
        const Item* item = find_item(key);
        if (item == nullptr) table.fail(key, "is not an item; write e.g. \"sphere.normal\"");
        const TomlTable names = table.table(key);
        for (const std::string& name : names.keys()) {
            rubric.mistakes.push_back(
                {in_american_spelling(name), names.amount(name, 0, 1), names.place(name), item->id});
        }
    }
}

Moment read_due(const TomlTable& table) {
    const std::optional<Moment> due = parse_moment(table.moment_text("due"));
    if (!due)
        table.fail(
            "due",
            "is not a date with a time; write \"2026-11-05 23:59\", or \"2026-11-05 23:59+01:00\" with a time zone");
    return *due;
}

Feedback read_level(const TomlTable& table, std::string_view key) {
    return table.choice<Feedback>(key, table.string(key),
                                  {{"verdict", Feedback::verdict},
                                   {"hint", Feedback::hint},
                                   {"mistake", Feedback::mistake},
                                   {"expected", Feedback::expected}});
}

void read_feedback(const TomlTable& table, Rubric& rubric) {
    if (table.has("feedback")) rubric.feedback = read_level(table, "feedback");
    if (table.has("feedback_after_due")) {
        rubric.feedback_after_due = read_level(table, "feedback_after_due");
        if (!rubric.due) table.fail("feedback_after_due", "also needs due, the deadline; add due");
    }
    if (table.has("show_expected") && table.boolean("show_expected")) {
        if (table.has("feedback") && rubric.feedback != Feedback::expected)
            table.fail("show_expected", "contradicts feedback; leave it out and write feedback = \"expected\"");
        rubric.feedback = Feedback::expected;
    }
}

std::vector<LateStep> read_late(const TomlTable& table) {
    if (table.has("late_deduction")) {
        if (table.has("late")) table.fail("late_deduction", "cannot be used with late; keep one of the two");
        const double share = table.amount("late_deduction", 0, 1);
        return share > 0 ? std::vector{LateStep{1, share}} : std::vector<LateStep>();
    }
    std::vector<LateStep> steps;
    if (!table.has("late")) return steps;
    for (const std::vector<Decimal>& row : table.decimal_rows("late", 2)) {
        const double days = row[0].to_double(), share = row[1].to_double();
        const int last = steps.empty() ? 0 : steps.back().days;
        if (!(days >= 1 && days <= 365 && days == std::floor(days)))
            table.fail("late", fmt::format("has {}, which is not a number of days; write a whole number from 1 to 365",
                                           row[0].text()));
        if (days <= last)
            table.fail("late", fmt::format("must have ascending days, but {} comes after {}", row[0].text(), last));
        if (!(0 <= share && share <= 1))
            table.fail("late", fmt::format("has {}, which is not a share of the points; write a number from 0 to 1",
                                           row[1].text()));
        if (!steps.empty() && share < steps.back().share)
            table.fail(
                "late",
                fmt::format("takes {} off from day {} on, but only {} from day {}; a later day must not cost less",
                            steps.back().share, last, share, days));
        steps.push_back({static_cast<int>(days), share});
    }
    return steps;
}

/// Nobody could earn anything then, not even on other scenes: these give a share of the points for right answers.
void refuse_no_points(const TomlTable& root, const std::vector<Question>& questions, const Rubric& rubric) {
    const auto is_paid = [&](const Question& question) { return rubric.points_of(question.number) > 0; };
    if (questions.empty() || std::ranges::any_of(questions, is_paid)) return;
    const std::string what = fmt::format(
        "is 0 for every question; give a question points above 0, or leave \"points\" out for {} per question",
        Rubric::points_per_question);
    for (const TomlTable& question : root.tables("question")) {
        if (question.has("points")) question.fail("points", what);
        for (const TomlTable& part : question.has("parts") ? question.tables("parts") : std::vector<TomlTable>()) {
            if (part.has("points")) part.fail("points", what);
        }
    }
    (root.has("rubric") ? root.table("rubric") : root).fail("points", what);
}

Rubric read_rubric_table(const TomlTable& root, const ReadQuestions& asked) {
    Rubric rubric;
    rubric.points = asked.points;
    rubric.item_points = asked.item_points;
    if (!root.has("rubric")) return rubric;
    const TomlTable table = root.table("rubric");
    table.allow_only({"pixel_conventions", "boundary", "due", "feedback", "feedback_after_due", "follow_through",
                      "follow_through_cap", "grace_minutes", "late", "late_deduction", "min_decimals", "mistakes",
                      "points", "show_expected", "tolerance", "variant_points", "wrong_scene_credit"});
    if (table.has("pixel_conventions")) {
        rubric.pixel_conventions.clear();
        for (const std::string& name : table.strings("pixel_conventions")) {
            rubric.pixel_conventions.push_back(table.choice<PixelConvention>("pixel_conventions", name,
                                                                             {{"center", PixelConvention::centre},
                                                                              {"centre", PixelConvention::centre},
                                                                              {"grid", PixelConvention::grid},
                                                                              {"corner", PixelConvention::corner}}));
        }
        if (rubric.pixel_conventions.empty()) table.fail("pixel_conventions", "must name at least one convention");
    }
    if (table.has("boundary")) {
        rubric.boundary = table.choice<BoundaryPolicy>("boundary", table.string("boundary"),
                                                       {{"positive", BoundaryPolicy::positive},
                                                        {"nonnegative", BoundaryPolicy::nonnegative},
                                                        {"either", BoundaryPolicy::either}});
    }
    if (table.has("follow_through")) rubric.follow_through = table.amount("follow_through", 0, 1);
    if (table.has("follow_through_cap")) rubric.follow_through_cap = table.amount("follow_through_cap", 0, 1);
    if (table.has("wrong_scene_credit")) rubric.wrong_scene_credit = table.amount("wrong_scene_credit", 0, 1);
    rubric.late = read_late(table);
    if (table.has("due")) rubric.due = read_due(table);
    if (table.has("grace_minutes")) rubric.grace_minutes = table.integer("grace_minutes", 0, 7 * 24 * 60);
    if (table.has("variant_points")) rubric.variant_points = table.amount("variant_points", 0, most_points);
    if (table.has("min_decimals")) rubric.min_decimals = table.integer("min_decimals", 0, 9);
    read_feedback(table, rubric);
    if (table.has("points")) read_points(table.table("points"), asked.questions, rubric);
    if (table.has("mistakes")) read_mistakes(table.table("mistakes"), rubric);
    if (table.has("tolerance")) read_tolerance(table.table("tolerance"), asked.questions, rubric);
    return rubric;
}

}  // namespace

Rubric read_rubric(const TomlTable& root, const ReadQuestions& asked) {
    Rubric rubric = read_rubric_table(root, asked);
    refuse_no_points(root, asked.questions, rubric);
    return rubric;
}

}  // namespace reference
