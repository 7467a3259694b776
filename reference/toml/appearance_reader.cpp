#include "reference/toml/appearance_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

constexpr double largest_length = 1e30;
constexpr double brightest_light = 1e6;
constexpr int most_samples_per_side = 16;

Vec3<double> read_numbers(const TomlTable& table, std::string_view key, double least, double most) {
    Vec3<double> result;
    const std::vector<Decimal> numbers = table.decimals(key, 3);
    for (int i = 0; i < 3; ++i) {
        const double x = numbers[static_cast<std::size_t>(i)].to_double();
        if (!(least <= x && x <= most)) {
            table.fail(key, fmt::format("must be three numbers from {} to {}", least, most));
        }
        result[i] = x;
    }
    return result;
}

Vec3<double> read_double_vector(const TomlTable& table, std::string_view key) {
    return read_numbers(table, key, -largest_length, largest_length);
}

/// A grid has a square number of samples.
int read_samples(const TomlTable& table, std::string_view key) {
    constexpr int most = most_samples_per_side * most_samples_per_side;
    const int samples = table.integer(key, 1, most);
    const auto side = static_cast<int>(std::lround(std::sqrt(samples)));
    if (side * side == samples) return samples;
    table.fail(key, fmt::format("must be a square number: 1, 4, 9, 16 up to {}", most));
}

void read_light(const TomlTable& table, Appearance& appearance) {
    table.allow_only({"position", "direction", "color"});
    if (table.has("position") == table.has("direction")) {
        table.fail("position", "and direction: give one of the two");
    }
    const Color color = read_numbers(table, "color", 0, brightest_light);
    if (table.has("position")) {
        appearance.point_lights.push_back({read_double_vector(table, "position"), color});
        return;
    }
    const Vec3<double> direction = read_double_vector(table, "direction");
    if (std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}) < 1 / largest_length) {
        table.fail("direction", "is zero; write the direction in which the light travels, such as [0, -1, 0]");
    }
    appearance.directional_lights.push_back({direction, color});
}

Material read_material(const TomlTable& table) {
    table.allow_only(
        {"name", "ambient", "diffuse", "specular", "shininess", "reflectivity", "transparency", "refractive_index"});
    Material material;
    if (table.has("ambient")) material.ambient = read_numbers(table, "ambient", 0, 1);
    if (table.has("diffuse")) material.diffuse = read_numbers(table, "diffuse", 0, 1);
    if (table.has("specular")) material.specular = read_numbers(table, "specular", 0, 1);
    if (table.has("shininess")) material.shininess = table.integer("shininess", 1, 100000);
    if (table.has("reflectivity")) material.reflectivity = table.amount("reflectivity", 0, 1);
    if (table.has("transparency")) material.transparency = table.amount("transparency", 0, 1);
    if (table.has("refractive_index")) material.refractive_index = table.amount("refractive_index", 0.01, 100);
    if (material.reflectivity + material.transparency > 1) {
        table.fail("reflectivity", "and transparency share the same light; their sum must be at most 1");
    }
    return material;
}

/// The materials' names, in the order of Appearance::materials.
std::vector<std::string> read_materials(const TomlTable& root, Appearance& appearance) {
    std::vector<std::string> names;
    for (const TomlTable& table : root.tables("material")) {
        const std::string name = table.string("name");
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            table.fail("name", fmt::format("is \"{}\" in two materials; give each its own name", name));
        }
        names.push_back(name);
        appearance.materials.push_back(read_material(table));
    }
    return names;
}

std::optional<std::size_t> read_choice(const TomlTable& table, const std::vector<std::string>& names) {
    if (!table.has("material")) return std::nullopt;
    const std::string name = table.string("material");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        table.fail("material",
                   names.empty()
                       ? fmt::format("is \"{}\", but there is no such material; add it as a [[material]]", name)
                       : fmt::format("is \"{}\", which is not one of {}", name, fmt::join(names, ", ")));
    }
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

Appearance read_appearance(const TomlTable& root) {
    Appearance appearance;
    for (const TomlTable& light : root.tables("light")) read_light(light, appearance);
    const std::vector<std::string> names = read_materials(root, appearance);
    for (const Subject kind : objects) {
        for (const TomlTable& object : root.tables(to_string(kind)))
            appearance.object_materials[kind].push_back(read_choice(object, names));
    }
    if (!root.has("render")) return appearance;
    const TomlTable render = root.table("render");
    render.allow_only({"ambient_light", "background", "samples_per_pixel"});
    if (render.has("ambient_light"))
        appearance.ambient_light = read_numbers(render, "ambient_light", 0, brightest_light);
    if (render.has("background")) appearance.background = read_numbers(render, "background", 0, 1);
    if (render.has("samples_per_pixel")) appearance.samples_per_pixel = read_samples(render, "samples_per_pixel");
    return appearance;
}

}  // namespace reference
