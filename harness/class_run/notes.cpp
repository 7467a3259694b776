#include "harness/class_run/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "harness/class_run/students/student_names.h"
#include "harness/intake/hand_in.h"
#include "harness/machine/say.h"
#include "harness/record/override_place.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "reference/toml/near_names.h"

namespace harness {

void tell_left_out(const std::vector<std::string>& files) {
    if (files.empty()) return;
    say("note: ignored, because they are not submissions: {}\n", list_of(files));
}

void tell_answers_of_others(const std::vector<AnswersOfAnother>& found) {
    for (const AnswersOfAnother& answers_of_another : found) {
        say("note: {}: the answers are right for another scene, that of {}\n", answers_of_another.submission,
            answers_of_another.student.empty() ? "the assignment itself" : escape_control(answers_of_another.student));
    }
}

void tell_not_handed_in(const Marking& marking, const std::vector<Graded>& graded) {
    std::set<std::string> handed_in;
    for (const Graded& result : graded) handed_in.insert(id_in(marking.of_student, result.submission));
    std::vector<std::string> missing;
    for (const auto& [student, own] : marking.of_student) {
        if (!handed_in.contains(student)) missing.push_back(escape_control(student));
    }
    if (!missing.empty())
        say("note: no submission from these students with their own scene: {}\n", fmt::join(missing, ", "));
}

void tell_notes(const std::vector<Graded>& graded) {
    std::map<std::string_view, std::size_t> times;
    for (const Graded& result : graded) {
        for (const std::string& note : result.submission.notes) ++times[note];
    }
    const auto is_of_all = [&](const std::string& note) { return graded.size() > 1 && times[note] == graded.size(); };
    for (const Graded& one : graded) {
        for (const std::string& note : one.submission.notes) {
            if (!is_of_all(note)) {
                say("note: {}: {}\n", one.submission.id, note);
            } else if (&one == &graded.front()) {
                say("note: all {} submissions: {}\n", graded.size(), note);
            }
        }
    }
}

void tell_unmatched(const std::vector<KeptOverride>& overrides) {
    for (const KeptOverride& kept_override : overrides) {
        say("note: the override of {} for {} is unused, because there is no such submission or item here\n",
            place_of(kept_override.given), escape_control(kept_override.submission));
    }
}

void tell_overrides_above_most(const std::vector<Graded>& graded) {
    for (const Graded& result : graded) {
        for (const Override& by_hand : result.review.overrides) {
            const auto there = points_at(result.score, by_hand);
            if (!there || by_hand.points <= there->most) continue;
            say("note: the override of {} for {} gives {}, more than the {} points that the rubric gives\n",
                place_of(by_hand), escape_control(result.submission.id), points_text(by_hand.points),
                points_text(there->most));
        }
    }
}

void tell_that_apply_takes_out(const ClassChanges& changes) {
    if (changes.gone.empty()) return;
    say("note: --apply removes students who are no longer in the class from the results. To add a submission, grade "
        "the whole class again; unchanged programs are not run again\n");
}

void tell_that_count_not(const std::vector<KeptReread>& rereads, const std::vector<Graded>& graded) {
    for (const KeptReread& kept_reread : rereads) {
        const auto one = std::find_if(graded.begin(), graded.end(),
                                      [&](const Graded& any) { return any.submission.id == kept_reread.submission; });
        if (one != graded.end() && counts(*one, kept_reread.given)) continue;
        say("note: the reread of {}.{} for {} is unused: {}\n", kept_reread.given.question, kept_reread.given.item,
            escape_control(kept_reread.submission),
            one == graded.end() ? "there is no such submission here" : "its output has a different layout now");
    }
}

void tell_late_days(const report::LateDays& days, const reference::Rubric& rubric, const std::vector<Graded>& graded) {
    if (!days.empty() && rubric.late.empty()) {
        say("note: --late-days takes no points off, because the rubric does not say how many; add e.g. late_deduction "
            "= 0.1 to [rubric]\n");
    }
    std::vector<std::string> ids;
    StudentNames names;
    for (const Graded& result : graded) {
        ids.push_back(id_in(days, result.submission));
        names.add(result.submission);
    }
    for (const auto& [id, late] : days) {
        if (std::ranges::find(ids, id) != ids.end()) continue;
        if (const std::size_t count = names.count(id); count > 1) {
            say("note: --late-days: {} is the name of {} submissions; use an id\n", escape_control(id), count);
        } else {
            say("note: --late-days: there is no submission \"{}\"; {}\n", escape_control(id),
                reference::did_you_mean(id, ids));
        }
    }
}

}  // namespace harness
