#include "harness/variants/run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "harness/grade/grade_submission.h"
#include "harness/grade/reread.h"
#include "harness/grade/written_answers.h"
#include "harness/record/variants_sentences.h"
#include "harness/variants/compare.h"
#include "harness/variants/generate.h"

namespace harness::variants {
namespace {

/// The other scenes for all programs with the same located parts.
struct SceneSet {
    std::vector<MarkedScene> marked;
    std::vector<UntriedVariant>
        not_had;  ///< scenes that cannot be tried; together with `marked`, all that were requested
};

class ClassOnVariants {
  public:
    ClassOnVariants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                    const VariantsOptions& options)
        : graded_(graded), sources_(sources), marking_(marking), options_(options) {}

    const std::vector<MarkedScene>& scenes_for(const source::PartSet& located) { return set_of(located).marked; }

    void conclude(Rewritten rewritten) {
        Graded& graded = graded_[rewritten.index];
        const source::DecimalScene& scene = marking_.assignment.scene;
        std::vector<VariantRun> runs;
        std::vector<UntriedVariant> not_tried = set_of(rewritten.literals.located).not_had;
        for (SceneRun& run : rewritten.runs) {
            std::string why = why_not_tried(run);
            if (why.empty()) {
                read_as_shown(graded, run);
                runs.push_back(run_of(run));
            } else {
                const reference::Variant& other = run.scene->scene;
                not_tried.push_back({other.name, described(other.scene, scene), std::move(why)});
            }
        }
        const bool nothing_tried = runs.empty();
        graded.findings.variants = compare(graded.score, std::move(runs), std::move(not_tried),
                                           parts_not_found(scene, rewritten.literals.located));
        graded.findings.variants->seed = options_.seed;
        const auto is_hard_coded = [](const Flag& flag) { return flag.kind == "hard_coded"; };
        if (!nothing_tried)
            std::erase_if(graded.findings.flags,
                          is_hard_coded);  // running the program is better evidence than its source
        if (graded.findings.variants->verdict == VariantsVerdict::does_not_move) {
            graded.findings.flags.push_back({"hard_coded", unmoved_evidence(*graded.findings.variants)});
        } else if (nothing_tried &&
                   std::none_of(graded.findings.flags.begin(), graded.findings.flags.end(), is_hard_coded)) {
            const auto written = written_answers(sources_[rewritten.index], graded.score, scene);
            if (written.size() >= fewest_written)
                graded.findings.flags.push_back({"hard_coded", written_evidence(written)});
        }
    }

  private:
    const SceneSet& set_of(const source::PartSet& located) {
        const auto known = sets_.find(located);
        return known != sets_.end() ? known->second : sets_.emplace(located, new_set(located)).first->second;
    }

    SceneSet new_set(const source::PartSet& located) const {
        const auto asked = static_cast<std::size_t>(options_.count);
        SceneSet set;
        const auto others = variants_for(marking_.assignment, located, options_.count, options_.seed);
        auto marked = with_keys(others, marking_);
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (marked[i]) {
                set.marked.push_back(std::move(*marked[i]));
            } else {
                set.not_had.push_back({others[i].name, described(others[i].scene, marking_.assignment.scene),
                                       "this scene has no certified key"});
            }
        }
        const char* why = located.empty() ? "the scene was not found in its source"
                                          : "the parts of the scene found in its source allow no other scene";
        while (set.marked.size() + set.not_had.size() < asked) set.not_had.push_back({"", "", why});
        return set;
    }

    /// Reads the run's answers from the places that an experiment found in the submission's output, if this output has
    /// the same lines.
    void read_as_shown(const Graded& graded, SceneRun& run) const {
        if (!graded.findings.experiment) return;
        if (layout_of(run.graded->execution.printout) != layout_of(graded.execution.printout)) return;
        run.graded->findings.experiment = graded.findings.experiment;
        mark_again(*run.graded, *run.scene->marking);
    }

    VariantRun run_of(SceneRun& run) const {
        const source::DecimalScene& base = marking_.assignment.scene;
        const reference::Variant& scene = run.scene->scene;
        return {scene.name, described(scene.scene, base), described(base, scene.scene),
                run.graded->execution.outcome == Outcome::graded, std::move(run.graded->score)};
    }

    std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const Marking& marking_;
    const VariantsOptions& options_;
    std::map<source::PartSet, SceneSet> sets_;  ///< by the located parts
};

}  // namespace

Trial on_variants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                  const VariantsOptions& options) {
    const auto all = std::make_shared<ClassOnVariants>(graded, sources, marking, options);
    const auto scenes_for = [all](std::size_t /*index*/, const source::PartSet& located) -> const auto& {
        return all->scenes_for(located);
    };
    return {scenes_for, [all](Rewritten rewritten) { all->conclude(std::move(rewritten)); }};
}

}  // namespace harness::variants
