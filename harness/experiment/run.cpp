#include "harness/experiment/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "harness/experiment/identify/identify.h"
#include "harness/grade/grade_submission.h"
#include "harness/grade/reread.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/match/match.h"
#include "harness/text/listed.h"
#include "harness/variants/generate.h"

namespace harness::experiment {
namespace {

using variants::MarkedScene;
using variants::Rewritten;
using variants::SceneRun;

/// Whether other scenes may settle the doubt. They can't tell which of several answers was meant, or whether a matrix
/// was printed by rows.
bool may_be_settled(const ItemScore& item) {
    return item.doubt && item.doubt->why != Doubt::Why::another_answer && item.doubt->why != Doubt::Why::by_columns;
}

template <class Visit>
void for_each_item(const Score& score, Visit visit) {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) visit(item);
    }
}

std::string_view clause_of(Unsettled why) {
    switch (why) {
        case Unsettled::scene_not_found:
            return "the scene was not found in the source, so that it can't be run on another one";
        case Unsettled::ended_differently: return "on other scenes the program ended in another way";
        case Unsettled::printed_otherwise: return "on other scenes its printout has other lines";
        case Unsettled::constants: return "it prints the same numbers on every scene";
    }
    return "";
}

/// "Line 14 was read as t because it changes as t does on 2 other scenes."
std::string note_of(const ItemPlace& place, std::size_t scenes) {
    const std::string on_scenes = scenes == 1 ? "another scene" : fmt::format("{} other scenes", scenes);
    if (place.first_line == 0 && !place.as_read)
        return fmt::format("Nothing printed changes as {} does on {}.", place.item, on_scenes);
    if (place.as_read) return fmt::format("No other number changes as {} does on {}.", place.item, on_scenes);
    const bool is_one = place.first_line == place.last_line;
    return fmt::format("{} read as {} because {} as {} does on {}.",
                       is_one ? fmt::format("Line {} was", place.first_line)
                              : fmt::format("Lines {}-{} were", place.first_line, place.last_line),
                       place.item, is_one ? "it changes" : "they change", place.item, on_scenes);
}

class ClassInDoubt {
  public:
    ClassInDoubt(std::vector<Graded>& graded, const Marking& marking) : graded_(graded), marking_(marking) {}

    const std::vector<MarkedScene>& scenes_for(std::size_t index, const source::PartSet& located) {
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
        Unsettled why = Unsettled::scene_not_found;
        for (const SceneRun& run : rewritten.runs) {
            if (!variants::why_not_tried(run).empty()) continue;
            why = Unsettled::ended_differently;
            if (!ended_alike(*run.graded, graded)) continue;
            const Marking& there = *run.scene->marking;
            observations.push_back({read_transcript(run.graded->execution.printout, last_question(graded.score)),
                                    there.key, there.assignment});
        }
        graded.findings.experiment.emplace();
        if (observations.empty()) {
            graded.findings.experiment->unsettled = clause_of(why);
        } else {
            settle(graded, marking, observations);
        }
        mark_again(graded, marking_);
    }

  private:
    static bool ended_alike(const Graded& there, const Graded& graded) {
        const ProcessResult &run = there.execution.run, &own = graded.execution.run;
        return there.execution.outcome == graded.execution.outcome && run.ended == own.ended &&
               run.signal == own.signal && run.exit_code == own.exit_code && !there.execution.printout.empty();
    }

    void settle(Graded& graded, const Marking& marking, const std::vector<Observation>& observations) const {
        std::set<reference::ItemId> settled, doubtful;
        for_each_item(graded.score, [&](const ItemScore& item) {
            (may_be_settled(item) ? doubtful : settled).insert(item.spec.id);
        });
        const std::string& printout = graded.execution.printout;
        const Transcript transcript = read_transcript(printout, last_question(graded.score));
        const auto items = asked_items(graded.score);
        const std::vector<MatchedItem> matched = match(transcript, items, places_in(graded.submission.rereads, printout));
        Identified identified = identify({transcript, matched, settled, doubtful}, observations);
        ExperimentReport& report = *graded.findings.experiment;
        for (ItemPlace& place : identified.places) {
            const bool was_doubtful = std::ranges::any_of(items, [&](const reference::ItemSpec& item) {
                return item.question == place.question && item.name == place.item && doubtful.contains(item.id);
            });
            if (was_doubtful) place.note = note_of(place, observations.size());
        }
        for (const FoundMistake& mistake : identified.mistakes)
            report.mistakes.push_back({mistake.item.question, std::string(mistake.item.name), mistake.diagnosis,
                                       mistake.advice});
        if (identified.unsettled) {
            report.unsettled = clause_of(*identified.unsettled);
        } else if (!identified.remaining.empty()) {
            report.unsettled = "its runs on other scenes do not show what was meant";
        }
        report.places = std::move(identified.places);
        drop_losses(graded, marking, transcript);
    }

    /// Takes back the places by which an item would lose points.
    static void drop_losses(Graded& graded, const Marking& marking, const Transcript& transcript) {
        ExperimentReport& report = *graded.findings.experiment;
        const Score score =
            harness::score(transcript, marking.key, marking.assignment, places_of(graded, graded.execution.printout));
        constexpr double rounding = 1e-9;
        std::map<reference::ItemId, double> before;
        for_each_item(graded.score, [&](const ItemScore& item) { before[item.spec.id] = item.points; });
        bool loses = false;
        for_each_item(score, [&](const ItemScore& item) {
            loses = loses || item.points < before[item.spec.id] - rounding;
        });
        if (!loses) return;
        report.places.clear();
        report.unsettled = "what its runs on other scenes show would cost points";
    }

    std::vector<Graded>& graded_;
    const Marking& marking_;
    std::map<std::pair<const Marking*, source::PartSet>, std::vector<MarkedScene>> scenes_;
};

}  // namespace

bool is_doubtful(const Graded& graded) {
    if (graded.execution.printout.empty() || graded.submission.source.empty()) return false;
    bool doubtful = false;
    for_each_item(graded.score, [&](const ItemScore& item) { doubtful = doubtful || may_be_settled(item); });
    return doubtful;
}

variants::Trial on_doubts(std::vector<Graded>& graded, const Marking& marking) {
    const auto all = std::make_shared<ClassInDoubt>(graded, marking);
    const auto scenes_for = [all](std::size_t index, const source::PartSet& located) -> const auto& {
        return all->scenes_for(index, located);
    };
    return {scenes_for, [all](const Rewritten& rewritten) { all->conclude(rewritten); }, is_doubtful};
}

void settle_doubts(std::vector<Graded>& graded, const Marking& marking, const Runner& runner, int jobs,
                   Timeline& timeline) {
    if (std::ranges::none_of(graded, is_doubtful)) return;
    std::vector<std::string> sources;
    for (const Graded& result : graded)
        sources.push_back(is_doubtful(result) ? result.submission.source : std::string());
    variants::run_rewritten(graded, sources, marking, runner, jobs, timeline, {on_doubts(graded, marking)});
}

}  // namespace harness::experiment
