// What the key tells of a scene, as far as pictures show it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "harness/report/sketch/point.h"
#include "reference/stages/items.h"

namespace harness::report::picture {

/// What the key tells of a kind of object, by the object that the questions are about.
struct RightHit {
    std::optional<Point> hit, normal;
    std::size_t index = 0;  ///< of that object
};

/// The key's values as pictures need them. A value is empty if the scene does not ask for it or the ray misses.
struct RightValues {
    std::optional<Point> P_VCS, X_vcs, Y_vcs, Z_vcs, P_WCS, V;
    std::map<reference::Subject, RightHit> objects = {};

    RightHit of(reference::Subject kind) const {
        const auto found = objects.find(kind);
        return found == objects.end() ? RightHit() : found->second;
    }
};

}  // namespace harness::report::picture
