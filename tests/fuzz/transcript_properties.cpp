#include "tests/fuzz/transcript_properties.h"

#include <algorithm>

#include "harness/match/match.h"
#include "harness/read/transcript.h"

namespace {

using harness::MatchedItem;
using reference::Shape;

constexpr std::size_t longest_text = 2000;

int count_lines(std::string_view output) {
    // CR, LF and CR LF each end a line.
    return 2 +
           static_cast<int>(std::count_if(output.begin(), output.end(), [](char c) { return c == '\n' || c == '\r'; }));
}

bool has_the_shape(const MatchedItem& item) {
    const std::size_t count = item.value->numbers.size();
    if (item.unreadable || count == 0) return true;
    switch (item.spec.shape) {
        case Shape::scalar: return count == 1;
        case Shape::vector: return count == 3 || count == 4;
        case Shape::matrix3: return count == 9;
        case Shape::matrix4: return count == 16;
        case Shape::verdict: return false;
    }
    return false;
}

}  // namespace

std::string check_transcript(std::string_view output) {
    const harness::Transcript transcript = harness::read_transcript(output);
    const auto specs = reference::all_items();
    const std::vector<MatchedItem> matched = harness::match(transcript, specs);
    if (matched.size() != specs.size()) return "not every item once";
    const int lines = count_lines(output);
    for (std::size_t i = 0; i < matched.size(); ++i) {
        const MatchedItem& item = matched[i];
        if (item.spec.question != specs[i].question || item.spec.name != specs[i].name) return "items out of order";
        if (item.verdict &&
            (item.spec.shape != Shape::verdict || item.verdict->line < 1 || item.verdict->line > lines)) {
            return "a verdict beyond the output";
        }
        if (!item.value) continue;
        if (!has_the_shape(item)) return "a value of another shape";
        if (item.value->line < 1 || item.value->line > lines) return "a value beyond the output";
        if (item.value->printed.size() > longest_text) return "a text beyond its limit";
    }
    return {};
}
