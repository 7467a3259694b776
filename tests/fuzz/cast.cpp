#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reference/cast/queries.h"
#include "tests/fuzz/properties.h"

std::string check_cast(std::string_view lines) {
    std::istringstream in{std::string(lines)};
    std::ostringstream out;
    const long malformed = reference::cast::answer_queries(in, out);
    long number = 0;
    long errors = 0;
    std::istringstream answers(out.str());
    for (std::string text; std::getline(answers, text);) {
        ++number;
        const auto json = nlohmann::json::parse(text, nullptr, false);
        if (!json.is_object()) return "an answer is no JSON object: " + text;
        if (!json.contains("error")) continue;
        ++errors;
        if (json.at("line") != number) return "an error names a different line: " + text;
    }
    if (errors != malformed) return "the malformed lines are counted otherwise";
    const auto ends = std::count(lines.begin(), lines.end(), '\n');
    const bool has_rest = !lines.empty() && lines.back() != '\n';
    return number == ends + (has_rest ? 1 : 0) ? "" : "there is not an answer for each line";
}
