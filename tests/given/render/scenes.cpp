#include "tests/given/render/scenes.h"

#include <fmt/format.h>

#include "reference/render/trace.h"

namespace scenes {

using namespace reference;

std::string with_camera(const std::string& rest) {
    return "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n"
           "[window]\nclip_left = -2\nclip_right = 2\nclip_bottom = -1.5\nclip_top = 1.5\nclip_near = 2\n"
           "width = 40\nheight = 30\npixel = [20, 15]\n" +
           rest;
}

namespace {

std::string material_line(const std::string& material) {
    return material.empty() ? "" : fmt::format("material = \"{}\"\n", material);
}

}  // namespace

std::string sphere(const std::string& center, const std::string& radius, const std::string& material) {
    return fmt::format("[[sphere]]\ncenter = {}\nradius = {}\n", center, radius) + material_line(material);
}

std::string triangle(const std::string& vertices, const std::string& material) {
    return fmt::format("[[triangle]]\nvertices = {}\n", vertices) + material_line(material);
}

std::string cylinder(const std::string& center, const std::string& radius, const std::string& height,
                     const std::string& material) {
    return fmt::format("[[cylinder]]\ncenter = {}\nradius = {}\nheight = {}\n", center, radius, height) +
           material_line(material);
}

std::string material(const std::string& name, const std::string& properties) {
    return fmt::format("[[material]]\nname = \"{}\"\n{}\n", name, properties);
}

std::string room(const Wishes& wishes) {
    std::string text = "[render]\nbackground = [0.5, 0.6, 0.7]\n";
    if (wishes.light) text += "ambient_light = [0.1, 0.1, 0.2]\n";
    if (wishes.samples) text += "samples_per_pixel = 4\n";
    if (wishes.light) {
        text +=
            "[[light]]\nposition = [2, 3, 3]\ncolor = [0.6, 0.5, 0.4]\n"
            "[[light]]\ndirection = [1, -2, -1]\ncolor = [0.3, 0.3, 0.3]\n";
    }
    const std::string mirror = wishes.mirror ? "reflectivity = 0.5\n" : "";
    const std::string glass = wishes.glass ? "transparency = 0.75\nrefractive_index = 1.5\n" : "";
    text += material("shiny", "diffuse = [0.2, 0.3, 0.9]\nspecular = [0.5, 0.5, 0.5]\nshininess = 20\n" + mirror);
    text += material("clear", "specular = [0.5, 0.5, 0.5]\nshininess = 50\n" + glass);
    text += material("wall", "ambient = [1, 1, 1]\ndiffuse = [0.7, 0.7, 0.5]");
    text += sphere("[-0.9, -0.3, 0]", "0.7", "shiny") + sphere("[0.7, -0.2, 0.4]", "0.8", "clear") +
            sphere("[0.1, 0.9, -1]", "0.5");
    text += cylinder("[1.5, 0.9, 0]", "0.3", "0.4", "clear") + cylinder("[-0.1, -0.75, 0.9]", "0.25", "0.5", "shiny") +
            cylinder("[-1.6, 0.8, -1]", "0.3", "1", "wall");
    text += triangle("[[-4, -1, 3], [4, -1, 3], [4, -1, -4]]", "wall") +
            triangle("[[-4, -1, 3], [4, -1, -4], [-4, -1, -4]]", "wall") +
            triangle("[[-4, -1, -4], [4, -1, -4], [4, 3, -4]]", "shiny") +
            triangle("[[-4, -1, -4], [4, 3, -4], [-4, 3, -4]]", "shiny");
    return with_camera(text);
}

render::PreparedScene prepared(const std::string& toml) {
    return render::prepare_scene(parse_assignment(toml, "folder/scene.toml"), {});
}

render::PreparedScene prepared_assignment(const std::string& name) {
    return render::prepare_scene(load_assignment(name, RAYGRADE_ASSIGNMENTS), {});
}

std::vector<Color> colors_of(const render::PreparedScene& scene, const render::Effects& effects) {
    const auto width = static_cast<std::size_t>(scene.width);
    std::vector<Color> result(width * static_cast<std::size_t>(scene.height));
    render::Work work;
    for (int y = 0; y < scene.height; ++y) {
        const auto row = std::span(result).subspan(static_cast<std::size_t>(y) * width, width);
        render::render_row(scene, effects, y, row, work);
    }
    return result;
}

}  // namespace scenes
