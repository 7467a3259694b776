#include "harness/grade/score_memo.h"

#include <utility>

#include "harness/machine/fingerprint.h"
#include "reference/toml/scene_toml.h"

namespace harness {
namespace {

/// A cryptographic hash, because an output takes up to a mebibyte, and students could collude on a collision.
std::string name_of(const std::string& output) {
    return Fingerprint("raygrade/score-memo/1").add(output).hex();
}

}  // namespace

std::shared_ptr<const Score> ScoreMemo::find(const std::string& output) const {
    const std::string name = name_of(output);
    const std::lock_guard guard(mutex_);
    const auto found = scores_.values.find(name);
    return found == scores_.values.end() ? nullptr : found->second;
}

void ScoreMemo::keep(const std::string& output, std::shared_ptr<const Score> score) {
    std::string name = name_of(output);
    const std::lock_guard guard(mutex_);
    scores_.keep(std::move(name), std::move(score), most_scores_);
}

std::shared_ptr<const Marking> ScoreMemo::on_scene(const reference::Scene<reference::Decimal>& scene,
                                                   const std::function<std::shared_ptr<const Marking>()>& make) {
    constexpr std::size_t most_markings = 32;
    const std::string name = reference::scene_toml(scene);
    {
        const std::lock_guard guard(mutex_);
        if (const auto found = markings_.values.find(name); found != markings_.values.end()) return found->second;
    }
    auto marking = make();
    const std::lock_guard guard(mutex_);
    markings_.keep(name, marking, most_markings);
    return marking;
}

}  // namespace harness
