// The results of a program's runs on other scenes: which number is which item.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/mark/score/doubts_text.h"
#include "harness/mark/score/score.h"
#include "harness/match/item_place.h"

namespace harness {

/// The named mistake that explains a wrong item on the other scenes.
struct MistakeOnScenes {
    int question = 0;
    std::string item;
    std::string diagnosis;  ///< empty if no mistake explains it on all scenes
    std::string advice;
};

/// A doubt that the experiment could not settle.
struct RemainingDoubt {
    int question = 0;
    std::string item;
    Doubt doubt;
    std::optional<Doubt> layout_doubt;
};

struct ExperimentReport {
    std::vector<ItemPlace> places;          ///< the places of doubtful items have a note
    std::vector<MistakeOnScenes> mistakes;  ///< of the items that are wrong on every scene
    std::vector<RemainingDoubt> doubts;
    std::string unsettled;  ///< a clause: why doubts remain, if any do
};

/// Completes a score whose items were read from the report's places. Replaces named mistakes that do not explain the
/// item on every scene, and notes the remaining doubts; on right items, only another_answer. Points do not change.
void note_experiment(Score& score, const ExperimentReport& report);

/// The doubts (doubts_text), and the reason why other scenes do not settle them: "6.t: line 12 may have been meant.
/// Other scenes do not settle that: the program prints the same numbers on every scene." Empty if there is no doubt
/// that this audience may see.
std::string doubts_evidence(const Score& score, const std::optional<ExperimentReport>& report, Audience audience);

}  // namespace harness
