// The text of scene files for tests.
#pragma once

#include <string>

#include "reference/render/effects.h"
#include "reference/render/prepared_scene.h"

namespace scenes {

/// A camera at (0, 0, 4) that looks along -z, with a window of 40 x 30 pixels, followed by `rest`.
std::string with_camera(const std::string& rest);
std::string sphere(const std::string& center, const std::string& radius, const std::string& material = "");
std::string triangle(const std::string& vertices, const std::string& material = "");
std::string cylinder(const std::string& center, const std::string& radius, const std::string& height,
                     const std::string& material = "");
/// `properties` are TOML lines.
std::string material(const std::string& name, const std::string& properties);

/// What room() adds to its balls, its columns, its floor and its back wall (two triangles each).
struct Wishes {
    bool light = false;
    bool mirror = false;
    bool glass = false;
    bool samples = false;
};
std::string room(const Wishes& wishes);

reference::render::PreparedScene prepared(const std::string& toml);
reference::render::PreparedScene prepared_assignment(const std::string& name);

/// The colors of the whole picture, row by row from the bottom.
std::vector<reference::Color> colors_of(const reference::render::PreparedScene& scene,
                                        const reference::render::Effects& effects);

}  // namespace scenes
