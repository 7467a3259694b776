#include "harness/variants/rewritten/run_rewritten.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "harness/grade/batch.h"
#include "harness/machine/errors.h"
#include "harness/machine/on_all_cores.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "harness/source/scene/part_name.h"
#include "harness/text/escape.h"
#include "harness/variants/rewritten/scene_table.h"
#include "reference/toml/assignment_error.h"

namespace harness::variants {
namespace {

/// A part of a class that is run together.
class RewrittenPart {
  public:
    RewrittenPart(const std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking)
        : graded_(graded), sources_(sources), marking_(marking) {}

    /// Adds a submission on all scenes of a trial, or nothing if it throws.
    void add(std::size_t index, const Trial& trial) {
        if (!trial.concerns(graded_[index])) return;
        Rewritten rewritten{index, source::find_scene(sources_[index], own_scene(index)), {}};
        std::vector<std::optional<std::string>> written;
        for (const MarkedScene& scene : trial.scenes_for(index, rewritten.literals.located)) {
            rewritten.runs.push_back({&scene, {}});
            written.push_back(source::with_scene(sources_[index], rewritten.literals, scene.scene.scene));
        }
        for (std::size_t i = 0; i < written.size(); ++i) {
            if (written[i]) sources_on_scenes_.push_back({index, rewritten_.size(), i, std::move(*written[i])});
        }
        rewritten_.push_back(std::move(rewritten));
        trials_.push_back(&trial);
    }

    void run(const Runner& runner, int jobs, Timeline& timeline) {
        compile_once(runner, jobs, timeline);
        compile_for_each(runner, jobs, timeline);
    }

    /// Calls `one(trial, rewritten)` for everything that was added, in that order.
    template <class One>
    void conclude(One one) {
        for (std::size_t i = 0; i < rewritten_.size(); ++i) one(*trials_[i], std::move(rewritten_[i]));
    }

  private:
    /// A source that states a scene.
    struct OnScene {
        std::size_t index;      ///< of the submission in the class
        std::size_t rewritten;  ///< its place in rewritten_
        std::size_t run;        ///< and in the runs there
        std::string source;
    };

    /// The assignment's scene for this submission.
    const source::DecimalScene& own_scene(std::size_t index) const {
        return own_marking(marking_, graded_[index].submission).assignment.scene;
    }

    SceneRun& run_of(const OnScene& on_scene) { return rewritten_[on_scene.rewritten].runs[on_scene.run]; }
    bool is_done(const OnScene& on_scene) { return run_of(on_scene).graded.has_value(); }

    Submission submission_of(const OnScene& on_scene) {
        const Submission& base = graded_[on_scene.index].submission;
        Submission submission;
        submission.id = fmt::format("{} ({})", base.id, run_of(on_scene).scene->scene.name);
        submission.file = base.file;
        submission.source = on_scene.source;
        submission.rereads = base.rereads;
        submission.may_set_own_scene = graded_[on_scene.index].findings.own_scene.has_value();
        return submission;
    }

    /// The copy that reads its scene from a table, with the tables of the assignment's scene and of all `scenes`.
    std::optional<Submission> copy_for(std::span<const OnScene> scenes) {
        constexpr std::size_t worth_it = 2;  // because the copy also runs on the assignment's scene
        const OnScene& first = scenes.front();
        const source::SceneLiterals& literals = rewritten_[first.rewritten].literals;
        auto source = with_table(sources_[first.index], literals);
        auto own_table = table_of(literals, own_scene(first.index));
        if (scenes.size() < worth_it || !source || !own_table) return {};
        Submission copy;
        copy.id = graded_[first.index].submission.id + " (any scene)";
        copy.source = std::move(*source);
        copy.inputs.push_back(std::move(*own_table));
        for (const OnScene& on_scene : scenes) {
            auto table = table_of(literals, run_of(on_scene).scene->scene.scene);
            if (!table) return {};
            copy.inputs.push_back(std::move(*table));
        }
        return copy;
    }

    void compile_once(const Runner& runner, int jobs, Timeline& timeline) {
        std::vector<Submission> copies;
        std::vector<std::span<const OnScene>> scenes_of;
        const std::span<const OnScene> all = sources_on_scenes_;
        for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
            while (end < all.size() && all[end].index == all[begin].index) ++end;
            auto copy = copy_for(all.subspan(begin, end - begin));
            if (!copy) continue;
            copies.push_back(std::move(*copy));
            scenes_of.push_back(all.subspan(begin, end - begin));
        }
        run_each(std::move(copies), runner, jobs, timeline,
                 [&](std::size_t copy, const Submission&, const std::function<Executions()>& run_copy) {
                     try {
                         take(run_copy(), scenes_of[copy], runner, timeline);
                     } catch (const std::exception&) {
                         return;  // a failure is reported again when each scene is compiled
                     }
                 });
    }

    /// Uses the copy's runs if the copy did exactly the same as the submission on the assignment's scene.
    void take(Executions copy, std::span<const OnScene> scenes, const Runner& runner, Timeline& timeline) {
        if (!does_the_same(copy.runs.front(), graded_[scenes.front().index])) return;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            SceneRun& run = run_of(scenes[i]);
            Executions executions;
            executions.runs.push_back(std::move(copy.runs[i + 1]));
            const Submission submission = submission_of(scenes[i]);
            const Marking& marking = *run.scene->marking;
            run.graded = graded_or_not(submission, marking, runner, [&] {
                return mark(submission, executions, marking, runner, run.scene->memo.get(), timeline);
            });
        }
        count_ways(copy, scenes.size(), timeline);
        timeline.finished += scenes.size();
    }

    static bool does_the_same(const Execution& copy, const Graded& graded) {
        const ProcessResult& run = copy.run;
        const bool is_kept = !graded.execution.printout.empty();  // a long output is not kept, so it cannot be compared
        return is_kept && run.output == graded.execution.printout && run.ended == graded.execution.run.ended &&
               run.signal == graded.execution.run.signal && run.exit_code == graded.execution.run.exit_code;
    }

    void compile_for_each(const Runner& runner, int jobs, Timeline& timeline) {
        std::vector<Submission> submissions;
        std::vector<const Marking*> markings;
        std::vector<SceneRun*> runs;
        for (const OnScene& on_scene : sources_on_scenes_) {
            if (is_done(on_scene)) continue;
            submissions.push_back(submission_of(on_scene));
            markings.push_back(run_of(on_scene).scene->marking.get());
            runs.push_back(&run_of(on_scene));
        }
        std::vector<Graded> results = grade_each(std::move(submissions), markings, runner, jobs, timeline);
        for (std::size_t i = 0; i < results.size(); ++i) runs[i]->graded = std::move(results[i]);
    }

    const std::vector<Graded>& graded_;
    const std::vector<std::string>& sources_;
    const Marking& marking_;
    std::vector<Rewritten> rewritten_;
    std::vector<const Trial*> trials_;        ///< of each in rewritten_
    std::vector<OnScene> sources_on_scenes_;  ///< those of a submission are consecutive
};

void note_fault(Graded& graded, const std::string& what) {
    graded.execution.our_fault = true;
    graded.submission.notes.push_back("Other scenes: " + escape_control(what));
}

void note_machine(Graded& graded) {
    graded.submission.notes.emplace_back(
        "It was not run on other scenes because raygrade failed. This is not the program's fault.");
}

/// Calls `work` for these submissions. If it fails, the affected submissions get a note about it.
template <class Work>
void or_noted(std::span<Graded> graded, const std::vector<Trial>& trials, Work work) {
    const auto note = [&](const auto& of_one) {
        for (Graded& result : graded) {
            if (std::ranges::any_of(trials, [&](const Trial& trial) { return trial.concerns(result); })) of_one(result);
        }
    };
    try {
        work();
    } catch (const HarnessError&) {
        note(note_machine);
    } catch (const std::exception& error) {
        if (is_for_want_of_memory(error)) {
            note(note_machine);
        } else {
            note([&](Graded& one) { note_fault(one, fault_sentence(error)); });
        }
    }
}

bool is_our_fault(const SceneRun& run) {
    return run.graded && run.graded->execution.our_fault;
}

/// Empty if the scene has no certified key.
std::optional<MarkedScene> with_key(reference::Variant scene, const Marking& base) {
    reference::Assignment assignment = base.assignment;
    assignment.scene = scene.scene;
    assignment.name = fmt::format("{} ({})", assignment.name, scene.name);
    try {
        auto marking = std::make_shared<const Marking>(make_marking(std::move(assignment)));
        return MarkedScene{std::move(scene), std::move(marking), std::make_shared<SceneMemo>()};
    } catch (const reference::AssignmentError&) {
        return {};
    } catch (const std::domain_error&) {
        return {};
    }
}

}  // namespace

std::vector<std::optional<MarkedScene>> with_keys(const std::vector<reference::Variant>& scenes, const Marking& base) {
    std::vector<std::optional<MarkedScene>> marked(scenes.size());
    on_all_cores(scenes.size(), [&](std::size_t i) { marked[i] = with_key(scenes[i], base); });
    return marked;
}

std::string why_not_tried(const SceneRun& run) {
    if (!run.graded) return "its numbers are not whole, but the source needs whole numbers";
    const Build& build = run.graded->execution.build;
    switch (run.graded->execution.outcome) {
        case Outcome::compile_error:
            return build.reached_limit ? "the compiler hit a limit with its numbers"
                                       : "the source does not compile with its numbers";
        case Outcome::not_graded: return "raygrade failed, not the program";
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
    if (graded.execution.outcome == Outcome::not_graded || graded.execution.outcome == Outcome::compile_error)
        return false;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::right && !item.printed.empty()) return true;
        }
    }
    return false;
}

void run_rewritten(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                   const Runner& runner, int jobs, Timeline& timeline, const std::vector<Trial>& trials) {
    // In parts, because the sources of all scenes together would take several times the memory of the class.
    constexpr std::size_t at_a_time = 256;
    for (std::size_t begin = 0; begin < graded.size(); begin += at_a_time) {
        const std::span<Graded> some(graded.begin() + static_cast<std::ptrdiff_t>(begin),
                                     std::min(at_a_time, graded.size() - begin));
        RewrittenPart part(graded, sources, marking);
        for (std::size_t i = 0; i < some.size(); ++i) {
            for (const Trial& trial : trials) or_noted(some.subspan(i, 1), trials, [&] { part.add(begin + i, trial); });
        }
        bool is_run = false;
        or_noted(some, trials, [&] {
            part.run(runner, jobs, timeline);
            is_run = true;
        });
        if (!is_run) continue;
        part.conclude([&](const Trial& trial, Rewritten rewritten) {
            Graded& base = graded[rewritten.index];
            const auto failed = std::find_if(rewritten.runs.begin(), rewritten.runs.end(), is_our_fault);
            if (failed != rewritten.runs.end()) note_fault(base, failed->graded->execution.explanation);
            or_noted({&base, 1}, trials, [&] { trial.conclude(std::move(rewritten)); });
        });
    }
}

std::string described(const source::DecimalScene& scene, const source::DecimalScene& other) {
    std::string text;
    for (const source::ScenePart part : source::all_parts()) {
        if (!source::has_part(scene, part) || source::value_of(scene, part) == source::value_of(other, part)) continue;
        text += (text.empty() ? "" : ", ") + source::describe(scene, part);
    }
    return text;
}

std::vector<std::string> parts_not_found(const source::DecimalScene& scene, const source::PartSet& located) {
    std::vector<std::string> names;
    for (const source::ScenePart part : source::all_parts()) {
        if (source::has_part(scene, part) && !located.contains(part)) names.emplace_back(to_string(part));
    }
    return names;
}

}  // namespace harness::variants
