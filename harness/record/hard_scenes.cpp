#include "harness/record/hard_scenes.h"

#include <algorithm>

namespace harness {

std::string_view to_string(Loss loss) {
    switch (loss) {
        case Loss::digits: return "digits";
        case Loss::wrong: return "wrong";
        case Loss::missing: return "missing";
        case Loss::not_a_number: return "not_a_number";
        case Loss::hit_missed: return "hit_missed";
        case Loss::miss_hit: return "miss_hit";
        case Loss::other_first: return "other_first";
    }
    return "";
}

bool HardResult::survives() const {
    return skipped.empty() && ended.empty() &&
           std::all_of(items.begin(), items.end(), [](const HardItem& item) { return item.loss == Loss::digits; });
}

std::size_t HardScenesReport::tried() const {
    return static_cast<std::size_t>(
        std::count_if(scenes.begin(), scenes.end(), [](const HardResult& scene) { return scene.skipped.empty(); }));
}

std::size_t HardScenesReport::survived() const {
    return static_cast<std::size_t>(
        std::count_if(scenes.begin(), scenes.end(), [](const HardResult& scene) { return scene.survives(); }));
}

}  // namespace harness
