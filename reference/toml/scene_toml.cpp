#include "reference/toml/scene_toml.h"

#include <fmt/format.h>

#include "reference/toml/scene_reader.h"
#include "reference/toml/toml_table.h"

namespace reference {
namespace {

std::string vector_text(const Vec3<Decimal>& p) {
    return fmt::format("[{}, {}, {}]", p.x.text(), p.y.text(), p.z.text());
}

}  // namespace

std::string scene_toml(const Scene<Decimal>& scene) {
    const Camera<Decimal>& camera = scene.camera;
    const Window<Decimal>& window = scene.window;
    std::string text = fmt::format("[camera]\neye = {}\nlookat = {}\nvup = {}\n", vector_text(camera.eye),
                                   vector_text(camera.lookat), vector_text(camera.vup));
    text += fmt::format("[window]\nclip_left = {}\nclip_right = {}\nclip_bottom = {}\nclip_top = {}\nclip_near = {}\n",
                        window.clip_left.text(), window.clip_right.text(), window.clip_bottom.text(),
                        window.clip_top.text(), window.clip_near.text());
    text += fmt::format("width = {}\nheight = {}\npixel = [{}, {}]\n", window.width, window.height, scene.pixel.x,
                        scene.pixel.y);
    for (const Sphere<Decimal>& sphere : scene.spheres) {
        text += fmt::format("[[sphere]]\ncenter = {}\nradius = {}\n", vector_text(sphere.center), sphere.radius.text());
    }
    for (const Triangle<Decimal>& triangle : scene.triangles) {
        text += fmt::format("[[triangle]]\nvertices = [{}, {}, {}]\n", vector_text(triangle.A), vector_text(triangle.B),
                            vector_text(triangle.C));
    }
    for (const Cylinder<Decimal>& cylinder : scene.cylinders) {
        text += fmt::format("[[cylinder]]\ncenter = {}\nradius = {}\nheight = {}\n", vector_text(cylinder.center),
                            cylinder.radius.text(), cylinder.height.text());
    }
    return text;
}

Scene<Decimal> check_scene(const Scene<Decimal>& scene, const std::filesystem::path& path) {
    const TomlDocument document(scene_toml(scene), path);
    std::vector<std::string> notes;
    return read_scene(document.root(), notes, PixelKey::required);
}

}  // namespace reference
