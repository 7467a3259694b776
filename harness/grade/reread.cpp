#include "harness/grade/reread.h"

#include <algorithm>

#include "harness/machine/fingerprint.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/read/lines/clean_text.h"
#include "harness/text/plain_word.h"

namespace harness {
namespace {

bool is_layout_digit(std::string_view line, std::size_t at) {
    return at < line.size() && is_digit(line[at]);
}

bool is_sign(char c) {
    return c == '+' || c == '-';
}

/// Where the word ends that begins there.
std::size_t end_of_word(std::string_view line, std::size_t at) {
    while (at < line.size() && (is_letter(line[at]) || is_digit(line[at]) || line[at] == '_')) ++at;
    return at;
}

/// Where the digits, the point and the exponent end that begin there; `at` itself if none do. An address such as 0x7ffe
/// is one number.
std::size_t end_of_digits(std::string_view line, std::size_t at) {
    if (line.substr(at).starts_with("0x")) return end_of_word(line, at);
    const auto skip_digits = [&] {
        while (is_layout_digit(line, at)) ++at;
    };
    skip_digits();
    if (at < line.size() && line[at] == '.' && is_layout_digit(line, at + 1)) {
        ++at;
        skip_digits();
    }
    if (at == 0 || !is_layout_digit(line, at - 1) || at == line.size() || (line[at] != 'e' && line[at] != 'E'))
        return at;
    const std::size_t exponent = at + 1 < line.size() && is_sign(line[at + 1]) ? at + 2 : at + 1;
    if (!is_layout_digit(line, exponent)) return at;
    at = exponent;
    skip_digits();
    return at;
}

/// Where the number ends that begins there, perhaps with a sign; `at` itself if none does. Numbers may stand in words,
/// as in "x1.5y2.5", but nan and inf are words.
std::size_t end_of_number(std::string_view line, std::size_t at) {
    const std::size_t begin = is_sign(line[at]) ? at + 1 : at;
    const std::size_t end = end_of_digits(line, begin);
    if (end > begin) return end;
    const bool begins_word = begin > at || at == 0 || end_of_word(line, at - 1) == at - 1;
    const std::string_view word = line.substr(begin, end_of_word(line, begin) - begin);
    const bool is_word_for_number = word == "nan" || word == "inf" || word == "NAN" || word == "INF";
    return begins_word && is_word_for_number ? begin + word.size() : at;
}

/// A line with every number as '#' and every run of blanks as one.
std::string layout_of_line(std::string_view line) {
    std::string layout;
    for (std::size_t at = 0; at < line.size();) {
        if (const std::size_t end = end_of_number(line, at); end > at) {
            layout += '#';
            at = end;
        } else if (line[at] == ' ' || line[at] == '\t') {
            if (!layout.empty() && layout.back() != ' ') layout += ' ';
            ++at;
        } else {
            layout += line[at++];
        }
    }
    if (layout.ends_with(' ')) layout.pop_back();
    return layout;
}

void attach(const std::vector<KeptReread>& rereads, Submission& submission) {
    submission.rereads.clear();
    for (const KeptReread& each : rereads) {
        if (each.submission == submission.id) submission.rereads.push_back(each.given);
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

void attach(const std::vector<KeptReread>& rereads, std::vector<Submission>& submissions) {
    for (Submission& one : submissions) attach(rereads, one);
}

void attach(const std::vector<KeptReread>& rereads, std::vector<Graded>& graded) {
    for (Graded& one : graded) attach(rereads, one.submission);
}

}  // namespace harness
