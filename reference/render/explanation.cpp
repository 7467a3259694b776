#include "reference/render/explanation.h"

#include <fmt/format.h>

#include <algorithm>

namespace reference::render {
namespace {

constexpr std::string_view primary_visibility = "primary visibility";

/// The shortest of three runs: the one that other work on the machine disturbed least.
std::chrono::duration<double> time_of(const PreparedScene& scene, const Effects& effects, int jobs) {
    auto least = render(scene, effects, jobs).processor_time;
    for (int i = 0; i < 2; ++i) least = std::min(least, render(scene, effects, jobs).processor_time);
    return least;
}

}  // namespace

std::vector<EffectTime> time_by_effect(const PreparedScene& scene, const std::vector<Decision>& decisions,
                                       const Effects& effects, int jobs) {
    Effects some;
    auto before = time_of(scene, some, jobs);
    std::vector<EffectTime> times{{primary_visibility, before}};
    for (const Decision& decision : decisions) {
        if (!(effects.*decision.effect)) continue;
        some.*decision.effect = true;
        const auto with = time_of(scene, some, jobs);
        // Noise may make a rendering with more effects the faster one.
        times.push_back({decision.name, std::max(with - before, std::chrono::duration<double>::zero())});
        before = with;
    }
    return times;
}

std::string explanation(const std::vector<Decision>& decisions, const Rendering& rendering,
                        const std::vector<EffectTime>& times) {
    std::string text = fmt::format("{:<20} on   every picture has it\n", primary_visibility);
    for (const Decision& decision : decisions) {
        text += fmt::format("{:<20} {:<4} {}\n", decision.name, decision.on ? "on" : "off", decision.reason);
    }
    text += "\nrays\n";
    const auto add_rays = [&](std::string_view kind, std::uint64_t count) {
        text += fmt::format("  {:<18} {:>12}\n", kind, count);
    };
    add_rays("camera", rendering.work.camera_rays);
    add_rays("shadow", rendering.work.shadow_rays);
    add_rays("mirrored", rendering.work.mirrored_rays);
    add_rays("refracted", rendering.work.refracted_rays);
    add_rays("reflected in glass", rendering.work.rays_reflected_in_glass);
    text += "\nprocessor time, in seconds\n";
    for (const EffectTime& time : times) text += fmt::format("  {:<18} {:>12.3f}\n", time.effect, time.time.count());
    return text;
}

}  // namespace reference::render
