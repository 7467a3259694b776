#include "harness/report/text/columns.h"

#include <algorithm>

#include "harness/text/escape.h"

namespace harness::report {
namespace {

bool starts_a_code_point(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

}  // namespace

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::replace(text.begin(), text.end(), '\t', ' ');
    return escape_control(text);
}

std::size_t code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_a_code_point));
}

std::string padded(std::string_view text, std::size_t width) {
    std::string result;
    std::size_t columns = 0;
    for (const char c : text) {
        if (starts_a_code_point(c)) {
            if (columns == width) break;
            ++columns;
        }
        result += c;
    }
    return result + std::string(width - std::min(width, columns), ' ');
}

}  // namespace harness::report
