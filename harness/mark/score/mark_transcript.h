// From what a program printed to a score. A pure function of that, the key and the assignment.
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

/// Marks a transcript. `key` must be the assignment's. Items that have a place are read from there.
Score score(const Transcript& transcript, const reference::AnswerKey& key, const reference::Assignment& assignment,
            std::span<const ItemPlace> places = {});

/// The same for answers that are matched already, without doubts.
Score mark_answers(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                   const reference::Assignment& assignment);

/// How many answers are the key's, each by itself: what follows or is forgiven does not count. `matched` are the
/// answers to the items that `key` asks for, or to more.
std::ptrdiff_t answers_of(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                          const reference::Assignment& assignment);

/// The diagnosis of answers that belong to another scene than the assignment's.
inline constexpr std::string_view own_scene_diagnosis = "another scene";

/// Marks the answers that belong to another scene, which the student's source states: `own` are the same answers marked
/// under that scene, without doubts. An answer that is right there follows, for the rubric's wrong_scene_credit; the
/// diagnosis of a wrong one is the one it gets there. `cause` names the scene: "Your source sets …". Empty unless that
/// scene explains answers that the assignment's does not, and more than the other way round.
std::optional<Score> explained_by_scene(const Score& score, const Score& own, const std::string& cause,
                                        const reference::Rubric& rubric);

}  // namespace harness
