#include "harness/batch/reread.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/batch/grade_submission.h"
#include "harness/batch/own_scene_score.h"
#include "harness/machine/fingerprint.h"
#include "harness/read/transcript.h"

namespace harness {
namespace {

bool is_number_sign(char c) {
    return c == '.' || c == '+' || c == '-';
}

/// A line with every number as '#' and every run of blanks as one.
std::string layout_of_line(std::string_view line) {
    std::string layout;
    const auto is_word = [](char c) { return is_digit(c) || is_letter(c) || c == '_'; };
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        if (is_word(line[at]) || (is_number_sign(line[at]) && at + 1 < line.size() && is_word(line[at + 1]))) {
            const auto goes_on = [&](std::size_t i) {
                const bool is_exponent = is_number_sign(line[i]) && (line[i - 1] == 'e' || line[i - 1] == 'E');
                return is_word(line[i]) || line[i] == '.' || is_exponent;
            };
            const std::size_t begin = is_word(line[at]) ? at : at + 1;
            end = begin + 1;
            while (end < line.size() && goes_on(end)) ++end;
            const std::string_view word = line.substr(begin, end - begin);
            const bool is_number = is_digit(word.front()) || word == "nan" || word == "inf";
            layout += is_number ? "#" : line.substr(at, end - at);
        } else if (line[at] == ' ' || line[at] == '\t' || line[at] == '\r') {
            while (end < line.size() && (line[end] == ' ' || line[end] == '\t' || line[end] == '\r')) ++end;
            layout += ' ';
        } else {
            end = at + 1;
            layout += line[at];
        }
        at = end;
    }
    while (layout.ends_with(' ')) layout.pop_back();
    return layout.substr(std::min(layout.find_first_not_of(' '), layout.size()));
}

void attach(const std::vector<KeptReread>& rereads, Submission& submission) {
    submission.rereads.clear();
    for (const KeptReread& each : rereads) {
        if (each.submission == submission.id) submission.rereads.push_back(each.given);
    }
}

}  // namespace

std::string layout_of(std::string_view printout) {
    Fingerprint layout("raygrade/layout/1");
    while (!printout.empty()) {
        const std::size_t end = printout.find('\n');
        layout.add(layout_of_line(printout.substr(0, end)));
        printout.remove_prefix(end == std::string_view::npos ? printout.size() : end + 1);
    }
    return layout.hex();
}

std::string note_of(const Reread& reread) {
    if (reread.lines.empty()) return fmt::format("Not printed, as {} says: {}", reread.by, reread.why);
    const std::string_view lines =
        reread.lines.find('-') == std::string::npos || reread.lines.find(':') != std::string::npos ? "line" : "lines";
    return fmt::format("Read from {} {}, as {} says: {}", lines, reread.lines, reread.by, reread.why);
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

bool counts(const Graded& graded, const Reread& reread) {
    const std::string note = note_of(reread);
    return std::any_of(graded.score.questions.begin(), graded.score.questions.end(),
                       [&](const QuestionScore& question) {
                           return question.number == reread.question &&
                                  std::any_of(question.items.begin(), question.items.end(), [&](const ItemScore& item) {
                                      return item.spec.name == reread.item && item.reread == note;
                                  });
                       });
}

void mark_again(Graded& graded, const Marking& marking) {
    const Transcript transcript = read_transcript(graded.printout);
    const auto places = places_in(graded.submission.rereads, graded.printout);
    Score again = score(transcript, marking.key, marking.assignment, places);
    if (graded.own_scene) again = score_again_on(*graded.own_scene, again, transcript, marking, places);
    if (graded.score.other_scenes) {
        again.other_scenes = graded.score.other_scenes;
        again.points += again.other_scenes->points;
        again.max_points += again.other_scenes->max_points;
    }
    graded.score = std::move(again);
    note_doubts(graded);
}

}  // namespace harness
