#include "reference/key/key_formats.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace reference {
namespace {

using nlohmann::ordered_json;

std::string group(std::span<const double> numbers) {
    std::string text = "(";
    for (std::size_t i = 0; i < numbers.size(); ++i) text += fmt::format("{}{:.6f}", i == 0 ? "" : ", ", numbers[i]);
    return text + ")";
}

std::string matrix_text(std::span<const double> numbers, std::size_t size) {
    std::string text = fmt::format("mat{0}x{0}(", size);
    for (std::size_t column = 0; column < size; ++column) {
        text += (column == 0 ? "" : ", ") + group(numbers.subspan(column * size, size));
    }
    return text + ")";
}

/// A scalar as a number, a vector as an array, a matrix as an array of columns.
ordered_json shaped(const Numbers& numbers, Shape shape) {
    if (shape == Shape::scalar) return numbers.front();
    if (shape == Shape::vector) return numbers;
    const std::size_t size = shape == Shape::matrix3 ? 3 : 4;
    ordered_json columns = ordered_json::array();
    for (std::size_t column = 0; column < size; ++column) {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(column * size);
        columns.push_back(Numbers(begin, begin + static_cast<std::ptrdiff_t>(size)));
    }
    return columns;
}

void add_enclosure(ordered_json& json, const Answer& answer, Shape shape) {
    if (answer.lo.empty()) return;
    json["lo"] = shaped(answer.lo, shape);
    json["hi"] = shaped(answer.hi, shape);
    const bool has_bound = std::isfinite(answer.allowance.front());
    json["allowance"] = has_bound ? shaped(answer.allowance, shape) : ordered_json();
    if (!has_bound) json["allowance_from"] = "none";
}

ordered_json item_json(const KeyItem& item, const AnswerKey& key) {
    ordered_json json{{"name", item.spec.name}, {"value", value_json(item.answers.front().value, item.spec.shape)}};
    add_enclosure(json, item.answers.front(), item.spec.shape);
    for (std::size_t i = 1; i < item.answers.size(); ++i) {
        const Answer& also = item.answers[i];
        json["also_accepted"].push_back(
            {{"value", value_json(also.value, item.spec.shape)}, {"because", reason(also, key)}});
    }
    return json;
}

/// Writes like dump(2), but numbers have 17 significant digits, so that neighbouring doubles look different.
void write(const ordered_json& json, const std::string& new_line, std::string& text) {
    if (json.is_number_float()) {
        text += fmt::format("{:.17g}", json.get<double>());
    } else if (json.is_structured() && !json.empty()) {
        const std::string inner = new_line + "  ";
        const bool is_object = json.is_object();
        text += is_object ? "{" : "[";
        std::string separator;
        for (const auto& [key, value] : json.items()) {
            text += separator + inner + (is_object ? ordered_json(key).dump() + ": " : "");
            write(value, inner, text);
            separator = ",";
        }
        text += new_line + (is_object ? "}" : "]");
    } else {
        text += json.dump();
    }
}

}  // namespace

std::string value_text(const Value& value, Shape shape) {
    if (std::holds_alternative<NoValue>(value)) return "none";
    if (const FirstObject* first = std::get_if<FirstObject>(&value)) return sentence(*first);
    const Numbers& numbers = std::get<Numbers>(value);
    switch (shape) {
        case Shape::scalar: return fmt::format("{:.6g}", numbers.front());
        case Shape::vector: return "vec3" + group(numbers);
        case Shape::matrix3: return matrix_text(numbers, 3);
        case Shape::matrix4: return matrix_text(numbers, 4);
        case Shape::first_object: return "";
    }
    return "";
}

ordered_json value_json(const Value& value, Shape shape) {
    if (std::holds_alternative<NoValue>(value)) return nullptr;
    if (const FirstObject* first = std::get_if<FirstObject>(&value)) return sentence(*first);
    return shaped(std::get<Numbers>(value), shape);
}

std::string to_text(const AnswerKey& key) {
    std::string text;
    for (const KeyQuestion& question : key.questions) {
        text += fmt::format("Question {}:\n", question.number);
        for (const KeyItem& item : question.items) {
            const std::string_view label = item.spec.label;
            text += fmt::format("{}{}{}\n", label, label.empty() ? "" : ": ",
                                value_text(item.answers.front().value, item.spec.shape));
        }
    }
    return text;
}

std::string to_json(const AnswerKey& key) {
    ordered_json json{{"schema", "raygrade/key/1"},
                      {"assignment", key.assignment},
                      {"precision", to_string(key.precision)},
                      {"questions", ordered_json::array()}};
    for (const KeyQuestion& question : key.questions) {
        ordered_json items = ordered_json::array();
        for (const KeyItem& item : question.items) items.push_back(item_json(item, key));
        json["questions"].push_back({{"number", question.number}, {"items", items}});
    }
    ordered_json decisions = ordered_json::object();
    for (const auto& [object, decision] : key.decisions.objects) decisions[std::string(to_string(object))] = decision;
    if (!key.decisions.first.empty()) decisions["first"] = key.decisions.first;
    decisions["policy"] = key.decisions.policy;
    json["decisions"] = decisions;
    if (!key.notes.empty()) json["notes"] = key.notes;
    std::string text;
    write(json, "\n", text);
    return text + "\n";
}

}  // namespace reference
