#include "reference/toml/other_scenes_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/toml/scene_toml.h"

namespace reference {
namespace {

Vec3<Decimal> vector_from(const std::vector<Decimal>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

void change_camera(const TomlTable& table, Camera<Decimal>& camera) {
    table.allow_only({"eye", "lookat", "vup"});
    if (table.has("eye")) camera.eye = vector_from(table.decimals("eye", 3));
    if (table.has("lookat")) camera.lookat = vector_from(table.decimals("lookat", 3));
    if (table.has("vup")) camera.vup = vector_from(table.decimals("vup", 3));
}

void change_pixel(const TomlTable& table, Scene<Decimal>& scene) {
    table.allow_only({"pixel"});
    if (!table.has("pixel")) return;
    const std::vector<Decimal> pixel = table.decimals("pixel", 2);
    const auto whole = [&](const Decimal& number, int count) {
        const double index = number.to_double();
        if (index >= 0 && index < count && index == static_cast<int>(index)) return static_cast<int>(index);
        table.fail("pixel", fmt::format("{} is not a pixel of the window: write a whole number from 0 to {}",
                                        number.text(), count - 1));
    };
    scene.pixel = {whole(pixel[0], scene.window.width), whole(pixel[1], scene.window.height)};
}

void change_sphere(const TomlTable& variant, Scene<Decimal>& scene) {
    if (scene.spheres.empty()) variant.fail("sphere", "is none of this scene's, which has no sphere to change");
    const TomlTable table = variant.table("sphere");
    table.allow_only({"center", "radius"});
    if (table.has("center")) scene.spheres.front().center = vector_from(table.decimals("center", 3));
    if (table.has("radius")) scene.spheres.front().radius = table.decimal("radius");
}

void change_triangle(const TomlTable& variant, Scene<Decimal>& scene) {
    if (scene.triangles.empty()) variant.fail("triangle", "is none of this scene's, which has no triangle to change");
    const TomlTable table = variant.table("triangle");
    table.allow_only({"vertices"});
    if (!table.has("vertices")) return;
    const auto rows = table.decimal_rows("vertices", 3, 3);
    scene.triangles.front() = {vector_from(rows[0]), vector_from(rows[1]), vector_from(rows[2])};
}

void change_cylinder(const TomlTable& variant, Scene<Decimal>& scene) {
    if (scene.cylinders.empty()) variant.fail("cylinder", "is none of this scene's, which has no cylinder to change");
    const TomlTable table = variant.table("cylinder");
    table.allow_only({"center", "radius", "height"});
    Cylinder<Decimal>& cylinder = scene.cylinders.front();
    if (table.has("center")) cylinder.center = vector_from(table.decimals("center", 3));
    if (table.has("radius")) cylinder.radius = table.decimal("radius");
    if (table.has("height")) cylinder.height = table.decimal("height");
}

/// Tells what is wrong with a changed scene at the key that makes it so. `named` is the key with the scene's name.
[[noreturn]] void fail_in(const TomlTable& table, std::string_view named, const std::string& name,
                          const AssignmentError& error) {
    const std::string_view path = error.key();  // "sphere[1].radius"
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string part(path.substr(0, std::min(path.find('['), dot)));
    const std::string key(path.substr(std::min(dot + 1, path.size())));
    const std::string of_scene =
        fmt::format("makes a scene that can't be marked, \"{}\": {} {}", name, path, error.problem());
    if (!table.has(part)) table.fail(named, of_scene);
    const TomlTable changed = table.table(part);
    if (!changed.has(key)) table.fail(part, of_scene);
    changed.fail(key, fmt::format("{}, in \"{}\"", error.problem(), name));
}

/// The scene with the changes that the table states. `named` is the table's key that holds `name`.
Scene<Decimal> changed_scene(const TomlTable& table, std::string_view named, const std::string& name,
                             const Scene<Decimal>& scene, const std::filesystem::path& path) {
    table.allow_only({named, "camera", "window", "sphere", "triangle", "cylinder"});
    Scene<Decimal> changed = scene;
    if (table.has("camera")) change_camera(table.table("camera"), changed.camera);
    if (table.has("window")) change_pixel(table.table("window"), changed);
    if (table.has("sphere")) change_sphere(table, changed);
    if (table.has("triangle")) change_triangle(table, changed);
    if (table.has("cylinder")) change_cylinder(table, changed);
    try {
        check_scene(changed, path);
    } catch (const AssignmentError& error) {
        fail_in(table, named, name, error);
    }
    return changed;
}

}  // namespace

std::vector<OtherScene> read_other_scenes(const TomlTable& root, const Scene<Decimal>& scene,
                                          const std::filesystem::path& path) {
    std::vector<OtherScene> variants;
    for (const TomlTable& table : root.tables("variant")) {
        const std::string name =
            table.has("name") ? table.string("name") : fmt::format("variant {}", variants.size() + 1);
        variants.push_back({name, changed_scene(table, "name", name, scene, path)});
        if (scene_toml(variants.back().scene) == scene_toml(scene)) {
            table.fail("name", fmt::format("\"{}\" changes nothing of the scene; state a camera.eye, sphere.center, "
                                           "triangle.vertices, … that differs",
                                           name));
        }
    }
    return variants;
}

std::map<std::string, Scene<Decimal>> read_dealt_scenes(const TomlTable& root, const Scene<Decimal>& scene,
                                                        const std::filesystem::path& path) {
    std::map<std::string, Scene<Decimal>> dealt;
    for (const TomlTable& table : root.tables("student")) {
        const std::string id = table.string("id");
        if (id.empty()) table.fail("id", "is empty; write the student's id, as submissions are named");
        if (!dealt.emplace(id, changed_scene(table, "id", id, scene, path)).second)
            table.fail("id", fmt::format("\"{}\" stands twice; keep one scene for each student", id));
    }
    return dealt;
}

}  // namespace reference
