#include "harness/stress/run_stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "harness/clean_text.h"
#include "harness/stress/better_formula.h"
#include "harness/stress/hard_scenes.h"
#include "harness/stress/losses.h"
#include "harness/variants/rewritten.h"

namespace harness::stress {
namespace {

using variants::MarkedScene;
using variants::PartSet;
using variants::Rewritten;
using variants::SceneRun;

/// The hard scenes for programs alike: the same parts located, the same place in the pixel.
struct HardSet {
    std::vector<HardScene> scenes;
    std::vector<MarkedScene> marked;  ///< of those that can be had
    std::exception_ptr fault = {};    ///< what kept them from being made, and then there are none
};

/// Held to one reading of the handout, and with the certified allowance alone: a rubric's tolerance is made for its own
/// scene.
Marking for_hard_scenes(const Marking& marking, reference::PixelConvention convention) {
    Marking held = marking;
    held.assignment.rubric.pixel_conventions = {convention};
    held.assignment.rubric.tolerance.reset();
    held.assignment.rubric.item_tolerance.clear();
    return held;
}

/// Empty when it ended by itself.
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
    const Marking held = for_hard_scenes(marking, convention);
    for (HardScene& hard : set.scenes) {
        if (!hard.scene) continue;
        if (auto marked = variants::with_key({hard.name, *hard.scene}, held)) {
            set.marked.push_back(std::move(*marked));
        } else {
            hard.why_not = "there is no certified key of it";
        }
    }
    return set;
}

class StressedClass {
  public:
    StressedClass(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking)
        : graded_(graded), sources_(sources), marking_(marking) {}

    void run(const Workshop& workshop, int jobs, Timeline& timeline) {
        variants::run_rewritten(
            graded_, sources_, marking_.assignment.scene, workshop, jobs, timeline,
            [this](std::size_t index, const PartSet& located) -> const auto& { return set_of(index, located).marked; },
            [this](const Rewritten& one) { conclude(one); });
    }

  private:
    const HardSet& set_of(std::size_t index, const PartSet& located) {
        const auto convention = own_convention(graded_[index].score, marking_.key);
        const auto [place, is_new] = sets_.try_emplace({convention, located.number()});
        HardSet& set = place->second;
        if (!is_new) return set;
        try {
            set = hard_set(marking_, convention, located);
        } catch (const std::exception&) {
            set.fault = std::current_exception();
        }
        return set;
    }

    /// What goes wrong in feedback takes nobody's marks.
    void conclude(const Rewritten& one) {
        Graded& graded = graded_[one.index];
        try {
            graded.hard_scenes = report_of(one, graded);
        } catch (const std::exception& error) {
            graded.our_fault = true;
            graded.submission.notes.push_back(
                fmt::format("It was not run on hard scenes by a fault of raygrade: {}. Please report it.",
                            escape_control(error.what())));
        }
    }

    StressReport report_of(const Rewritten& one, const Graded& graded) {
        const HardSet& set = set_of(one.index, one.literals.located);
        if (set.fault) std::rethrow_exception(set.fault);
        StressReport report;
        report.not_found = variants::parts_not_found(marking_.assignment.scene, one.literals.located);
        auto run = one.runs.begin();
        for (const HardScene& hard : set.scenes) {
            HardResult result;
            result.name = hard.name;
            result.asks = hard.asks;
            result.skipped = hard.why_not;
            if (result.skipped.empty()) tell(result, *run++, graded);
            report.scenes.push_back(std::move(result));
        }
        return report;
    }

    void tell(HardResult& result, const SceneRun& run, const Graded& base) const {
        const Marking& marking = run.scene->marking.get();
        result.changes = variants::described(marking.assignment.scene, marking_.assignment.scene);
        if (!run.graded) {
            result.skipped = "its numbers do not fit where the source has whole ones";
            return;
        }
        const Outcome outcome = run.graded->outcome;
        if (outcome == Outcome::compile_error) result.skipped = "the source does not compile with its numbers";
        if (outcome == Outcome::not_graded) result.skipped = "it could not be run here";
        if (!result.skipped.empty()) return;
        // What ends early on its own scene does so for another reason than that a scene is hard.
        if (base.outcome == Outcome::graded) result.ended = ended_there(outcome);
        result.items = losses(base.score, run.graded->score, marking);
        result.better = better_formulas(result.items, marking);
    }

    std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const Marking& marking_;
    std::map<std::pair<reference::PixelConvention, unsigned long>, HardSet> sets_;
};

}  // namespace

void run_stress(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                const Workshop& workshop, int jobs, Timeline& timeline) {
    StressedClass(graded, sources, marking).run(workshop, jobs, timeline);
}

}  // namespace harness::stress
