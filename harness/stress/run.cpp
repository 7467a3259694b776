#include "harness/stress/run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "harness/stress/generate.h"
#include "harness/stress/losses.h"

namespace harness::stress {
namespace {

using source::PartSet;
using variants::MarkedScene;
using variants::Rewritten;
using variants::SceneRun;

/// The hard scenes for all programs with the same located parts and the same pixel convention.
struct HardSet {
    std::vector<HardScene> scenes;
    std::vector<MarkedScene> marked;  ///< the scenes that could be made
};

/// The marking for hard scenes. It accepts one pixel convention, and only the certified allowance, because a rubric's
/// tolerance is for its own scene.
Marking for_hard_scenes(const Marking& marking, reference::PixelConvention convention) {
    Marking held = marking;
    held.assignment.rubric.pixel_conventions = {convention};
    held.assignment.rubric.tolerance.reset();
    held.assignment.rubric.item_tolerance.clear();
    return held;
}

/// How the program ended on the scene; empty if it finished.
std::string_view ended_there(Outcome outcome) {
    switch (outcome) {
        case Outcome::crashed: return "The program crashed.";
        case Outcome::timed_out: return "The program hit its time limit.";
        case Outcome::output_limit: return "The program printed too much.";
        case Outcome::memory_limit: return "The program used too much memory.";
        case Outcome::no_output: return "The program printed nothing.";
        case Outcome::graded:
        case Outcome::compile_error:
        case Outcome::not_graded: return "";
    }
    return "";
}

HardSet hard_set(const Marking& marking, reference::PixelConvention convention, const PartSet& located) {
    HardSet set{hard_scenes(marking.assignment, convention, located), {}};
    std::vector<reference::Variant> made;
    for (const HardScene& hard : set.scenes) {
        if (hard.scene) made.push_back({hard.name, *hard.scene});
    }
    auto marked = variants::with_keys(made, for_hard_scenes(marking, convention));
    auto next = marked.begin();
    for (HardScene& hard : set.scenes) {
        if (!hard.scene) continue;
        if (*next) {
            set.marked.push_back(std::move(**next));
        } else {
            hard.why_not = "this scene has no certified key";
        }
        ++next;
    }
    return set;
}

class ClassOnHardScenes {
  public:
    ClassOnHardScenes(std::vector<Graded>& graded, const Marking& marking) : graded_(graded), marking_(marking) {}

    const HardSet& set_of(std::size_t index, const PartSet& located) {
        const auto convention = own_convention(graded_[index].score, marking_.key);
        const auto known = sets_.find({convention, located});
        if (known != sets_.end()) return known->second;
        return sets_.emplace(std::pair(convention, located), hard_set(marking_, convention, located)).first->second;
    }

    void conclude(const Rewritten& rewritten) {
        Graded& graded = graded_[rewritten.index];
        HardScenesReport report;
        report.not_found = variants::parts_not_found(marking_.assignment.scene, rewritten.literals.located);
        auto run = rewritten.runs.begin();
        for (const HardScene& hard : set_of(rewritten.index, rewritten.literals.located).scenes) {
            HardResult result{hard.name, std::string(hard.asks), hard.why_not, "", "", {}};
            if (result.skipped.empty()) add_losses(result, *run++, graded, hard.about);
            report.scenes.push_back(std::move(result));
        }
        graded.findings.hard_scenes = std::move(report);
    }

  private:
    void add_losses(HardResult& result, const SceneRun& run, const Graded& base,
                    std::optional<reference::Subject> about) const {
        const Marking& marking = *run.scene->marking;
        result.changes = variants::described(marking.assignment.scene, marking_.assignment.scene);
        result.skipped = variants::why_not_tried(run);
        if (!result.skipped.empty()) return;
        // If a program also ends early on the assignment's scene, the hard scene is not the reason.
        if (base.execution.outcome == Outcome::graded) result.ended = ended_there(run.graded->execution.outcome);
        result.items = that_count(losses(base.score, run.graded->score, marking), about, marking.key);
        result.advice = advice(result.items, marking);
    }

    std::vector<Graded>& graded_;
    const Marking& marking_;
    std::map<std::pair<reference::PixelConvention, PartSet>, HardSet> sets_;
};

}  // namespace

variants::Trial on_hard_scenes(std::vector<Graded>& graded, const Marking& marking) {
    const auto all = std::make_shared<ClassOnHardScenes>(graded, marking);
    const auto scenes_for = [all](std::size_t index, const PartSet& located) -> const auto& {
        return all->set_of(index, located).marked;
    };
    return {scenes_for, [all](const Rewritten& rewritten) { all->conclude(rewritten); }};
}

}  // namespace harness::stress
