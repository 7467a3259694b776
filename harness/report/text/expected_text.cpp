#include "harness/report/text/expected_text.h"

#include <fmt/format.h>

namespace harness::report {
namespace {

using reference::Numbers;
using reference::Shape;

std::string number_text(double x) {
    return fmt::format("{:.6g}", x == 0 ? 0.0 : x);  // no "-0"
}

enum class Lines { rows, columns };

/// A column-major matrix, one row or column per line.
std::string matrix_text(const Numbers& columns, std::size_t size, Lines lines) {
    std::string text = lines == Lines::rows ? "by rows" : "by columns";
    for (std::size_t line = 0; line < size; ++line) {
        text += "\n[";
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t place = lines == Lines::rows ? i * size + line : line * size + i;
            text += (i == 0 ? "" : "  ") + number_text(columns.at(place));
        }
        text += "]";
    }
    return text;
}

std::string numbers_text(const Numbers& numbers, Shape shape) {
    if (shape == Shape::scalar) return number_text(numbers.front());
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "(" : ", ") + number_text(x);
    return text + ")";
}

ExpectedText expected_text(const reference::Value& value, Shape shape) {
    if (const auto* numbers = std::get_if<Numbers>(&value)) {
        const bool is_matrix = shape == Shape::matrix3 || shape == Shape::matrix4;
        const std::size_t size = shape == Shape::matrix3 ? 3 : 4;
        if (!is_matrix) return {numbers_text(*numbers, shape), ""};
        return {matrix_text(*numbers, size, Lines::rows), matrix_text(*numbers, size, Lines::columns)};
    }
    if (const auto* first = std::get_if<reference::FirstObject>(&value)) return {reference::sentence(*first), ""};
    return {"none", ""};
}

}  // namespace

ExpectedTexts expected_texts(const reference::AnswerKey& key) {
    ExpectedTexts texts;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items)
            texts[item.spec.id] = expected_text(item.answers.front().value, item.spec.shape);
    }
    return texts;
}

}  // namespace harness::report
