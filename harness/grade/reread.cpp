#include "harness/grade/reread.h"

#include <re2/re2.h>

#include <algorithm>

#include "harness/machine/fingerprint.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/read/tokens/clean_text.h"

namespace harness {
namespace {

/// A line with '#' for every number and one blank for every run of blanks. Numbers may be glued to words, as in
/// "x1.5y2.5", but nan and inf are words. An address such as 0x7ffe is one number.
std::string layout_of_line(std::string_view line) {
    static const RE2 number(R"([+-]?(?:0x\w*|(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?|\b(?:nan|inf|NAN|INF)\b))");
    static const RE2 blanks(R"([ \t]+)");
    std::string layout(line);
    RE2::GlobalReplace(&layout, number, "#");
    RE2::GlobalReplace(&layout, blanks, " ");
    if (layout.starts_with(' ')) layout.erase(0, 1);
    if (layout.ends_with(' ')) layout.pop_back();
    return layout;
}

void attach(const std::vector<KeptReread>& rereads, Submission& submission) {
    submission.rereads.clear();
    for (const KeptReread& kept_reread : rereads) {
        if (kept_reread.submission == submission.id) submission.rereads.push_back(kept_reread.given);
    }
}

}  // namespace

std::string layout_of(std::string_view printout) {
    Fingerprint layout("raygrade/layout/2");
    const std::string text = clean_text(printout);
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        layout.add(layout_of_line(rest.substr(0, end)));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return layout.hex();
}

std::vector<ItemPlace> places_in(const std::vector<Reread>& rereads, std::string_view printout) {
    std::vector<ItemPlace> places;
    if (rereads.empty()) return places;
    const std::string layout = layout_of(printout);
    for (const Reread& reread : rereads) {
        std::optional<ItemPlace> place = reread.lines.empty() ? ItemPlace{} : read_lines(reread.lines);
        if (!place || reread.layout != layout) continue;
        place->question = reread.question;
        place->item = reread.item;
        place->note = note_of(reread);
        places.push_back(std::move(*place));
    }
    return places;
}

std::vector<ItemPlace> places_of(const Graded& graded, std::string_view printout) {
    std::vector<ItemPlace> places = places_in(graded.submission.rereads, printout);
    if (!graded.findings.experiment) return places;
    for (const ItemPlace& shown : graded.findings.experiment->places) {
        const bool is_said = std::ranges::any_of(places, [&](const ItemPlace& place) {
            return place.question == shown.question && place.item == shown.item;
        });
        if (!is_said) places.push_back(shown);
    }
    return places;
}

void attach(const std::vector<KeptReread>& rereads, std::vector<Submission>& submissions) {
    for (Submission& submission : submissions) attach(rereads, submission);
}

void attach(const std::vector<KeptReread>& rereads, std::vector<Graded>& graded) {
    for (Graded& result : graded) attach(rereads, result.submission);
}

}  // namespace harness
