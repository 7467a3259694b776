#include "harness/variants/run_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <map>
#include <optional>

#include "harness/batch.h"
#include "harness/variants/generate_variants.h"
#include "harness/variants/scene_literals.h"
#include "harness/variants/variant_sentences.h"
#include "harness/variants/written_answers.h"

namespace harness::variants {
namespace {

/// A scene with its key, for all submissions in which the same parts were located.
struct MarkedVariant {
    reference::SceneVariant variant;
    std::shared_future<Marking> marking;
};

/// Empty when there is no certified key, such as for a rubric whose tolerance is too narrow for this scene.
std::optional<MarkedVariant> with_key(reference::SceneVariant variant, const Marking& base) {
    reference::Assignment assignment = base.assignment;
    assignment.scene = variant.scene;
    assignment.name = fmt::format("{} ({})", assignment.name, variant.name);
    try {
        reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
        std::promise<Marking> made;
        made.set_value(Marking{std::move(assignment), std::move(key)});
        return MarkedVariant{std::move(variant), made.get_future().share()};
    } catch (const reference::AssignmentError&) {
        return {};
    } catch (const std::domain_error&) {
        return {};
    }
}

bool has_right_answer(const Graded& graded) {
    if (graded.outcome == Outcome::not_graded || graded.outcome == Outcome::compile_error) return false;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::right && !item.printed.empty()) return true;
        }
    }
    return false;
}

/// The parts that differ between two scenes, in words.
std::string described(const DecimalScene& scene, const DecimalScene& other) {
    std::string text;
    for (const ScenePart part : all_parts) {
        if (!has_part(scene, part) || value_of(scene, part) == value_of(other, part)) continue;
        text += (text.empty() ? "" : ", ") + describe(scene, part);
    }
    return text;
}

bool ended_well(const Graded& graded) {
    return graded.outcome == Outcome::graded;
}

class VariantClass {
  public:
    VariantClass(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                 const VariantOptions& options)
        : graded_(graded), sources_(sources), marking_(marking), options_(options) {}

    void run(const Workshop& workshop, int jobs, Timeline& timeline) {
        // A few at a time: the sources of all scenes together would take several times a class's memory.
        constexpr std::size_t at_a_time = 256;
        for (std::size_t begin = 0; begin < graded_.size(); begin += at_a_time)
            run_some(begin, std::min(begin + at_a_time, graded_.size()), workshop, jobs, timeline);
    }

  private:
    /// A source with another scene in it.
    struct Job {
        std::size_t index;  ///< of the submission
        const MarkedVariant* variant;
    };

    void run_some(std::size_t begin, std::size_t end, const Workshop& workshop, int jobs, Timeline& timeline) {
        std::vector<Job> tried;
        std::vector<Submission> submissions;
        std::vector<std::shared_future<Marking>> markings;
        std::map<std::size_t, SceneLiterals> found;
        for (std::size_t i = begin; i < end; ++i) {
            if (!has_right_answer(graded_[i])) continue;
            const SceneLiterals& literals = found[i] = find_scene(sources_[i], marking_.assignment.scene);
            for (const MarkedVariant& variant : variants_of(literals.located)) {
                auto source = with_scene(sources_[i], literals, variant.variant.scene);
                if (!source) continue;
                Submission submission;
                submission.id = fmt::format("{} ({})", graded_[i].submission.id, variant.variant.name);
                submission.file = graded_[i].submission.file;
                submission.source = std::move(*source);
                submissions.push_back(std::move(submission));
                markings.push_back(variant.marking);
                tried.push_back({i, &variant});
            }
        }
        std::vector<Graded> results = grade_each(std::move(submissions), std::move(markings), workshop, jobs, timeline);
        std::map<std::size_t, std::vector<VariantRun>> runs;
        for (std::size_t k = 0; k < tried.size(); ++k) {
            if (auto run = run_of(tried[k], results[k])) runs[tried[k].index].push_back(std::move(*run));
        }
        for (auto& [index, literals] : found) conclude(index, literals, std::move(runs[index]));
    }

    const std::vector<MarkedVariant>& variants_of(const PartSet& located) {
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
    std::optional<VariantRun> run_of(const Job& job, Graded& result) const {
        if (result.outcome == Outcome::not_graded || result.outcome == Outcome::compile_error) return {};
        const DecimalScene& base = marking_.assignment.scene;
        const DecimalScene& scene = job.variant->variant.scene;
        return VariantRun{job.variant->variant.name, described(scene, base), described(base, scene), ended_well(result),
                          std::move(result.score)};
    }

    void conclude(std::size_t index, const SceneLiterals& literals, std::vector<VariantRun> runs) {
        Graded& graded = graded_[index];
        const DecimalScene& scene = marking_.assignment.scene;
        std::vector<std::string> not_found;
        for (const ScenePart part : all_parts) {
            if (has_part(scene, part) && !literals.located.contains(part)) not_found.emplace_back(to_string(part));
        }
        const bool nothing_tried = runs.empty();
        graded.other_scenes = compare(graded.score, std::move(runs), std::move(not_found));
        if (graded.other_scenes->verdict == VariantVerdict::does_not_move) {
            graded.flags.push_back({"hard_coded", unmoved_evidence(*graded.other_scenes)});
        } else if (nothing_tried) {
            constexpr std::size_t fewest = 3;  // one or two may be a coincidence
            const auto written = written_answers(sources_[index], graded.score, scene);
            if (written.size() >= fewest) graded.flags.push_back({"hard_coded", written_evidence(written)});
        }
    }

    std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const Marking& marking_;
    const VariantOptions& options_;
    std::map<unsigned long, std::vector<MarkedVariant>> variants_;  ///< by what was located
};

}  // namespace

void run_variants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                  const Workshop& workshop, int jobs, const VariantOptions& options, Timeline& timeline) {
    if (options.count > 0) VariantClass(graded, sources, marking, options).run(workshop, jobs, timeline);
}

}  // namespace harness::variants
