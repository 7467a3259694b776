// Gives each student of a class a different scene.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reference/toml/assignment.h"

namespace harness::prepare {

/// The search's random seed, and a callback for its progress.
struct DealOptions {
    std::uint64_t seed = 1;
    std::function<void(double done)> progress = {};  ///< in [0, 1]
};

/// A scene for each of these students. All scenes differ from each other and from the assignment's own. Each has at
/// least as many hits, has no decision that rounding in float may change, and reveals as many mistakes, or else the
/// most that the search found. A student who already has a scene in the assignment keeps it. The same seed and students
/// give the same scenes. Throws reference::AssignmentError if there is no such scene.
std::map<std::string, reference::Scene<reference::Decimal>> deal(const reference::Assignment& assignment,
                                                                 const std::vector<std::string>& students,
                                                                 const DealOptions& options);

/// The [[student]] table of an assignment file for this scene. `own` is the assignment's scene.
std::string student_toml(const std::string& student, const reference::Scene<reference::Decimal>& scene,
                         const reference::Scene<reference::Decimal>& own);

}  // namespace harness::prepare
