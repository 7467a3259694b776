// An instructor's word in place of an automatic mark.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The `item` of question 0 for the points that answers on other scenes have, and how people write it.
inline constexpr std::string_view other_scenes_place = "variants";

/// Where it stands, the automatic mark no longer counts; it is shown beside it.
struct Override {
    int question = 0;   ///< the handout's, 1 to 10; 0 for those of the whole submission or of other scenes
    std::string item;   ///< of the question, e.g. "t"; empty for all of it; or other_scenes_place
    double points = 0;  ///< 0 or more; may be more than the rubric's, as for a good idea
    std::string why;    ///< the instructor's reason, never empty
    std::string by;     ///< who
    std::string when;   ///< in UTC, as 2026-11-22T09:30:00Z (ISO 8601)
};

}  // namespace harness
