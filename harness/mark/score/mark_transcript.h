// Turns a program's output into a score. A pure function of the output, the key and the assignment.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/score/score.h"
#include "harness/match/item_place.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness {

/// Marks a transcript. `key` must be the assignment's. Items with a place are read from that place.
Score score(const Transcript& transcript, const reference::AnswerKey& key, const reference::Assignment& assignment,
            std::span<const ItemPlace> places = {});

/// The same for already matched answers, without doubts.
Score mark_answers(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                   const reference::Assignment& assignment);

/// How many answers match the key on their own; consistent or excused answers do not count. `matched` must include all
/// items that `key` asks for.
std::ptrdiff_t answers_of(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                          const reference::Assignment& assignment);

/// The diagnosis of answers that belong to a scene other than the assignment's.
inline constexpr std::string_view own_scene_diagnosis = "another scene";

/// Marks answers that belong to another scene, which the student's source states. `own` is the score of the same
/// answers under that scene, without doubts. An answer that is right in `own` follows and earns the rubric's
/// wrong_scene_credit; a wrong answer gets its diagnosis from `own`. `cause` names the scene: "Your source sets …".
/// Empty unless that scene explains some answers that the assignment's scene does not, and more than the reverse.
std::optional<Score> explained_by_scene(const Score& score, const Score& own, const std::string& cause,
                                        const reference::Rubric& rubric);

}  // namespace harness
