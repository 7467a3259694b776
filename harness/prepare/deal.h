// A scene of its own for each student of a class.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reference/toml/assignment.h"

namespace harness::prepare {

/// Where the search for scenes begins.
struct DealOptions {
    std::uint64_t seed = 1;
    std::function<void(double done)> progress = {};  ///< in [0, 1]
};

/// A scene for each of these students, no two alike and none the assignment's own: in each at least as much is hit and
/// no decision hangs on a rounding in float, and it shows as many mistakes as the assignment's own scene, or else the
/// most that were found. A student who has a scene in the assignment keeps it. The same scenes for the same seed and
/// the same students. Throws reference::AssignmentError where no such scene is found.
std::map<std::string, reference::Scene<reference::Decimal>> deal(const reference::Assignment& assignment,
                                                                 const std::vector<std::string>& students,
                                                                 const DealOptions& options);

/// The table [[student]] that an assignment file deals this scene with. `own` is the assignment's scene.
std::string student_toml(const std::string& student, const reference::Scene<reference::Decimal>& scene,
                         const reference::Scene<reference::Decimal>& own);

}  // namespace harness::prepare
