#include "harness/record/concerns.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "harness/record/concern_titles.h"

namespace harness {
namespace {

std::vector<Flag> without_accepted(std::vector<Flag> concerns, const Graded& graded) {
    std::erase_if(concerns, [&](const Flag& concern) { return acceptance_of(graded, concern) != nullptr; });
    return concerns;
}

}  // namespace

std::vector<Flag> concerns_of(const Graded& graded) {
    std::vector<Flag> concerns = graded.findings.flags;
    if (graded.execution.outcome == Outcome::not_graded) {
        concerns.push_back({std::string(not_graded_concern),
                            graded.submission.problem ? *graded.submission.problem : graded.execution.explanation});
    }
    std::ranges::stable_sort(concerns, {}, [](const Flag& concern) { return urgency_of(concern.kind); });
    return concerns;
}

std::string seen_in(const Graded& graded, const Flag& concern) {
    std::string seen = concern.evidence;
    if (concern.kind != "reading_doubtful") return seen;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (!item.doubt) continue;
            seen += fmt::format("\n{}.{}, line {}: {} {}", question.number, item.spec.name, item.line,
                                to_string(item.verdict), item.printed);
        }
    }
    return seen;
}

const Decision* acceptance_of(const Graded& graded, const Flag& concern) {
    const auto found =
        std::find_if(graded.review.decisions.rbegin(), graded.review.decisions.rend(), [&](const Decision& decision) {
            return decision.kind == Decision::Kind::accepted && decision.about == concern.kind &&
                   decision.seen == seen_in(graded, concern);
        });
    return found == graded.review.decisions.rend() ? nullptr : &*found;
}

std::vector<Flag> open_concerns(const Graded& graded) {
    return without_accepted(concerns_of(graded), graded);
}

std::vector<Flag> open_flags(const Graded& graded) {
    return without_accepted(graded.findings.flags, graded);
}

std::vector<Flag> flags_for_student(const Graded& graded) {
    std::vector<Flag> flags = open_flags(graded);
    bool costs_points = false;
    for_each_item(graded.score, [&](const ItemScore& item) {
        costs_points = costs_points || (told_doubt(item) && item.points < item.max_points);
    });
    std::erase_if(flags, [&](const Flag& flag) {
        const bool is_suspicion = flag.kind == "hard_coded" || flag.kind == "scene_of_another" ||
                                  flag.kind == "mostly_following" || flag.kind == "variants_not_tried";
        return is_suspicion || flag.evidence.empty() || (flag.kind == "reading_doubtful" && !costs_points);
    });
    return flags;
}

std::vector<Decision> comments_of(const Graded& graded) {
    std::vector<Decision> comments;
    std::copy_if(graded.review.decisions.begin(), graded.review.decisions.end(), std::back_inserter(comments),
                 [](const Decision& decision) { return decision.kind == Decision::Kind::comment; });
    return comments;
}

void attach(const std::vector<KeptDecision>& decisions, std::vector<Graded>& graded) {
    std::map<std::string, Graded*> by_id;
    for (Graded& result : graded) {
        result.review.decisions.clear();
        by_id[result.submission.id] = &result;
    }
    for (const KeptDecision& kept_decision : decisions) {
        const auto found = by_id.find(kept_decision.submission);
        if (found != by_id.end()) found->second->review.decisions.push_back(kept_decision.given);
    }
}

}  // namespace harness
