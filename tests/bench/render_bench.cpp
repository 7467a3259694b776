// render_bench [ROUNDS [WIDTH HEIGHT]]: what is saved by computing only the effects that a scene calls for. Renders
// five scenes in turn on one core: as they are, and with every effect added to them, as a renderer with defaults would.
// Prints the median processor times in seconds as a table. Needs a quiet machine.
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
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    const PictureSize size = argc > 3 ? PictureSize{std::atoi(argv[2]), std::atoi(argv[3])} : PictureSize{1280, 720};
    fmt::print("| scene | what it calls for | every effect on it | × |\n|---|---:|---:|---:|\n");
    for (const std::string name : {"2021", "lit", "shadowed", "mirrors", "glass"}) {
        const PreparedScene scene = prepare_scene(load(name), size);
        const PreparedScene full = with_every_effect(load(name), size);
        const Effects called_for = effects_of(decide_effects(scene));
        std::vector<double> own;
        std::vector<double> every;
        for (int round = 0; round < rounds; ++round) {
            own.push_back(render::render(scene, called_for, 1).processor_time.count());
            every.push_back(render::render(full, all_effects, 1).processor_time.count());
        }
        fmt::print("| {} | {:.3f} | {:.3f} | {:.1f} |\n", name, median(own), median(every),
                   median(every) / median(own));
    }
}
