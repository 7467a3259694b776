// A correct program loses no mark: whatever formulas it uses, whatever it computes in, whatever flags it is compiled
// under, whatever its roundings are, and whatever the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "tests/given/cases.h"
#include "tests/given/printed_values.h"
#include "tests/harness/mark/correct_programs/graded.h"
#include "tests/harness/mark/correct_programs/scenes.h"

namespace {

using namespace correct;

class CorrectPrograms : public testing::TestWithParam<std::string_view> {};

TEST_P(CorrectPrograms, LoseNoMark) {
    const std::uint64_t scenes = is_nightly() ? 200 : 3;
    std::vector<student::Marking> markings;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const reference::Assignment assignment = scene_of(GetParam(), seed);
        markings.push_back({assignment, make_key(assignment, reference::Precision::certified)});
    }
    std::uint64_t seed = 0;
    std::vector<std::string_view> programs(flag_sets.begin(), flag_sets.end());
    programs.push_back(drawn_roundings);
    // -Ofast may compute an expression twice, with other roundings. Where these are all that float has, a program's
    // answers then contradict each other: it divides a vector by another vector's length.
    if (std::ranges::count(kinds_beyond_float, GetParam()) > 0)
        std::erase_if(programs, [](std::string_view flags) { return flags.starts_with("Ofast"); });
    for (const std::string_view flags : programs) {
        std::vector<Task> tasks;
        for (const student::Marking& marking : markings) {
            for (int i = 0; i < 4; ++i) tasks.push_back({&marking.assignment.scene, random_program(seed++)});
        }
        const std::vector<std::string> printed = printouts(flags, tasks);
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const student::Marking& marking = markings[i / 4];
            for (const Loss& loss : losses(mark(printed[i], marking))) {
                if (loss.not_finite) continue;
                ADD_FAILURE() << marking.assignment.name << ", " << flags << ", " << tasks[i].program.describe() << "\n"
                              << loss.text;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CorrectPrograms, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param); });
INSTANTIATE_TEST_SUITE_P(ScenesBeyondFloat, CorrectPrograms, testing::ValuesIn(kinds_beyond_float),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
