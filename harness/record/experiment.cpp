#include "harness/record/experiment.h"

#include <fmt/format.h>

#include <algorithm>

namespace harness {

void keep_mistakes_of_all_scenes(Score& score, const ExperimentReport& report) {
    for (QuestionScore& question : score.questions) {
        for (ItemScore& item : question.items) {
            const auto found = std::ranges::find_if(report.mistakes, [&](const MistakeOnScenes& mistake) {
                return mistake.question == question.number && mistake.item == item.spec.name;
            });
            if (found == report.mistakes.end() || item.verdict != ItemVerdict::wrong || item.credit) continue;
            if (item.diagnosis == found->diagnosis || item.diagnosis.empty()) continue;
            item.diagnosis = found->diagnosis;
            item.advice = found->advice;
        }
    }
}

std::string doubts_evidence(const Score& score, const std::optional<ExperimentReport>& report, Audience audience) {
    const std::string doubts = doubts_text(score, audience);
    if (doubts.empty() || !report || report->unsettled.empty()) return doubts;
    return fmt::format("{}. Other scenes do not settle that: {}.", doubts, report->unsettled);
}

}  // namespace harness
