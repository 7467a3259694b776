// How much of what generated programs print is found by their runs on other scenes. The programs compute; their layouts
// are ordinary, garbled or odd. What each should get are the marks of the same answers in the handout's layout.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "tests/given/cases.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/unusual.h"
#include "tests/harness/experiment/identify/student_on_scenes.h"

namespace harness::experiment {
namespace {

using student::Program;
using MaybeMistake = std::optional<Program::Mistake>;

/// A layout of many students.
using Layouts = std::function<std::string(const Program&, std::uint64_t seed)>;

class Class {
  public:
    explicit Class(std::string_view scene) : student_(scene) {}

    struct Counts {
        int students = 0, items = 0;
        int lost_before = 0, lost = 0;  ///< items with less than the same answers get in the handout's layout
        int lost_unnoticed = 0;         ///< of students without any doubt about an answer that is not right
        int gained = 0;                 ///< items with more
        int doubts_before = 0, doubts = 0;
    };

    void add(const MaybeMistake& mistake, const Layouts& layouts, std::uint64_t seed) {
        const Score due = student_.marked(student::print(student_.program({}, mistake)));
        const auto result =
            student_.run([&](const Program& program) { return layouts(program, seed); }, student::Way(), mistake);
        compare(due, result, seed);
    }

    const Counts& counts() const { return counts_; }

    /// With RAYGRADE_SHOW also the printouts in which something is lost.
    void tell(std::string_view name) const {
        const Counts& c = counts_;
        std::cout << fmt::format("{}: {} students, {} items; lost {} -> {} (unnoticed {}), given {}, doubts {} -> {}\n",
                                 name, c.students, c.items, c.lost_before, c.lost, c.lost_unnoticed, c.gained,
                                 c.doubts_before, c.doubts);
        if (std::getenv("RAYGRADE_SHOW") != nullptr) std::cout << shown_;
    }

  private:
    void compare(const Score& due, const StudentOnScenes::Result& result, std::uint64_t seed) {
        constexpr double rounding = 1e-9;
        std::string told;
        bool is_in_doubt = false;
        for_each_item(result.after, [&](const ItemScore& item) {
            is_in_doubt = is_in_doubt || (item.doubt && item.verdict != ItemVerdict::right);
        });
        ++counts_.students;
        for (std::size_t q = 0; q < due.questions.size(); ++q) {
            for (std::size_t i = 0; i < due.questions[q].items.size(); ++i) {
                const ItemScore& right = due.questions[q].items[i];
                const ItemScore& before = result.before.questions[q].items[i];
                const ItemScore& after = result.after.questions[q].items[i];
                const bool is_lost = after.points < right.points - rounding;
                const bool is_gained =
                    after.points > right.points + rounding && after.points > before.points + rounding;
                ++counts_.items;
                counts_.lost_before += before.points < right.points - rounding ? 1 : 0;
                counts_.lost += is_lost ? 1 : 0;
                counts_.lost_unnoticed += is_lost && !is_in_doubt ? 1 : 0;
                counts_.gained += is_gained ? 1 : 0;
                counts_.doubts_before += before.doubt ? 1 : 0;
                counts_.doubts += after.doubt ? 1 : 0;
                if (!is_lost && !is_gained) continue;
                told += fmt::format("  {}.{}: due {}, {}read {}, now {} '{}' line {}{}\n", due.questions[q].number,
                                    right.spec.name, to_string(right.verdict), before.doubt ? "doubtfully " : "",
                                    to_string(before.verdict), to_string(after.verdict), after.printed, after.line,
                                    after.doubt ? ", in doubt" : "");
            }
        }
        if (!told.empty()) shown_ += fmt::format("seed {}\n{}{}\n", seed, told, result.printout);
    }

    StudentOnScenes student_;
    Counts counts_;
    std::string shown_;
};

std::string as_written(const Program& program, std::uint64_t seed) {
    return write(program, seed).output;
}
std::string as_garbled(const Program& program, std::uint64_t seed) {
    return student::garbled(write(program, seed), seed);
}
std::string as_unusual(const Program& program, std::uint64_t seed) {
    return student::write_unusual(program, seed).output;
}

Class::Counts right_programs(std::string_view name, const Layouts& layouts, std::string_view scene = "off axis") {
    Class all(scene);
    for (std::uint64_t seed = 1; seed <= cases(100); ++seed) all.add({}, layouts, seed);
    all.tell(name);
    return all.counts();
}

/// One for each named mistake but those about the cylinder, which this scene has not.
Class::Counts wrong_programs(std::string_view name, const Layouts& layouts) {
    Class all("off axis");
    std::uint64_t seed = 1;
    for (std::uint64_t round = 0; round < cases(1); ++round) {
        for (const student::NamedMistake& named : student::named_mistakes()) {
            if (named.mistake.item.subject != reference::Subject::cylinder) all.add(named.mistake, layouts, seed++);
        }
    }
    all.tell(name);
    return all.counts();
}

TEST(Identify, FindsTheAnswersOfRightPrograms) {
    const Class::Counts written = right_programs("written", as_written);
    EXPECT_EQ(written.lost, 0);
    const Class::Counts unusual = right_programs("unusual", as_unusual);
    EXPECT_GT(unusual.lost_before, unusual.items / 4) << "the layouts are not unusual enough";
    EXPECT_LE(unusual.lost, unusual.items / 1000);
    EXPECT_EQ(unusual.lost_unnoticed, 0);
    const Class::Counts garbled = right_programs("garbled", as_garbled);  // also what nobody can read
    EXPECT_LE(garbled.lost, 2 * garbled.lost_before / 5);
    EXPECT_LE(garbled.lost_unnoticed, garbled.items / 300);
}

TEST(Identify, FindsTheAnswersOnASceneOfSmallWholeNumbers) {
    const Class::Counts unusual = right_programs("unusual, handout", as_unusual, "handout");
    EXPECT_GT(unusual.lost_before, unusual.items / 4) << "the layouts are not unusual enough";
    EXPECT_LE(unusual.lost, unusual.items / 100);
    EXPECT_EQ(unusual.lost_unnoticed, 0);
}

TEST(Identify, GivesWrongProgramsNoExtraPoints) {
    for (const auto& [name, layouts] : {std::pair<const char*, Layouts>("written", as_written),
                                        std::pair<const char*, Layouts>("garbled", as_garbled),
                                        std::pair<const char*, Layouts>("unusual", as_unusual)}) {
        SCOPED_TRACE(name);
        const Class::Counts counts = wrong_programs(name, layouts);
        // Layouts that lose the words which state a matrix's columns lose what makes a transpose wrong.
        const bool may_lose_words = std::string_view(name) != "written";
        EXPECT_LE(counts.gained, may_lose_words ? counts.items / 2000 : 0);
        EXPECT_LE(counts.lost, std::max(1, counts.lost_before / 2));
        EXPECT_LE(counts.lost_unnoticed, std::string_view(name) == "garbled" ? counts.items / 500 : 0);
    }
}

}  // namespace
}  // namespace harness::experiment
