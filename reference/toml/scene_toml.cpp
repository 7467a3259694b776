#include "reference/toml/scene_toml.h"

#include <fmt/format.h>

#include "reference/toml/scene_reader.h"
#include "reference/toml/toml_table.h"

namespace reference {

std::string toml_value(const Decimal& x) {
    return std::string(x.text());
}

std::string toml_value(const Vec3<Decimal>& p) {
    return fmt::format("[{}, {}, {}]", p.x.text(), p.y.text(), p.z.text());
}

std::string toml_value(const Vertices<const Vec3<Decimal>>& vertices) {
    return fmt::format("[{}, {}, {}]", toml_value(*vertices[0]), toml_value(*vertices[1]), toml_value(*vertices[2]));
}

std::string scene_toml(const Scene<Decimal>& scene) {
    const Camera<Decimal>& camera = scene.camera;
    const Window<Decimal>& window = scene.window;
    std::string text = fmt::format("[camera]\neye = {}\nlookat = {}\nvup = {}\n", toml_value(camera.eye),
                                   toml_value(camera.lookat), toml_value(camera.vup));
    text += fmt::format("[window]\nclip_left = {}\nclip_right = {}\nclip_bottom = {}\nclip_top = {}\nclip_near = {}\n",
                        window.clip_left.text(), window.clip_right.text(), window.clip_bottom.text(),
                        window.clip_top.text(), window.clip_near.text());
    text += fmt::format("width = {}\nheight = {}\npixel = [{}, {}]\n", window.width, window.height, scene.pixel.x,
                        scene.pixel.y);
    for_each_kind(
        [&](Subject kind, const auto& objects_of_kind) {
            for (const auto& object : objects_of_kind) {
                text += fmt::format("[[{}]]\n", to_string(kind));
                const auto write = [&](std::string_view key, const auto& field) {
                    text += fmt::format("{} = {}\n", key, toml_value(field));
                };
                for_each_field(write, object);
            }
        },
        scene);
    return text;
}

Scene<Decimal> check_scene(const Scene<Decimal>& scene, const std::filesystem::path& path) {
    const TomlDocument document(scene_toml(scene), path);
    std::vector<std::string> notes;
    return read_scene(document.root(), notes, PixelKey::required);
}

}  // namespace reference
