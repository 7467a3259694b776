// primary_loop SCENE minimal | own | EFFECT: renders a scene that needs only primary visibility: with the minimal loop,
// with the loop for the scene's own effects, or with one effect forced on (illumination, shadows with illumination,
// mirrors, refraction, supersampling). SCENE is `objects`, or `background` without objects, where a pixel costs least.
// callgrind counts the instructions between its toggles. Prints a checksum of the picture, the same for all ways of
// rendering a scene.
#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <string>

#include "reference/render/trace/rows.h"
#include "tests/checks/minimal_loop.h"
#include "tests/given/render/scenes.h"

using namespace reference;
using namespace reference::render;

namespace {

Effects effects_for(const std::string& way) {
    if (way == "own") return {};
    if (way == "illumination") return {true, false, false, false, false};
    if (way == "shadows") return {true, true, false, false, false};
    if (way == "mirrors") return {false, false, true, false, false};
    if (way == "refraction") return {false, false, false, true, false};
    if (way == "textures") return {true, false, false, false, false, true};
    if (way == "supersampling") return {false, false, false, false, true};
    throw std::invalid_argument("no way to render: " + way);
}

std::string scene_named(const std::string& name) {
    if (name == "background") return scenes::with_camera("[render]\nbackground = [0.5, 0.25, 0.125]\n");
    if (name != "objects") throw std::invalid_argument("no scene: " + name);
    return scenes::with_camera(scenes::sphere("[0.4, 0.3, 0.1]", "1.1") +
                               scenes::triangle("[[-2.3, -1.4, 0.7], [1.9, -1.1, -0.4], [-0.2, 1.7, 0.3]]"));
}

}  // namespace

int main(int argc, char** argv) {
    const std::string way = argc == 3 ? argv[2] : "";
    const PreparedScene scene = scenes::prepared(scene_named(argc == 3 ? argv[1] : ""));
    if (effects_of(decide_effects(scene)) != Effects{}) throw std::logic_error("the scene calls for more");
    std::vector<Color> colors(static_cast<std::size_t>(scene.width));
    RayCounts counts;
    double sum = 0;
    const RenderRow render_row = way == "minimal" ? nullptr : row_renderer(scene, effects_for(way));
    for (int y = 0; y < scene.height; ++y) {
        CALLGRIND_TOGGLE_COLLECT;
        if (render_row == nullptr) {
            minimal_row(scene, y, colors);
        } else {
            render_row(scene, y, colors, counts);
        }
        CALLGRIND_TOGGLE_COLLECT;
        for (const Color& color : colors) sum += color.x + 2 * color.y + 3 * color.z;
    }
    fmt::print("{:.17g}\n", sum);
}
