#include "reference/render/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace reference::render {
namespace {

struct Timed {
    Rendering rendering;
    double least = HUGE_VAL;  ///< seconds of processor time, of three runs
    double most = 0;
};

Timed timed(const PreparedScene& scene, const Effects& effects, int jobs) {
    Timed result;
    for (int i = 0; i < 3; ++i) {
        result.rendering = render(scene, effects, jobs);
        const double seconds = result.rendering.processor_time.count();
        result.least = std::min(result.least, seconds);
        result.most = std::max(result.most, seconds);
    }
    return result;
}

}  // namespace

std::string explanation(const PreparedScene& scene, int jobs) {
    double load = 0;
    getloadavg(&load, 1);
    const std::vector<Decision> decisions = decide_effects(scene);
    Effects some;
    Timed chosen = timed(scene, some, jobs);
    std::string text = fmt::format("{:<20} {:<4} {:<62} adds, s\n{:<20} {:<4} {:<62} {:.3f}\n", "effect", "", "",
                                   "primary visibility", "on", "every picture has it", chosen.least);
    for (const Decision& decision : decisions) {
        std::string adds;
        if (decision.on) {
            some.*decision.effect = true;
            const double before = chosen.least;
            chosen = timed(scene, some, jobs);
            // Because of noise, a rendering with more effects may be the faster one.
            adds = fmt::format("{:.3f}", std::max(0.0, chosen.least - before));
        }
        const std::string row =
            fmt::format("{:<20} {:<4} {:<62} {}", decision.name, decision.on ? "on" : "off", decision.reason, adds);
        text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    const Timed forced = timed(scene, all_effects, jobs);
    text += fmt::format("\n{:<20} {:>20} {:>20}\n", "", "the scene's effects", "all effects");
    const auto add_counts = [&](std::string_view kind, std::uint64_t Work::*count) {
        text += fmt::format("{:<20} {:>20} {:>20}\n", kind, chosen.rendering.work.*count, forced.rendering.work.*count);
    };
    add_counts("camera rays", &Work::camera_rays);
    add_counts("shadow rays", &Work::shadow_rays);
    add_counts("mirrored rays", &Work::mirrored_rays);
    add_counts("refracted rays", &Work::refracted_rays);
    add_counts("reflected in glass", &Work::rays_reflected_in_glass);
    add_counts("places shaded", &Work::shaded);
    const auto range = [](const Timed& times) { return fmt::format("{:.3f}–{:.3f}", times.least, times.most); };
    text += fmt::format("{:<20} {:>20} {:>20}\n", "processor time, s", range(chosen), range(forced));
    const bool same = chosen.rendering.picture.bytes == forced.rendering.picture.bytes;
    text += fmt::format("{} pictures; all effects take {:.2f}–{:.2f} times as long.\n", same ? "Equal" : "DIFFERENT",
                        forced.least / chosen.most, forced.most / chosen.least);
    constexpr double quiet = 0.5;
    if (load > quiet)
        text += fmt::format("The machine was busy (load {:.1f}): measure again when it is quiet.\n", load);
    return text;
}

}  // namespace reference::render
