// Finds answers for the scene that a student's source states instead of the assignment's.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "harness/grade/scene_memo.h"
#include "harness/match/item_place.h"
#include "harness/read/transcript.h"
#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness {

/// A score in which another scene explains wrong answers.
struct OwnSceneScore {
    Score score;
    OwnScene scene;
};

/// Looks for a scene in the source that explains the answers that are not right for the assignment. `score` is the
/// output's score, with items that have a place read from there. Empty if there is none. Makes a key for each scene
/// tried, at most twelve, unless the memo, which may be null, has it.
std::optional<OwnSceneScore> score_on_own_scene(const Score& score, const std::string& output, std::string_view source,
                                                const Marking& marking, std::span<const ItemPlace> places = {},
                                                SceneMemo* memo = nullptr);

/// Marks the transcript again with a scene that was found before.
Score score_again_on(const OwnScene& scene, const Score& score, const Transcript& transcript, const Marking& marking,
                     std::span<const ItemPlace> places = {});

/// A submission whose answers are right for another student's scene.
struct AnswersOfAnother {
    std::string submission;
    std::string student;  ///< the student whose scene it is; empty for the assignment's own
};

/// If students have their own scenes: flags the submissions that have three more answers right on another student's
/// scene, or on the assignment's, than on their own, and finds the scene with the most. The flag does not name the
/// other student, because its student reads it.
std::vector<AnswersOfAnother> flag_answers_of_others(std::vector<Graded>& graded, const Marking& marking);

}  // namespace harness
