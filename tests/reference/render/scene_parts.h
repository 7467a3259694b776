// Parts of scenes that several of these tests are about.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/given/render/scenes.h"

namespace scenes {

constexpr reference::render::Effects with_shadows{true, true, false, false, false};

inline const std::string lamp = "[[light]]\nposition = [2, 3, 3]\ncolor = [1, 1, 1]\n";
inline const std::string clay = material("clay", "diffuse = [1, 1, 1]");

/// A large triangle at this z.
inline std::string level_at(const std::string& z) {
    return triangle(fmt::format("[[-9, -9, {0}], [9, -9, {0}], [0, 9, {0}]]", z));
}
inline const std::string level_at_5 = level_at("5");
/// On level_at_5. From here rays go straight down along -z.
inline const reference::Vec3<double> above(0.125, 0.25, 5);

}  // namespace scenes
