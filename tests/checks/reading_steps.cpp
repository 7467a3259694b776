// reading_steps SIZE PATTERN…: finds the scene in a malicious source of SIZE bytes and in one of twice as many, for
// each pattern. reading_growth counts the instructions.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "harness/source/scene/scene_literals.h"
#include "reference/toml/assignment.h"

namespace {

std::string repeated(const std::string& piece, std::size_t size) {
    std::string text;
    while (text.size() < size) text += piece;
    return text;
}

std::string nasty_source(const std::string& pattern, std::size_t size) {
    const std::map<std::string, std::string> pieces = {
        {"open_brackets", "("},
        {"closed_brackets", ")"},
        {"mixed_brackets", "([{<"},
        {"indexes", "[0]"},
        {"candidates", "vec3 eye(0, 0, 4);\n"},
        {"one_list", "0, 0, 4, "},
        {"assignments", "eye.x = "},
        {"scopes", "a::"},
        {"minuses", "-"},
        {"digits", "1"},
        {"digit_separators", "1'"},
        {"raw_strings", "R\"x("},
        {"quotes", "\"\n"},
        {"comments", "/*"},
        {"defines", "#define EYE vec3(0, 0, 4)\n"},
        {"conditions", "#if 0\n"},
        {"spliced_lines", "\\\n"},
        {"comma_brackets", "((((,"},
        {"open_lists", "{0,"},
        {"vectors", "(0,0,4),"},
        {"open_defines", "#define A (\n"},
        {"open_conditions", "#if X\n"},
        {"open_indexes", "eye["},
        {"members", "a."},
        {"negations", "=-"},
        {"index_ends", "]="},
        {"open_calls", "f(1,"},
    };
    if (pattern == "nested_lists") {
        const std::string half = repeated("{0, ", size / 2);
        return half + repeated("}", half.size() / 4);
    }
    if (pattern == "nested_calls") {
        const std::string half = repeated("f(0, 0, 4, ", size * 11 / 12);
        return "vec3 eye = " + half + std::string(half.size() / 11, ')');
    }
    return repeated(pieces.at(pattern), size);
}

}  // namespace

/// Reads `source`; callgrind counts what happens in here, each call for itself (tests/checks/reading_growth).
extern "C" [[gnu::noinline]] void measured_reading(const std::string& source,
                                                   const harness::source::DecimalScene& scene) {
    const auto found = harness::source::find_scene(source, scene);
    std::printf("%zu bytes, %zu numbers\n", source.size(), found.literals.size());
}

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const auto a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    const std::size_t size = std::strtoull(argv[1], nullptr, 10);
    measured_reading("", a6.scene);  // what only the first call does
    for (const std::string& pattern : std::vector<std::string>(argv + 2, argv + argc)) {
        measured_reading(nasty_source(pattern, size), a6.scene);
        measured_reading(nasty_source(pattern, 2 * size), a6.scene);
    }
}
