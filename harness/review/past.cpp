#include "harness/review/past.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace harness::review {
namespace {

std::string what_of(const Decision& decision) {
    switch (decision.kind) {
        case Decision::Kind::accepted: return "Accepted";
        case Decision::Kind::comment: return "Comment added";
        case Decision::Kind::points: return fmt::format("Points for {} given", decision.about);
        case Decision::Kind::reading: return fmt::format("{} read again", decision.about);
    }
    return "";
}

/// A decision on points or a reading may also have accepted concerns: those are not what it is called by.
void add_to(PastDecision& past, const KeptDecision& kept) {
    const bool names_it = past.what.empty() || kept.given.kind != Decision::Kind::accepted;
    if (names_it) {
        past.what = what_of(kept.given);
        past.why = kept.given.text;
    }
    past.by = kept.given.by;
    past.when = kept.given.when;
    if (std::find(past.submissions.begin(), past.submissions.end(), kept.submission) == past.submissions.end())
        past.submissions.push_back(kept.submission);
}

}  // namespace

std::vector<PastDecision> past_decisions(const KeptClass& kept) {
    std::vector<PastDecision> all;
    for (const KeptDecision& each : kept.decisions) {
        auto found = std::find_if(all.begin(), all.end(),
                                  [&](const PastDecision& one) { return one.number == each.given.number; });
        if (found == all.end()) {
            all.emplace_back().number = each.given.number;
            found = all.end() - 1;
        }
        add_to(*found, each);
    }
    std::sort(all.begin(), all.end(),
              [](const PastDecision& one, const PastDecision& other) { return one.number > other.number; });
    return all;
}

std::string sentence_of(const KeptClass& kept, std::int64_t number) {
    for (const PastDecision& past : past_decisions(kept)) {
        if (past.number != number) continue;
        constexpr std::size_t most = 10;
        const auto shown = static_cast<std::ptrdiff_t>(std::min(past.submissions.size(), most));
        std::string names =
            fmt::format("{}", fmt::join(past.submissions.begin(), past.submissions.begin() + shown, ", "));
        if (past.submissions.size() > most) names += fmt::format(" and {} more", past.submissions.size() - most);
        return fmt::format("Decision {}: {} for {}.", number, past.what, names);
    }
    return "";
}

}  // namespace harness::review
