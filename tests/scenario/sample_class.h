// The sample class as parameters of tests.
#pragma once

#include <cctype>
#include <ostream>
#include <string>

namespace scenario {

struct Sample {
    std::string name;  ///< its folder in submissions/: "ines", "2024/akira"
};

/// The name, with "_" for each character that GoogleTest does not allow in test names.
inline std::string test_name(const Sample& sample) {
    std::string name;
    for (const char c : sample.name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool continues_a_character = (byte & 0xC0U) == 0x80U;
        if (!continues_a_character) name += std::isalnum(byte) != 0 ? c : '_';
    }
    return name;
}

// GoogleTest prints an extra line for a name that is not ASCII, and ctest would take that line for a test.
inline void PrintTo(const Sample& sample, std::ostream* out) {
    *out << test_name(sample);
}

}  // namespace scenario
