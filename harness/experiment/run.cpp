#include "harness/experiment/run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "harness/experiment/identify/identify.h"
#include "harness/grade/grade_submission.h"
#include "harness/grade/reread.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/match/match.h"
#include "harness/variants/generate.h"

namespace harness::experiment {
namespace {

using variants::MarkedScene;
using variants::Rewritten;
using variants::SceneRun;

bool has_doubt(const Graded& graded) {
    bool doubtful = false;
    for_each_item(graded.score, [&](const ItemScore& item) { doubtful = doubtful || may_be_settled(item); });
    return doubtful;
}

/// Whether the answer is wrong by a named mistake that other scenes can confirm.
bool is_named(const ItemScore& item) {
    return item.verdict == ItemVerdict::wrong && !item.mistakes.empty() && !item.credit &&
           item.spec.shape != reference::Shape::first_object;
}

/// Whether a named mistake may explain an answer by chance. One that explains two answers does not.
bool has_chance_mistake(const Score& score) {
    std::map<std::string_view, int> answers;  // by the name of the only mistake that explains them
    std::vector<std::string_view> by_chance;
    for_each_item(score, [&](const ItemScore& item) {
        if (!is_named(item)) return;
        if (item.mistakes.size() == 1) ++answers[item.diagnosis];
        if (item.may_be_chance) by_chance.push_back(item.diagnosis);
    });
    return std::ranges::any_of(by_chance, [&](std::string_view name) { return answers[name] < 2; });
}

/// The mistakes of each named item that also explain its answer on the other scenes.
std::vector<MistakeOnScenes> mistakes_on_scenes(const Score& score, const std::vector<SceneRun>& runs) {
    std::vector<MistakeOnScenes> mistakes;
    for_each_item(score, [&](const ItemScore& item) {
        if (!is_named(item)) return;
        std::vector<std::pair<std::string, std::string>> told;
        bool was_read = false, was_wrong = false;
        for (const SceneRun& run : runs) {
            if (!run.graded) continue;
            for_each_item(run.graded->score, [&](const ItemScore& there) {
                if (there.spec.id != item.spec.id || there.printed.empty()) return;
                was_read = true;
                was_wrong = was_wrong || there.verdict == ItemVerdict::wrong;
                for (const auto& mistake : item.mistakes) {
                    if (std::ranges::count(there.mistakes, mistake) > std::ranges::count(told, mistake))
                        told.push_back(mistake);
                }
            });
        }
        // A wrong root may be right on other scenes. Any other answer that is right on the other scenes comes from a
        // wrong number of this scene.
        if (!was_read || (!was_wrong && item.spec.id.name == "t")) return;
        const auto [diagnosis, advice] = in_words(told);
        mistakes.push_back({item.spec.question, std::string(item.spec.name), diagnosis, advice});
    });
    return mistakes;
}

class ClassInDoubt {
  public:
    ClassInDoubt(std::vector<Graded>& graded, const Marking& marking) : graded_(graded), marking_(marking) {}

    const std::vector<MarkedScene>& scenes_for(std::size_t index, const source::PartSet& located) {
        static const std::vector<MarkedScene> none;
        // Its copy would reach the limit too, in each of three runs.
        if (graded_[index].execution.outcome == Outcome::timed_out) return none;
        const Marking& own = own_marking(marking_, graded_[index].submission);
        const auto [known, is_new] = scenes_.try_emplace({&own, located});
        if (is_new) {
            const auto scenes = variants::scenes_with_all_hit(own.assignment, located, scenes_tried);
            for (auto& marked : variants::with_keys(scenes, own)) {
                if (marked) known->second.push_back(std::move(*marked));
            }
        }
        return known->second;
    }

    void conclude(const Rewritten& rewritten) {
        Graded& graded = graded_[rewritten.index];
        const Marking& marking = own_marking(marking_, graded.submission);
        std::vector<Observation> observations;
        std::string_view why = graded.execution.outcome == Outcome::timed_out
                                   ? "the program was stopped at its time limit"
                                   : "the scene was not found in the source, so the program can't run on another one";
        for (const SceneRun& run : rewritten.runs) {
            if (!variants::why_not_tried(run).empty()) continue;
            why = "the program ended differently on other scenes";
            if (!ended_alike(*run.graded, graded)) continue;
            const Marking& there = *run.scene->marking;
            observations.push_back({read_transcript(run.graded->execution.printout, last_question(graded.score)),
                                    there.key, there.assignment});
        }
        graded.findings.experiment.emplace();
        if (has_doubt(graded) && observations.empty()) graded.findings.experiment->unsettled = why;
        if (has_doubt(graded) && !observations.empty()) settle(graded, marking, observations);
        std::vector<MistakeOnScenes>& mistakes = graded.findings.experiment->mistakes;
        if (mistakes.empty()) mistakes = mistakes_on_scenes(graded.score, rewritten.runs);
        mark_again(graded, marking_);
    }

  private:
    static bool ended_alike(const Graded& there, const Graded& graded) {
        const ProcessResult &run = there.execution.run, &own = graded.execution.run;
        return there.execution.outcome == graded.execution.outcome && run.ended == own.ended &&
               run.signal == own.signal && run.exit_code == own.exit_code && !there.execution.printout.empty();
    }

    void settle(Graded& graded, const Marking& marking, const std::vector<Observation>& observations) const {
        const std::string& printout = graded.execution.printout;
        const Transcript transcript = read_transcript(printout, last_question(graded.score));
        const auto items = asked_items(graded.score);
        const std::vector<MatchedItem> matched =
            match(transcript, items, places_in(graded.submission.rereads, printout));
        graded.findings.experiment = identify({transcript, matched, graded.score}, observations);
        drop_losses(graded, marking, transcript);
    }

    /// Undoes the experiment if an item would lose points by it.
    static void drop_losses(Graded& graded, const Marking& marking, const Transcript& transcript) {
        ExperimentReport& report = *graded.findings.experiment;
        const Score score =
            harness::score(transcript, marking.key, marking.assignment, places_of(graded, graded.execution.printout));
        constexpr double rounding = 1e-9;
        std::map<reference::ItemId, double> before;
        for_each_item(graded.score, [&](const ItemScore& item) { before[item.spec.id] = item.points; });
        bool loses = false;
        for_each_item(score,
                      [&](const ItemScore& item) { loses = loses || item.points < before[item.spec.id] - rounding; });
        if (!loses) return;
        report = {};
        report.unsettled = "the runs on other scenes would cost points";
    }

    std::vector<Graded>& graded_;
    const Marking& marking_;
    std::map<std::pair<const Marking*, source::PartSet>, std::vector<MarkedScene>> scenes_;
};

}  // namespace

bool is_doubtful(const Graded& graded) {
    if (graded.execution.printout.empty() || graded.submission.source.empty()) return false;
    return has_doubt(graded) || has_chance_mistake(graded.score);
}

variants::Trial on_doubts(std::vector<Graded>& graded, const Marking& marking) {
    const auto all = std::make_shared<ClassInDoubt>(graded, marking);
    const auto scenes_for = [all](std::size_t index, const source::PartSet& located) -> const auto& {
        return all->scenes_for(index, located);
    };
    return {scenes_for, [all](const Rewritten& rewritten) { all->conclude(rewritten); }, is_doubtful};
}

std::vector<std::string> doubtful_sources(const std::vector<Graded>& graded) {
    std::vector<std::string> sources;
    for (const Graded& result : graded)
        sources.push_back(is_doubtful(result) ? result.submission.source : std::string());
    return sources;
}

void settle_doubts(std::vector<Graded>& graded, const Marking& marking, const Runner& runner, int jobs,
                   Timeline& timeline) {
    if (std::ranges::none_of(graded, is_doubtful)) return;
    variants::run_rewritten(graded, doubtful_sources(graded), marking, runner, jobs, timeline,
                            {on_doubts(graded, marking)});
}

}  // namespace harness::experiment
