#include "harness/stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "harness/machine/errors.h"
#include "harness/stress/generate.h"
#include "harness/stress/losses.h"
#include "harness/text/escape.h"

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
    std::exception_ptr fault = {};    ///< why the scenes could not be made; then there are none
};

/// The marking for hard scenes: it accepts one pixel convention, and only the certified allowance, because a rubric's
/// tolerance is made for its own scene.
Marking for_hard_scenes(const Marking& marking, reference::PixelConvention convention) {
    Marking held = marking;
    held.assignment.rubric.pixel_conventions = {convention};
    held.assignment.rubric.tolerance.reset();
    held.assignment.rubric.item_tolerance.clear();
    return held;
}

/// How the program ended on the scene; empty if it ended by itself.
std::string_view ended_there(Outcome outcome) {
    switch (outcome) {
        case Outcome::crashed: return "The program crashed there.";
        case Outcome::timed_out: return "The program was stopped at its time limit there.";
        case Outcome::output_limit: return "The program printed too much there.";
        case Outcome::memory_limit: return "The program used too much memory there.";
        case Outcome::no_output: return "The program printed nothing there.";
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
            hard.why_not = "there is no certified key of it";
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
        const auto [place, is_new] = sets_.try_emplace({convention, located});
        HardSet& set = place->second;
        if (!is_new) return set;
        try {
            set = hard_set(marking_, convention, located);
        } catch (const std::exception&) {
            set.fault = std::current_exception();
        }
        return set;
    }

    /// A failure here concerns only feedback and changes no marks.
    void conclude(const Rewritten& one) {
        Graded& graded = graded_[one.index];
        try {
            graded.findings.hard_scenes = report_of(one, graded);
        } catch (const std::exception& error) {
            if (is_for_want_of_memory(error)) {
                graded.submission.notes.emplace_back(
                    "It was not run on hard scenes: this machine gave too little memory.");
                return;
            }
            graded.execution.our_fault = true;
            graded.submission.notes.push_back(
                fmt::format("It was not run on hard scenes by a fault of raygrade: {}. Please report it.",
                            escape_control(error.what())));
        }
    }

  private:
    HardScenesReport report_of(const Rewritten& one, const Graded& graded) {
        const HardSet& set = set_of(one.index, one.literals.located);
        if (set.fault) std::rethrow_exception(set.fault);
        HardScenesReport report;
        report.not_found = variants::parts_not_found(marking_.assignment.scene, one.literals.located);
        auto run = one.runs.begin();
        for (const HardScene& hard : set.scenes) {
            HardResult result{hard.name, std::string(hard.asks), hard.why_not, "", "", {}};
            if (result.skipped.empty()) tell(result, *run++, graded, hard.about);
            report.scenes.push_back(std::move(result));
        }
        return report;
    }

    void tell(HardResult& result, const SceneRun& run, const Graded& base,
              std::optional<reference::Subject> about) const {
        const Marking& marking = *run.scene->marking;
        result.changes = variants::described(marking.assignment.scene, marking_.assignment.scene);
        if (!run.graded) {
            result.skipped = "its numbers do not fit where the source has whole ones";
            return;
        }
        const Outcome outcome = run.graded->execution.outcome;
        if (outcome == Outcome::compile_error) result.skipped = "the source does not compile with its numbers";
        if (outcome == Outcome::not_graded) result.skipped = "it could not be run here";
        if (!result.skipped.empty()) return;
        // A program that ends early also on the assignment's scene does not do so because the scene is hard.
        if (base.execution.outcome == Outcome::graded) result.ended = ended_there(outcome);
        result.items = that_count(losses(base.score, run.graded->score, marking), about, marking.key);
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
    return {scenes_for, [all](const Rewritten& one) { all->conclude(one); }};
}

}  // namespace harness::stress
