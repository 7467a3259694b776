// render_bench ROUNDS WIDTH HEIGHT: renders five scenes in turn on one core: with the effects that each scene needs;
// with the loop for all effects, on the unchanged scene; and with every effect added to the scene, as a renderer with
// defaults would. Prints one CSV line per scene: its name and the median processor times in seconds. See
// tests/bench/render.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "reference/render/picture.h"

using namespace reference;
using namespace reference::render;

namespace {

double median(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    return (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]) / 2;
}

Assignment load(const std::string& name) {
    const std::string folder = RAYGRADE_REFERENCE;
    return name == "2021" ? load_assignment("a6-2021", folder + "/assignments")
                          : load_scene(folder + "/scenes/" + name + ".toml");
}

/// Adds a light, partly mirroring and transparent surfaces where the scene has none, and four samples per pixel.
PreparedScene with_every_effect(Assignment assignment, PictureSize size) {
    Appearance& look = assignment.appearance;
    look.samples_per_pixel = std::max(look.samples_per_pixel, 4);
    if (look.point_lights.empty() && look.directional_lights.empty()) {
        look.directional_lights.push_back({{1, -3, -1}, {0.7, 0.7, 0.7}});
    }
    PreparedScene scene = prepare_scene(assignment, size);
    for (Surface& surface : scene.surfaces) {
        Material& material = surface.material;
        if (!surface.is_lit) material.diffuse = {0.8, 0.8, 0.8};
        surface.is_lit = true;
        if (material.reflectivity == 0) material.reflectivity = 0.1;
        if (material.transparency == 0 && material.reflectivity <= 0.9) {
            material.transparency = 0.1;
            material.refractive_index = 1.5;
        }
        surface.own_share = 1 - material.reflectivity - material.transparency;
    }
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        fmt::print(stderr, "render_bench ROUNDS WIDTH HEIGHT\n");
        return 2;
    }
    const int rounds = std::atoi(argv[1]);
    const PictureSize size{std::atoi(argv[2]), std::atoi(argv[3])};
    for (const std::string name : {"2021", "lit", "shadowed", "mirrors", "glass"}) {
        const PreparedScene scene = prepare_scene(load(name), size);
        const PreparedScene full = with_every_effect(load(name), size);
        const Effects called_for = effects_of(decide_effects(scene));
        std::vector<double> own;
        std::vector<double> all;
        std::vector<double> every;
        for (int round = 0; round < rounds; ++round) {
            const Rendering one = render::render(scene, called_for, 1);
            const Rendering other = render::render(scene, all_effects, 1);
            if (one.picture.bytes != other.picture.bytes) {
                fmt::print(stderr, "render_bench: {}: two pictures\n", name);
                return 1;
            }
            own.push_back(one.processor_time.count());
            all.push_back(other.processor_time.count());
            every.push_back(render::render(full, all_effects, 1).processor_time.count());
        }
        fmt::print("{},{:.6f},{:.6f},{:.6f}\n", name, median(own), median(all), median(every));
    }
}
