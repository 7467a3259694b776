#include "reference/toml/variants_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/toml/assignment_error.h"
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
        table.fail("pixel", fmt::format("has {}, which is not a pixel of the window; write a whole number from 0 to {}",
                                        number.text(), count - 1));
    };
    scene.pixel = {whole(pixel[0], scene.window.width), whole(pixel[1], scene.window.height)};
}

/// Changes the fields of an object that the table states.
struct FieldChange {
    const TomlTable& table;

    void operator()(std::string_view key, Decimal& number) const {
        if (table.has(key)) number = table.decimal(key);
    }
    void operator()(std::string_view key, Vec3<Decimal>& point) const {
        if (table.has(key)) point = vector_from(table.decimals(key, 3));
    }
    void operator()(std::string_view key, const Vertices<Vec3<Decimal>>& vertices) const {
        if (!table.has(key)) return;
        const auto rows = table.decimal_rows(key, vertices.size(), 3);
        for (std::size_t i = 0; i < vertices.size(); ++i) *vertices[i] = vector_from(rows[i]);
    }
};

/// Changes the first of the scene's objects of a kind, if the variant has a table of that name.
template <class Object>
void change_first(const TomlTable& variant, Subject kind, std::vector<Object>& of_scene) {
    const std::string_view name = to_string(kind);
    if (!variant.has(name)) return;
    if (of_scene.empty())
        variant.fail(name, fmt::format("cannot change, because the scene has no {}; leave it out", name));
    const TomlTable table = variant.table(name);
    table.allow_only(field_names<Object>());
    for_each_field(FieldChange{table}, of_scene.front());
}

/// Reports the problem of a changed scene at the key that causes it. `named` is the key with the scene's name.
[[noreturn]] void fail_in(const TomlTable& table, std::string_view named, const std::string& name,
                          const AssignmentError& error) {
    const std::string_view path = error.key();  // "sphere[1].radius"
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string part(path.substr(0, std::min(path.find('['), dot)));
    const std::string key(path.substr(std::min(dot + 1, path.size())));
    const std::string of_scene =
        fmt::format("makes a scene that cannot be marked, \"{}\": {} {}", name, path, error.problem());
    if (!table.has(part)) table.fail(named, of_scene);
    const TomlTable changed = table.table(part);
    if (!changed.has(key)) table.fail(part, of_scene);
    changed.fail(key, fmt::format("{}, in \"{}\"", error.problem(), name));
}

/// The scene with the table's changes. `named` is the key of `name` in the table.
Scene<Decimal> changed_scene(const TomlTable& table, std::string_view named, const std::string& name,
                             const Scene<Decimal>& scene, const std::filesystem::path& path) {
    std::vector<std::string_view> keys{named, "camera", "window"};
    for (const Subject kind : objects) keys.push_back(to_string(kind));
    table.allow_only(keys);
    Scene<Decimal> changed = scene;
    if (table.has("camera")) change_camera(table.table("camera"), changed.camera);
    if (table.has("window")) change_pixel(table.table("window"), changed);
    for_each_kind([&](Subject kind, auto& of_scene) { change_first(table, kind, of_scene); }, changed);
    try {
        check_scene(changed, path);
    } catch (const AssignmentError& error) {
        fail_in(table, named, name, error);
    }
    return changed;
}

}  // namespace

std::vector<Variant> read_variants(const TomlTable& root, const Scene<Decimal>& scene,
                                   const std::filesystem::path& path) {
    std::vector<Variant> variants;
    for (const TomlTable& table : root.tables("variant")) {
        const std::string name =
            table.has("name") ? table.string("name") : fmt::format("variant {}", variants.size() + 1);
        if (std::ranges::find(variants, name, &Variant::name) != variants.end())
            table.fail("name", fmt::format("is \"{}\" twice; give each variant its own name", name));
        variants.push_back({name, changed_scene(table, "name", name, scene, path)});
        if (scene_toml(variants.back().scene) == scene_toml(scene)) {
            table.fail("name", fmt::format("is \"{}\", which changes nothing in the scene; give it another camera.eye, "
                                           "sphere.center, triangle.vertices, …",
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
        if (id.empty()) table.fail("id", "is empty; write the student's id, the name of the submission");
        if (!dealt.emplace(id, changed_scene(table, "id", id, scene, path)).second)
            table.fail("id", fmt::format("is \"{}\" twice; keep one scene for each student", id));
    }
    return dealt;
}

}  // namespace reference
