#include "harness/variants/run_variants.h"

#include <map>

#include "harness/variants/generate_variants.h"
#include "harness/variants/rewritten.h"
#include "harness/variants/variant_sentences.h"
#include "harness/variants/written_answers.h"

namespace harness::variants {
namespace {

class VariantClass {
  public:
    VariantClass(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                 const VariantOptions& options)
        : graded_(graded), sources_(sources), marking_(marking), options_(options) {}

    void run(const Workshop& workshop, int jobs, Timeline& timeline) {
        run_rewritten(
            graded_, sources_, marking_.assignment.scene, workshop, jobs, timeline,
            [this](std::size_t /*index*/, const PartSet& located) -> const auto& { return variants_of(located); },
            [this](Rewritten one) { conclude(std::move(one)); });
    }

  private:
    const std::vector<MarkedScene>& variants_of(const PartSet& located) {
        const auto [place, is_new] = variants_.try_emplace(located.number());
        if (is_new) {
            for (auto& variant : variants_for(marking_.assignment, located, options_.count, options_.seed)) {
                if (auto marked = with_key(std::move(variant), marking_)) place->second.push_back(std::move(*marked));
            }
        }
        return place->second;
    }

    /// None where the program could not be tried: the machine failed, or the number does not fit the place where the
    /// source has it.
    std::optional<VariantRun> run_of(SceneRun& run) const {
        if (!run.graded) return {};
        const Outcome outcome = run.graded->outcome;
        if (outcome == Outcome::not_graded || outcome == Outcome::compile_error) return {};
        const DecimalScene& base = marking_.assignment.scene;
        const reference::SceneVariant& scene = run.scene->scene;
        return VariantRun{scene.name, described(scene.scene, base), described(base, scene.scene),
                          outcome == Outcome::graded, std::move(run.graded->score)};
    }

    void conclude(Rewritten one) {
        Graded& graded = graded_[one.index];
        const DecimalScene& scene = marking_.assignment.scene;
        std::vector<VariantRun> runs;
        for (SceneRun& each : one.runs) {
            if (auto run = run_of(each)) runs.push_back(std::move(*run));
        }
        const bool nothing_tried = runs.empty();
        graded.other_scenes = compare(graded.score, std::move(runs), parts_not_found(scene, one.literals.located));
        if (graded.other_scenes->verdict == VariantVerdict::does_not_move) {
            graded.flags.push_back({"hard_coded", unmoved_evidence(*graded.other_scenes)});
        } else if (nothing_tried) {
            constexpr std::size_t fewest = 3;  // one or two may be a coincidence
            const auto written = written_answers(sources_[one.index], graded.score, scene);
            if (written.size() >= fewest) graded.flags.push_back({"hard_coded", written_evidence(written)});
        }
    }

    std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const Marking& marking_;
    const VariantOptions& options_;
    std::map<unsigned long, std::vector<MarkedScene>> variants_;  ///< by what was located
};

}  // namespace

void run_variants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                  const Workshop& workshop, int jobs, const VariantOptions& options, Timeline& timeline) {
    if (options.count > 0) VariantClass(graded, sources, marking, options).run(workshop, jobs, timeline);
}

}  // namespace harness::variants
