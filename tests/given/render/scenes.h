// Scenes of the tests, as their files' text.
#pragma once

#include <string>

#include "reference/render/effects.h"
#include "reference/render/prepared_scene.h"

namespace scenes {

/// The look of a camera at (0, 0, 4) that looks along -z, with a window of 40 x 30 pixels; `rest` follows.
std::string with_camera(const std::string& rest);
std::string sphere(const std::string& center, const std::string& radius, const std::string& material = "");
std::string triangle(const std::string& vertices, const std::string& material = "");
/// `properties` are TOML lines.
std::string material(const std::string& name, const std::string& properties);

/// Some balls, a floor and a back wall of two triangles each, with what is asked for of lights, mirror, glass and
/// samples.
struct Wishes {
    bool light = false;
    bool mirror = false;
    bool glass = false;
    bool samples = false;
    bool many = false;  ///< so many balls that there is a tree
};
std::string room(const Wishes& wishes);

reference::render::PreparedScene prepared(const std::string& toml);
reference::render::PreparedScene prepared_assignment(const std::string& name);

/// The colors of the whole picture, row by row from the bottom.
std::vector<reference::Color> colors_of(const reference::render::PreparedScene& scene,
                                        const reference::render::Effects& effects);

}  // namespace scenes
