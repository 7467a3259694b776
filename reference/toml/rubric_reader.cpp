#include "reference/toml/rubric_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/stages/items.h"

namespace reference {
namespace {

constexpr double most_points = 1e6;

int read_question_number(const TomlTable& table, const std::string& key) {
    const bool is_number =
        key.size() <= 2 && std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_number || key.empty() || std::stoi(key) < 1 || std::stoi(key) > 10) {
        table.fail(key, "is not a question; the handout's questions are 1 to 10");
    }
    return std::stoi(key);
}

/// A share or points: a finite number in [least, most].
double read_amount(const TomlTable& table, std::string_view key, double least, double most) {
    const double value = table.decimal(key).to_double();
    if (!(least <= value && value <= most)) {
        table.fail(key, most < 1e6 ? fmt::format("must be from {} to {}", least, most)
                                   : fmt::format("must be {} or more", least));
    }
    return value;
}

/// Refuses a name that is not an item of the question, so that a misspelt name is not silently ignored.
void check_item(const TomlTable& items, int question, const std::string& item) {
    std::string names;
    for (const ItemSpec& spec : all_items()) {
        if (spec.question != question) continue;
        if (spec.name == item) return;
        names += (names.empty() ? "" : ", ") + std::string(spec.name);
    }
    items.fail(item, fmt::format("is not an item of question {}; there are {}", question, names));
}

void read_points(const TomlTable& table, Rubric& rubric) {
    for (const std::string& key : table.keys()) {
        const int question = read_question_number(table, key);
        if (!table.is_table(key)) {
            rubric.points[question] = read_amount(table, key, 0, most_points);
            continue;
        }
        const TomlTable items = table.table(key);
        double sum = 0;
        for (const std::string& item : items.keys()) {
            check_item(items, question, item);
            sum += rubric.item_points[question][item] = read_amount(items, item, 0, most_points);
        }
        rubric.points[question] = sum;
    }
}

void read_tolerance(const TomlTable& table, Rubric& rubric) {
    constexpr double widest = 1e6;
    for (const std::string& key : table.keys()) {
        if (key == "default") {
            rubric.tolerance = read_amount(table, key, 0, widest);
        } else if (table.is_table(key)) {
            const TomlTable items = table.table(key);
            const int question = read_question_number(table, key);
            for (const std::string& item : items.keys()) {
                check_item(items, question, item);
                rubric.item_tolerance[fmt::format("{}.{}", question, item)] = read_amount(items, item, 0, widest);
            }
        } else {
            rubric.item_tolerance[std::to_string(read_question_number(table, key))] =
                read_amount(table, key, 0, widest);
        }
    }
}

}  // namespace

Rubric read_rubric(const TomlTable& table) {
    table.allow_only({"pixel_conventions", "boundary", "follow_through", "follow_through_cap", "late_deduction",
                      "min_decimals", "points", "show_expected", "tolerance", "variant_points", "wrong_scene_credit"});
    Rubric rubric;
    if (table.has("pixel_conventions")) {
        rubric.pixel_conventions.clear();
        for (const std::string& name : table.strings("pixel_conventions")) {
            rubric.pixel_conventions.push_back(table.choice<PixelConvention>("pixel_conventions", name,
                                                                             {{"centre", PixelConvention::centre},
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
    if (table.has("follow_through")) rubric.follow_through = read_amount(table, "follow_through", 0, 1);
    if (table.has("follow_through_cap")) rubric.follow_through_cap = read_amount(table, "follow_through_cap", 0, 1);
    if (table.has("wrong_scene_credit")) rubric.wrong_scene_credit = read_amount(table, "wrong_scene_credit", 0, 1);
    if (table.has("late_deduction")) rubric.late_deduction = read_amount(table, "late_deduction", 0, 1);
    if (table.has("variant_points")) rubric.other_scene_points = read_amount(table, "variant_points", 0, most_points);
    if (table.has("min_decimals")) rubric.min_decimals = table.integer("min_decimals", 0, 9);
    if (table.has("show_expected")) rubric.show_expected = table.boolean("show_expected");
    if (table.has("points")) read_points(table.table("points"), rubric);
    if (table.has("tolerance")) read_tolerance(table.table("tolerance"), rubric);
    return rubric;
}

}  // namespace reference
