#include "harness/report/text/expected_text.h"

#include <fmt/format.h>

namespace harness::report {
namespace {

using reference::Numbers;
using reference::Shape;

std::string number_text(double x) {
    return fmt::format("{:.6g}", x == 0 ? 0.0 : x);  // no "-0"
}

/// A column-major matrix, one row per line.
std::string matrix_text(const Numbers& columns, std::size_t size) {
    std::string text;
    for (std::size_t row = 0; row < size; ++row) {
        text += row == 0 ? "[" : "\n[";
        for (std::size_t column = 0; column < size; ++column)
            text += (column == 0 ? "" : "  ") + number_text(columns.at(column * size + row));
        text += "]";
    }
    return text;
}

std::string numbers_text(const Numbers& numbers, Shape shape) {
    switch (shape) {
        case Shape::scalar: return number_text(numbers.front());
        case Shape::matrix3: return matrix_text(numbers, 3);
        case Shape::matrix4: return matrix_text(numbers, 4);
        case Shape::vector:
        case Shape::verdict: break;
    }
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "(" : ", ") + number_text(x);
    return text + ")";
}

std::string expected_text(const reference::Value& value, Shape shape) {
    if (const auto* numbers = std::get_if<Numbers>(&value)) return numbers_text(*numbers, shape);
    if (const auto* verdict = std::get_if<reference::Verdict>(&value)) return reference::sentence(*verdict);
    return "none";
}

}  // namespace

std::map<reference::ItemId, std::string> expected_texts(const reference::AnswerKey& key) {
    std::map<reference::ItemId, std::string> texts;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items)
            texts[item.spec.id] = expected_text(item.answers.front().value, item.spec.shape);
    }
    return texts;
}

}  // namespace harness::report
