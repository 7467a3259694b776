#include "harness/report/text/sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/mark/diagnose/derivations.h"
#include "harness/match/match.h"
#include "harness/match/question_match.h"
#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/text/listed.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// Uses the printed text, because the gradebook does not store ItemScore::not_finite.
bool holds_no_number(const ItemScore& item) {
    return !item.error &&
           (item.printed.find("nan") != std::string::npos || item.printed.find("inf") != std::string::npos);
}

/// Says which answers that are missing in the output the program wrote to standard error, by a heading or, without one,
/// by a label: " Your program wrote question 6 to standard error …". Empty if none.
std::string missing_in_standard_error(const Graded& graded) {
    std::vector<reference::ItemSpec> missing;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::missing) missing.push_back(item.spec);
        }
    }
    if (missing.empty() || graded.execution.run.errors.empty()) return "";
    const Transcript transcript = read_transcript(graded.execution.run.errors, last_question(graded.score));
    std::vector<int> headings;
    for (const Section& section : transcript.sections) {
        const bool is_missing = std::ranges::any_of(
            missing, [&](const reference::ItemSpec& spec) { return spec.question == section.question; });
        if (is_missing && std::ranges::find(headings, section.question) == headings.end())
            headings.push_back(section.question);
    }
    std::ranges::sort(headings);
    std::vector<std::string> names;
    for (const int question : headings) names.push_back(fmt::format("question {}", question));
    for (const MatchedItem& scored : match(transcript, missing)) {
        const bool is_named = scored.first_object || (scored.value && !scored.value->label.empty());
        if (is_named && headings.empty()) names.push_back(item_in_words(scored.spec.question, scored.spec));
    }
    if (names.empty()) return "";
    return fmt::format(" Your program wrote {} to standard error (std::cerr); only standard output is read.",
                       listed(names));
}

/// The points for a consistent answer.
std::string share_sentence(const ItemScore& item) {
    constexpr double a_millionth = 1e-6;
    if (item.max_points <= 0) return "";
    if (item.points >= item.max_points - a_millionth) return " No points lost.";
    return fmt::format(" That earns {:.0f} % of its points.", 100 * item.points / item.max_points);
}

/// "question 2", "questions 6 to 10".
std::vector<std::string> runs_of(const std::vector<int>& questions) {
    std::vector<std::string> runs;
    for (std::size_t i = 0; i < questions.size();) {
        std::size_t end = i + 1;
        while (end < questions.size() && questions[end] == questions[end - 1] + 1) ++end;
        runs.push_back(end == i + 1 ? fmt::format("question {}", questions[i])
                                    : fmt::format("questions {} {} {}", questions[i], end == i + 2 ? "and" : "to",
                                                  questions[end - 1]));
        i = end;
    }
    return runs;
}

/// Removes the folders from each absolute path in quotes.
std::string names_without_folders(std::string_view text) {
    std::string result;
    bool is_quoted = false;
    while (true) {
        const std::size_t quote = text.find('"');
        std::string_view part = text.substr(0, quote);
        if (is_quoted && part.starts_with('/')) {
            while (part.size() > 1 && part.ends_with('/')) part.remove_suffix(1);
            part.remove_prefix(part.rfind('/') + 1);  // npos + 1 is 0
        }
        result += part;
        if (quote == std::string_view::npos) return result;
        result += '"';
        text.remove_prefix(quote + 1);
        is_quoted = !is_quoted;
    }
}

}  // namespace

bool was_cut_short(Outcome outcome) {
    switch (outcome) {
        case Outcome::crashed:
        case Outcome::timed_out:
        case Outcome::output_limit:
        case Outcome::memory_limit: return true;
        case Outcome::graded:
        case Outcome::compile_error:
        case Outcome::no_output:
        case Outcome::not_graded: return false;
    }
    return false;
}

std::string expected_shape(reference::Shape shape) {
    switch (shape) {
        case reference::Shape::scalar: return "one number";
        case reference::Shape::vector: return "a vector of three numbers";
        case reference::Shape::matrix3: return "a 3 x 3 matrix";
        case reference::Shape::matrix4: return "a 4 x 4 matrix";
        case reference::Shape::first_object: return "a sentence that says which object the ray hits first";
    }
    return "";
}

std::string scenes_sentence(const Graded& graded) {
    return fmt::format("Other scenes: {} of {} points.", points_text(final_scenes_points(graded)),
                       points_text(graded.score.variants->max_points));
}

std::string cap_sentence(double cap) {
    return fmt::format("Wrong answers that are consistent with earlier ones earn at most {} points in all.",
                       points_text(cap));
}

std::string crash_advice(const Graded& graded) {
    if (graded.execution.run.ended != Ended::signalled || !graded.execution.sanitizer.empty()) return "";
    return "To find the line, run raygrade check --sanitize ray_cast.cpp, or g++ -g -fsanitize=address,undefined "
           "ray_cast.cpp && ./a.out";
}

std::string reason_for_student(const Submission& submission) {
    if (!submission.problem) return "This is not your program's fault; the grader failed. Tell your instructor.";
    return names_without_folders(*submission.problem);
}

std::string evidence_text(const Graded& graded, const Flag& flag, Audience audience) {
    const bool has_more = flag.kind == "reading_doubtful" && audience == Audience::instructor;
    return has_more ? doubts_evidence(graded.score, graded.findings.experiment, audience) : flag.evidence;
}

std::vector<std::string> instructor_sentences(const Graded& graded) {
    std::vector<std::string> sentences;
    for (const Override& given : graded.review.overrides) {
        if (find_override(graded, given.question, given.item) != &given || !points_at(graded.score, given)) continue;
        sentences.push_back(fmt::format("Your instructor gave {} points for {}: {}", points_text(given.points),
                                        place_in_words(place_of(given)), given.why));
    }
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (!item.reread.empty())
                sentences.push_back(capitalized(item_in_words(question.number, item.spec)) + ": " +
                                    told_reread(graded, item));
        }
    }
    for (const Decision& decision : comments_of(graded)) {
        const std::string about = decision.about.empty() ? "" : " about " + place_in_words(decision.about);
        sentences.push_back(fmt::format("Your instructor writes{}: {}", about, decision.text));
    }
    return sentences;
}

std::string told_reread(const Graded& graded, const ItemScore& item) {
    for (Reread given : graded.submission.rereads) {
        if (note_of(given) != item.reread) continue;
        given.by = "your instructor";
        return note_of(given);
    }
    return item.reread;
}

std::string how_found(const ItemScore& item) {
    if (!item.reread.empty()) return item.reread;
    if (!item.experiment.empty()) return item.experiment;
    return item.by_order ? "Found by its order; it has no label." : "";
}

std::string name_in_question(const reference::ItemSpec& spec) {
    const std::string_view name = spec.shape == reference::Shape::first_object ? "first hit" : spec.name;
    return spec.part == 0 ? std::string(name) : fmt::format("{}) {}", spec.part, name);
}

std::string item_in_words(int question, const reference::ItemSpec& spec) {
    return items_in_words({{question, std::string(spec.name)}});
}

std::string item_sentence(const ItemScore& item, Outcome outcome, reference::Feedback feedback) {
    const bool may_hint = feedback >= reference::Feedback::hint;
    const bool may_name = feedback >= reference::Feedback::mistake;
    switch (item.verdict) {
        case ItemVerdict::right: return item.accepted_as.empty() ? "" : fmt::format("Accepted: {}.", item.accepted_as);
        case ItemVerdict::follow:
            if (!item.advice.empty() && may_name) return item.advice + share_sentence(item);
            if (may_hint && holds_no_number(item))
                return "Not a number (nan or inf), but consistent with your earlier answers." + share_sentence(item);
            return "Wrong value, but consistent with your earlier answers." + share_sentence(item);
        case ItemVerdict::missing:
            if (was_cut_short(outcome)) return "Not printed before the program ended.";
            return fmt::format("Not found in the output. Under this question's heading, print a label and {}.",
                               expected_shape(item.spec.shape));
        case ItemVerdict::unreadable:
            if (item.doubt && item.doubt->why == Doubt::Why::another_answer)
                return "The output offers more than one answer here. Print only the one you mean.";
            return fmt::format("This can't be read as an answer. The question asks for {}.",
                               expected_shape(item.spec.shape));
        case ItemVerdict::wrong: break;
    }
    constexpr const char* plainly = "That is not the right value.";
    if (!may_hint) return plainly;
    if (holds_no_number(item)) {
        const std::string text =
            "That is not a number (nan or inf): look for a division by zero, the root of a negative number or a "
            "variable that was "
            "never set.";
        return text + (may_be_absent(item.spec) ? " If the ray misses, print none." : "");
    }
    if (!item.advice.empty() && may_name) return item.advice;
    if (!item.difference.empty() && may_name) return fmt::format("{} {}", plainly, item.difference);
    if (!can_follow(item.spec.id)) return plainly;
    return "That is not the right value, and it is not consistent with your earlier answers.";
}

std::string before_printed(const ItemScore& item) {
    if (!told_doubt(item)) return "you printed";
    if (item.spec.shape == reference::Shape::first_object) return "read as the answer:";
    return fmt::format("read as {} =", item.spec.name);
}

std::string capitalized(std::string sentence) {
    if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] += 'A' - 'a';
    return sentence;
}

std::string decision_in_words(const Decision& decision) {
    switch (decision.kind) {
        case Decision::Kind::accepted: return "Accepted: " + title_of(decision.about).of_many;
        case Decision::Kind::comment:
            return decision.about.empty() ? "Comment" : "Comment on " + place_in_words(decision.about);
        case Decision::Kind::points: return fmt::format("Points given ({})", place_in_words(decision.about));
        case Decision::Kind::reading: return fmt::format("Read again ({})", place_in_words(decision.about));
    }
    return "";
}

std::string told_diagnosis(const ItemScore& item, reference::Feedback feedback) {
    return feedback >= reference::Feedback::mistake ? item.diagnosis : "";
}

std::string missing_sentence(const Graded& graded) {
    std::vector<int> whole;  // questions
    std::vector<std::string> names;
    for (const QuestionScore& question : graded.score.questions) {
        std::vector<std::pair<int, std::string>> items;
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::missing) items.emplace_back(question.number, item.spec.name);
        }
        if (items.size() == question.items.size()) {
            whole.push_back(question.number);
        } else if (!items.empty()) {
            names.push_back(items_in_words(items));
        }
    }
    const std::vector<std::string> questions = runs_of(whole);
    names.insert(names.begin(), questions.begin(), questions.end());
    if (names.empty() || graded.execution.outcome == Outcome::compile_error ||
        graded.execution.outcome == Outcome::no_output || graded.execution.outcome == Outcome::not_graded)
        return "";
    const bool all = whole.size() == graded.score.questions.size();
    const bool lacks_first_object = std::ranges::any_of(graded.score.questions, [](const QuestionScore& question) {
        return std::ranges::any_of(question.items, [](const ItemScore& item) {
            return item.verdict == ItemVerdict::missing && item.spec.shape == reference::Shape::first_object;
        });
    });
    if (was_cut_short(graded.execution.outcome)) {
        return all ? "The program printed no answer before it ended."
                   : fmt::format("Not printed before the program ended: {}.", listed(names));
    }
    return fmt::format("{}. Print each answer with a label under its question's heading{}.{}",
                       all ? "No answer was found in the output" : "Not found in the output: " + listed(names),
                       lacks_first_object ? ", and the first hit as \"ray hits sphere first\"" : "",
                       missing_in_standard_error(graded));
}

std::string accepted_sentence(const Score& score) {
    using Items = std::vector<std::pair<int, std::string>>;
    std::vector<std::pair<std::string, Items>> items_by_form;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict != ItemVerdict::right || item.accepted_as.empty()) continue;
            const auto found = std::find_if(items_by_form.begin(), items_by_form.end(),
                                            [&](const auto& each) { return each.first == item.accepted_as; });
            auto& items =
                (found != items_by_form.end() ? *found : items_by_form.emplace_back(item.accepted_as, Items())).second;
            items.emplace_back(question.number, item.spec.name);
        }
    }
    std::string text;
    for (const auto& [form, items] : items_by_form)
        text += fmt::format("{} {}: {}", text.empty() ? "Accepted in" : "; in", items_in_words(items), form);
    return text.empty() ? "" : text + ".";
}

}  // namespace harness::report
