// How much of what generated programs print is found by their runs on other scenes. The programs compute; their layouts
// are ordinary, garbled or odd; each prints the same answers as in the handout's layout, whose marks are what it should
// get.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "harness/experiment/identify/identify.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/match/match.h"
#include "harness/source/scene/scene_part.h"
#include "harness/variants/generate.h"
#include "tests/given/cases.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"
#include "tests/given/student/unusual.h"

namespace harness::experiment {
namespace {

using student::Program;
using Layout = std::function<std::string(const Program&, std::uint64_t)>;
using MaybeMistake = std::optional<Program::Mistake>;

struct OtherScene {
    reference::Assignment assignment;
    reference::AnswerKey key;
};

std::vector<std::unique_ptr<OtherScene>> other_scenes(const student::Marking& marking) {
    source::PartSet all;
    for (const source::ScenePart part : source::all_parts()) all.insert(part);
    std::vector<std::unique_ptr<OtherScene>> scenes;
    for (const reference::Variant& variant : variants::scenes_with_all_hit(marking.assignment, all, 2)) {
        reference::Assignment assignment = marking.assignment;
        assignment.scene = variant.scene;
        auto key = reference::make_key(assignment, reference::Precision::certified);
        scenes.push_back(std::make_unique<OtherScene>(std::move(assignment), std::move(key)));
    }
    return scenes;
}

class Trial {
  public:
    explicit Trial(std::string_view scene) : marking_(student::scene_named(scene)), others_(other_scenes(marking_)) {}

    struct Counts {
        int items = 0, lost_before = 0, lost = 0, lost_unnoticed = 0, gained = 0, doubted_before = 0, doubted = 0;
        int students_lost_before = 0, students_lost = 0, students = 0;
    };

    void add(const student::Way& way, const MaybeMistake& mistake, const Layout& layout, std::uint64_t seed) {
        const Program program(marking_.assignment, way, mistake);
        const Score right = marked(student::print(program), {}, {});
        const std::string output = layout(program, seed);
        const Transcript transcript = read_transcript(output, last_question(marking_.assignment.questions));
        const Score before = score(transcript, marking_.key, marking_.assignment);
        const ExperimentReport report = experiment(transcript, before, way, mistake, layout, seed);
        Score after = score(transcript, marking_.key, marking_.assignment, report.places);
        note_experiment(after, report);
        compare(right, before, after, output, seed);
    }

    const Counts& counts() const { return counts_; }
    const std::string& shown() const { return shown_; }

  private:
    Score marked(const std::string& output, std::span<const ItemPlace> places, const std::string& /*name*/) const {
        return score(read_transcript(output, last_question(marking_.assignment.questions)), marking_.key,
                     marking_.assignment, places);
    }

    ExperimentReport experiment(const Transcript& transcript, const Score& before, const student::Way& way,
                                const MaybeMistake& mistake, const Layout& layout, std::uint64_t seed) {
        bool is_doubtful = false;
        for (const QuestionScore& question : before.questions)
            is_doubtful = is_doubtful || std::ranges::any_of(question.items, may_be_settled);
        if (!is_doubtful) return {};
        std::vector<Observation> observations;
        for (const auto& other : others_) {
            const Program program(other->assignment, way, mistake);
            observations.push_back(
                {read_transcript(layout(program, seed), last_question(other->assignment.questions)), other->key,
                 other->assignment});
        }
        const auto items = asked_items(before);
        const std::vector<MatchedItem> matched = match(transcript, items);
        return identify({transcript, matched, before}, observations);
    }

    void compare(const Score& right, const Score& before, const Score& after, const std::string& output,
                 std::uint64_t seed) {
        std::string told;
        bool lost_before = false, lost = false;
        for (std::size_t q = 0; q < right.questions.size(); ++q) {
            for (std::size_t i = 0; i < right.questions[q].items.size(); ++i) {
                const ItemScore& due = right.questions[q].items[i];
                const ItemScore& first = before.questions[q].items[i];
                const ItemScore& given = after.questions[q].items[i];
                ++counts_.items;
                counts_.lost_before += first.points < due.points - 1e-9 ? 1 : 0;
                lost_before = lost_before || first.points < due.points - 1e-9;
                counts_.doubted_before += first.doubt ? 1 : 0;
                counts_.doubted += given.doubt ? 1 : 0;
                const bool is_lost = given.points < due.points - 1e-9, is_gained = given.points > due.points + 1e-9;
                counts_.lost += is_lost ? 1 : 0;
                lost = lost || is_lost;
                counts_.lost_unnoticed += is_lost && !given.doubt ? 1 : 0;
                counts_.gained += is_gained && given.points > first.points + 1e-9 ? 1 : 0;
                if (is_lost || is_gained || given.doubt || std::getenv("RAYGRADE_ALL") != nullptr) {
                    told += fmt::format("  {}.{} due {} ({}), read {}{}, now {} '{}' line {} {}{}\n",
                                        right.questions[q].number, due.spec.name, to_string(due.verdict), due.printed,
                                        to_string(first.verdict), first.doubt ? "?" : "", to_string(given.verdict), given.printed, given.line,
                                        given.doubt ? to_string(given.doubt->why) : "", is_gained ? " GAINED" : "");
                }
            }
        }
        ++counts_.students;
        counts_.students_lost_before += lost_before ? 1 : 0;
        counts_.students_lost += lost ? 1 : 0;
        if (!told.empty()) shown_ += fmt::format("seed {}\n{}{}\n", seed, told, output);
    }

    student::Marking marking_;
    std::vector<std::unique_ptr<OtherScene>> others_;
    Counts counts_;
    std::string shown_;
};

void tell(std::string_view name, const Trial& trial) {
    const Trial::Counts& c = trial.counts();
    std::cout << fmt::format(
        "{}: {} students, {} items; lost {} -> {} (unnoticed {}), students with a loss {} -> {}, given {}, "
        "doubts {} -> {}\n",
        name, c.students, c.items, c.lost_before, c.lost, c.lost_unnoticed, c.students_lost_before, c.students_lost,
        c.gained, c.doubted_before, c.doubted);
    if (std::getenv("RAYGRADE_SHOW") != nullptr) std::cout << trial.shown();
}

std::string as_written(const Program& program, std::uint64_t seed) {
    return write(program, seed).output;
}
std::string as_garbled(const Program& program, std::uint64_t seed) {
    return student::garbled(write(program, seed), seed);
}
std::string as_unusual(const Program& program, std::uint64_t seed) {
    return student::write_unusual(program, seed).output;
}

std::vector<std::pair<const char*, Layout>> layouts() {
    return {{"written", as_written}, {"garbled", as_garbled}, {"unusual", as_unusual}};
}

TEST(Identify, FindsWhatRightProgramsPrint) {
    for (const auto& [name, layout] : layouts()) {
        Trial trial("off axis");
        for (std::uint64_t seed = 1; seed <= cases(100); ++seed) trial.add({}, {}, layout, seed);
        tell(name, trial);
        EXPECT_EQ(trial.counts().gained, 0);
        EXPECT_LE(trial.counts().lost_unnoticed, 0);
    }
}

TEST(Identify, FindsWhatWrongProgramsPrint) {
    for (const auto& [name, layout] : layouts()) {
        Trial trial("off axis");
        std::uint64_t seed = 1;
        for (const student::NamedMistake& named : student::named_mistakes()) {
            if (named.mistake.item.subject == reference::Subject::cylinder) continue;
            trial.add({}, named.mistake, layout, seed++);
        }
        tell(name, trial);
        EXPECT_EQ(trial.counts().gained, 0);
        EXPECT_LE(trial.counts().lost_unnoticed, 0);
    }
}

}  // namespace
}  // namespace harness::experiment
