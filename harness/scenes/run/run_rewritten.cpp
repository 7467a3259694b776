#include "harness/scenes/run/run_rewritten.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "harness/batch/batch.h"
#include "harness/machine/errors.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "harness/text/escape.h"

namespace harness::scenes {
namespace {

/// A part of a class, whose rewritten sources form one batch.
class RewrittenPart {
  public:
    RewrittenPart(const std::vector<Graded>& graded, const std::vector<std::string>& sources, const DecimalScene& scene)
        : graded_(graded), sources_(sources), scene_(scene) {}

    /// Adds a submission on all its scenes, or nothing if it throws.
    void add(std::size_t index, const ScenesFor& scenes_for) {
        if (!has_right_answer(graded_[index])) return;
        Rewritten one{index, find_scene(sources_[index], scene_), {}};
        std::vector<std::optional<std::string>> written;
        for (const MarkedScene& scene : scenes_for(index, one.literals.located)) {
            one.runs.push_back({&scene, {}});
            written.push_back(with_scene(sources_[index], one.literals, scene.scene.scene));
        }
        for (std::size_t i = 0; i < written.size(); ++i) {
            if (written[i]) add(one, i, std::move(*written[i]));
        }
        rewritten_.push_back(std::move(one));
    }

    std::vector<Rewritten> run(const Runner& runner, int jobs, Timeline& timeline) {
        std::vector<Graded> results = grade_each(std::move(submissions_), markings_, runner, jobs, timeline);
        for (std::size_t i = 0; i < results.size(); ++i)
            rewritten_[places_[i].first].runs[places_[i].second].graded = std::move(results[i]);
        return std::move(rewritten_);
    }

  private:
    void add(const Rewritten& one, std::size_t run, std::string source) {
        const MarkedScene& scene = *one.runs[run].scene;
        Submission submission;
        submission.id = fmt::format("{} ({})", graded_[one.index].submission.id, scene.scene.name);
        submission.file = graded_[one.index].submission.file;
        submission.source = std::move(source);
        submission.rereads = graded_[one.index].submission.rereads;
        submissions_.push_back(std::move(submission));
        markings_.push_back(scene.marking.get());
        places_.emplace_back(rewritten_.size(), run);
    }

    const std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const DecimalScene& scene_;
    std::vector<Rewritten> rewritten_;
    std::vector<Submission> submissions_;
    std::vector<const Marking*> markings_;
    std::vector<std::pair<std::size_t, std::size_t>> places_;  ///< of each submission: in rewritten_, and in its runs
};

void note_fault(Graded& graded, const std::string& what) {
    graded.our_fault = true;
    graded.submission.notes.push_back("Other scenes: " + escape_control(what));
}

/// Calls `work` for these submissions. If it fails, the submissions with a right answer get a note about it.
template <class Work>
void or_noted(std::span<Graded> graded, Work work) {
    const auto note = [&](const auto& of_one) {
        for (Graded& one : graded) {
            if (has_right_answer(one)) of_one(one);
        }
    };
    try {
        work();
    } catch (const HarnessError&) {
        note([](Graded& one) {
            one.submission.notes.emplace_back("It was not run on other scenes: something went wrong here, not in it.");
        });
    } catch (const std::exception& error) {
        note([&](Graded& one) { note_fault(one, fault_sentence(error)); });
    }
}

bool is_our_fault(const SceneRun& run) {
    return run.graded && run.graded->our_fault;
}

}  // namespace

std::optional<MarkedScene> with_key(reference::OtherScene scene, const Marking& base) {
    reference::Assignment assignment = base.assignment;
    assignment.scene = scene.scene;
    assignment.name = fmt::format("{} ({})", assignment.name, scene.name);
    try {
        auto marking = std::make_shared<const Marking>(make_marking(std::move(assignment)));
        return MarkedScene{std::move(scene), std::move(marking)};
    } catch (const reference::AssignmentError&) {
        return {};
    } catch (const std::domain_error&) {
        return {};
    }
}

std::string why_not_tried(const SceneRun& run) {
    if (!run.graded) return "its numbers do not fit where the source has whole ones";
    const Build& build = run.graded->build;
    switch (run.graded->outcome) {
        case Outcome::compile_error:
            return build.reached_limit ? "the compiler was stopped at a limit with its numbers in the source"
                                       : "the source does not compile with its numbers";
        case Outcome::not_graded: return "something went wrong here, not in the program";
        case Outcome::graded:
        case Outcome::crashed:
        case Outcome::timed_out:
        case Outcome::output_limit:
        case Outcome::memory_limit:
        case Outcome::no_output: return "";
    }
    return "";
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

void run_rewritten(std::vector<Graded>& graded, const std::vector<std::string>& sources, const DecimalScene& scene,
                   const Runner& runner, int jobs, Timeline& timeline, const ScenesFor& scenes_for,
                   const std::function<void(Rewritten)>& conclude) {
    // In parts, because the sources of all scenes together would take several times the memory of the class.
    constexpr std::size_t at_a_time = 256;
    for (std::size_t begin = 0; begin < graded.size(); begin += at_a_time) {
        const std::span<Graded> some(graded.begin() + static_cast<std::ptrdiff_t>(begin),
                                     std::min(at_a_time, graded.size() - begin));
        RewrittenPart part(graded, sources, scene);
        for (std::size_t i = 0; i < some.size(); ++i)
            or_noted(some.subspan(i, 1), [&] { part.add(begin + i, scenes_for); });
        std::vector<Rewritten> done;
        or_noted(some, [&] { done = part.run(runner, jobs, timeline); });
        for (Rewritten& one : done) {
            Graded& base = graded[one.index];
            const auto failed = std::find_if(one.runs.begin(), one.runs.end(), is_our_fault);
            if (failed != one.runs.end()) note_fault(base, failed->graded->explanation);
            or_noted({&base, 1}, [&] { conclude(std::move(one)); });
        }
    }
}

std::string described(const DecimalScene& scene, const DecimalScene& other) {
    std::string text;
    for (const ScenePart part : all_parts) {
        if (!has_part(scene, part) || value_of(scene, part) == value_of(other, part)) continue;
        text += (text.empty() ? "" : ", ") + describe(scene, part);
    }
    return text;
}

std::vector<std::string> parts_not_found(const DecimalScene& scene, const PartSet& located) {
    std::vector<std::string> names;
    for (const ScenePart part : all_parts) {
        if (has_part(scene, part) && !located.contains(part)) names.emplace_back(to_string(part));
    }
    return names;
}

}  // namespace harness::scenes
