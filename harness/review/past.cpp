#include "harness/review/past.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "harness/class_run/corrections.h"
#include "harness/record/final_mark.h"
#include "harness/report/text/sentences.h"

namespace harness::review {
namespace {

std::string what_of(const Decision& decision) {
    switch (decision.kind) {
        case Decision::Kind::accepted: return "Accepted";
        case Decision::Kind::comment: return "Comment added";
        case Decision::Kind::points:
        case Decision::Kind::reading: return report::decision_in_words(decision);
    }
    return "";
}

void add_once(std::vector<std::string>& list, const std::string& one) {
    if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
}

/// The past decision with the number of this one.
PastDecision& find_in(std::vector<PastDecision>& all, const KeptDecision& kept) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const PastDecision& past_decision) {
        return past_decision.number == kept.given.number;
    });
    if (found != all.end()) return *found;
    all.emplace_back().number = kept.given.number;
    return all.back();
}

/// A decision on points or a reading may also have accepted concerns; they do not give it its name.
void add_to(PastDecision& past, const KeptDecision& kept) {
    const bool names_it = past.what.empty() || kept.given.kind != Decision::Kind::accepted;
    if (names_it) {
        past.what = what_of(kept.given);
        past.why = kept.given.text;
    }
    past.by = kept.given.by;
    past.when = kept.given.when;
    add_once(past.submissions, kept.submission);
}

void add_to(PastDecision& past, const UndoneDecision& undone) {
    add_to(past, undone.made);
    auto same = std::find_if(past.taken_back.begin(), past.taken_back.end(), [&](const TakenBack& taken_back) {
        return taken_back.by == undone.undone.name && taken_back.when == undone.undone.when;
    });
    if (same == past.taken_back.end()) {
        past.taken_back.push_back({{}, undone.undone.name, undone.undone.when});
        same = past.taken_back.end() - 1;
    }
    add_once(same->submissions, undone.made.submission);
}

}  // namespace

std::vector<PastDecision> past_decisions(const KeptClass& kept) {
    std::vector<PastDecision> all;
    for (const KeptDecision& kept_decision : kept.decisions) {
        PastDecision& past = find_in(all, kept_decision);
        add_to(past, kept_decision);
        add_once(past.in_force, kept_decision.submission);
    }
    for (const UndoneDecision& undone_decision : kept.undone)
        add_to(find_in(all, undone_decision.made), undone_decision);
    for (PastDecision& past_decision : all) {
        std::sort(past_decision.taken_back.begin(), past_decision.taken_back.end(),
                  [](const TakenBack& taken_back, const TakenBack& other) { return taken_back.when < other.when; });
    }
    std::sort(all.begin(), all.end(),
              [](const PastDecision& one, const PastDecision& other) { return one.number > other.number; });
    return all;
}

std::string name_of(const KeptClass& kept, const std::string& id) {
    const auto found = std::find_if(kept.graded.begin(), kept.graded.end(),
                                    [&](const Graded& graded) { return graded.submission.id == id; });
    return found == kept.graded.end() ? id : label_of(found->submission);
}

std::string sentence_of(const KeptClass& kept, std::int64_t number) {
    for (const PastDecision& past : past_decisions(kept)) {
        if (past.number != number || past.in_force.empty()) continue;
        constexpr std::size_t most = 10;
        const auto shown = static_cast<std::ptrdiff_t>(std::min(past.in_force.size(), most));
        std::vector<std::string> first(past.in_force.begin(), past.in_force.begin() + shown);
        for (std::string& each : first) each = name_of(kept, each);
        std::string names = fmt::format("{}", fmt::join(first, "; "));
        if (past.in_force.size() > most) names += fmt::format(" and {} more", past.in_force.size() - most);
        return fmt::format("Decision {}: {} for {}.", number, past.what, names);
    }
    return "";
}

std::string lowered_sentence(const std::vector<std::string>& lowered) {
    if (lowered.empty()) return "";
    return lowered.size() == 1 ? fmt::format("It lowers {}.", lowered.front())
                               : fmt::format("It lowers the points of {} students.", lowered.size());
}

std::string lowered_sentence(const KeptClass& kept, std::int64_t number) {
    std::vector<std::string> lowered;
    for (const KeptDecision& kept_decision : kept.decisions) {
        if (kept_decision.given.number != number || kept_decision.given.kind != Decision::Kind::points) continue;
        const auto index = index_of(kept, kept_decision.submission);
        if (!index) continue;
        Graded before = kept.graded[*index];
        const auto now = std::ranges::find(before.review.overrides, kept_decision.given.about, place_of);
        if (now == before.review.overrides.end()) continue;
        const Override given = *now;
        before.review.overrides.erase(now);
        if (kept_decision.given.replaced_override)
            before.review.overrides.push_back(*kept_decision.given.replaced_override);
        if (std::string what = lowered_by(before, given); !what.empty()) lowered.push_back(std::move(what));
    }
    return lowered_sentence(lowered);
}

}  // namespace harness::review
