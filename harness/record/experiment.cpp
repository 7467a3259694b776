#include "harness/record/experiment.h"

#include <fmt/format.h>

#include <algorithm>

namespace harness {
namespace {

template <class Entry>
const Entry* entry_of(const std::vector<Entry>& entries, const ItemScore& item) {
    const auto found = std::ranges::find_if(entries, [&](const Entry& entry) {
        return entry.question == item.spec.question && entry.item == item.spec.name;
    });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace

void note_experiment(Score& score, const ExperimentReport& report) {
    for (QuestionScore& question : score.questions) {
        for (ItemScore& item : question.items) {
            const MistakeOnScenes* mistake = entry_of(report.mistakes, item);
            if (mistake != nullptr && item.verdict == ItemVerdict::wrong && !item.credit && !item.diagnosis.empty()) {
                item.diagnosis = mistake->diagnosis;
                item.advice = mistake->advice;
            }
            const RemainingDoubt* remaining = entry_of(report.doubts, item);
            const bool has_all = item.verdict == ItemVerdict::follow && item.points >= item.max_points;
            if (remaining == nullptr || item.doubt) continue;
            const bool is_sure = item.verdict == ItemVerdict::right || has_all;
            if (is_sure && remaining->doubt.why != Doubt::Why::another_answer) continue;
            item.doubt = remaining->doubt;
            item.layout_doubt = remaining->layout_doubt;
        }
    }
}

std::string doubts_evidence(const Score& score, const std::optional<ExperimentReport>& report, Audience audience) {
    const std::string doubts = doubts_text(score, audience);
    if (doubts.empty() || !report || report->unsettled.empty()) return doubts;
    return fmt::format("{}. Runs on other scenes did not settle this: {}.", doubts, report->unsettled);
}

}  // namespace harness
