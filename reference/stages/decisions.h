// How the ray meets the scene, in words.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/stages/scene_answers.h"

namespace reference {

struct Decisions {
    std::map<Subject, std::string> objects;  ///< by kind, for the item's object: hit, miss, … (see `decision`)
    std::string first = {};                  ///< sphere, triangle, …, tie, none or unsure; empty without objects
    std::vector<std::string> policy = {};    ///< "boundary" and "pixel convention" if an answer depends on them

    /// Empty if the scene has no such object.
    std::string of(Subject kind) const {
        const auto found = objects.find(kind);
        return found == objects.end() ? "" : found->second;
    }
};

inline std::string_view first_decision(std::optional<FirstObject> first) {
    if (!first) return "unsure";
    if (const auto kind = first->kind()) return to_string(*kind);
    return *first == FirstObject::tie ? "tie" : "none";
}

/// The decisions under the boundary policy of the answers.
template <class S>
Decisions decisions_of(const SceneAnswers<S>& answers) {
    Decisions decisions;
    for_each_asked(
        [&](Subject kind, const auto& asked) {
            if (asked) decisions.objects[kind] = decision(*asked);
        },
        answers);
    if (!decisions.objects.empty()) decisions.first = first_decision(answers.first_object);
    return decisions;
}

}  // namespace reference
