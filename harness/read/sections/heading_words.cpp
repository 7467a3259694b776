#include "harness/read/sections/heading_words.h"

#include <algorithm>
#include <array>
#include <string>

#include "harness/text/plain_word.h"

namespace harness {

int spelled_number(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 4>, 10> words = {{
        {"one", "eins", "uno"},
        {"two", "zwei", "dos"},
        {"three", "drei", "tres"},
        {"four", "vier", "cuatro"},
        {"five", "funf", "cinco", "fuenf"},
        {"six", "sechs", "seis"},
        {"seven", "sieben", "siete"},
        {"eight", "acht", "ocho"},
        {"nine", "neun", "nueve"},
        {"ten", "zehn", "diez"},
    }};
    const std::string plain = plain_letters(word);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!plain.empty() && std::ranges::find(words.at(i), plain) != words.at(i).end())
            return static_cast<int>(i) + 1;
    }
    return 0;
}

std::size_t end_of(std::string_view start, std::size_t length) {
    const bool number_goes_on = length < start.size() && (is_digit(start[length]) || start[length] == '.');
    return length > 0 && start[length - 1] == '-' && number_goes_on ? length - 1 : length;
}

}  // namespace harness
