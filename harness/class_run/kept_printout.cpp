#include "harness/class_run/kept_printout.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/grade/reread.h"
#include "harness/machine/errors.h"
#include "harness/match/item_place.h"
#include "harness/report/text/sentences.h"
#include "harness/text/escape.h"

namespace harness {
namespace {

/// "line 12 holds 3 numbers", or that the printout has no such line.
std::string what_stands_at(const ItemPlace& place, const Transcript& transcript, const std::string& lines) {
    int last = 0;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) last = std::max(last, line.number);
    }
    if (place.first_line > last)
        return fmt::format("the output has no line {}, its last is {}", place.first_line, last);
    const std::size_t count = numbers_at(transcript, place);
    const bool is_one = place.first_line == place.last_line;
    return fmt::format("{} {} {} {} number{}", is_one ? "line" : "lines",
                       is_one ? std::to_string(place.first_line) : lines, is_one ? "holds" : "hold", count,
                       count == 1 ? "" : "s");
}

}  // namespace

const std::string& printout_of(const Graded& kept) {
    if (!kept.execution.printout.empty()) return kept.execution.printout;
    throw UsageError(
        fmt::format("{}: there is no printout of it to read again: the program printed nothing, or more than {} KiB, "
                    "or the class was last graded by an older raygrade (then grade it again with --apply). "
                    "`raygrade override` gives points without one",
                    escape_control(kept.submission.id), longest_kept_printout >> 10U));
}

void require_value(const Reread& given, const reference::ItemSpec& item, const Score& score,
                   const std::string& printout) {
    if (given.lines.empty()) return;
    const auto place = read_lines(given.lines);
    if (!place) {
        throw UsageError(fmt::format(
            "{}: are no lines of an output; write 12, 12-14, or 12:2 and 12:2-4 for some of a line's numbers",
            escape_control(given.lines)));
    }
    Transcript transcript = read_transcript(printout, last_question(score));
    const std::string there = what_stands_at(*place, transcript, given.lines);
    if (read_at(transcript, item, *place, asked_items(score))) return;
    throw UsageError(fmt::format(
        "{}: {}, and nothing there can be read as {}, which {}.{} is. Name the lines that hold just that, or some of a "
        "line's numbers, as in {}:2-4; `raygrade read` shows an output with its lines, and --none says that the item "
        "was not printed",
        escape_control(given.lines), there, report::expected_shape(item.shape), given.question, given.item,
        place->first_line));
}

std::vector<std::size_t> with_layout(const KeptClass& kept, const std::string& layout) {
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < kept.graded.size(); ++i) {
        const std::string& printout = kept.graded[i].execution.printout;
        if (!printout.empty() && layout_of(printout) == layout) alike.push_back(i);
    }
    return alike;
}

}  // namespace harness
