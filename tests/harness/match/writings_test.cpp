// Right answers get full marks in the way of writing of any student. A failing printout is printed whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "harness/mark/score/score.h"
#include "tests/given/cases.h"
#include "tests/given/student/scenes.h"
#include "tests/given/student/writing.h"

namespace {

using namespace harness;
using student::Writing;

/// The items that lose points, "6.t", each with its verdict.
std::vector<std::string> lost_by(const Score& score) {
    std::vector<std::string> lost;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict != ItemVerdict::right)
                lost.push_back(fmt::format("{}.{} {}: {}", question.number, item.spec.name, to_string(item.verdict), item.printed));
        }
    }
    return lost;
}

TEST(Writings, GetFullMarksForRightAnswers) {
    const student::Marking marking = student::off_axis_scene();
    const student::Program program(marking.assignment, {});
    std::map<std::pair<std::string, std::string>, std::pair<int, int>> tried_and_failed;
    const std::uint64_t count = cases(300);
    int failed = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const Writing writing = write(program, seed);
        const auto lost = lost_by(score(read_transcript(writing.output), marking.key, marking.assignment));
        failed += lost.empty() ? 0 : 1;
        for (const auto& drawn : writing.features) {
            ++tried_and_failed[drawn].first;
            tried_and_failed[drawn].second += lost.empty() ? 0 : 1;
        }
        if (const char* show = std::getenv("RAYGRADE_SHOW"); show != nullptr && !lost.empty() && failed <= std::atoi(show)) {
            std::string told;
            for (const std::string& item : lost) told += item + ", ";
            for (const auto& [feature, choice] : writing.features) told += "\n  " + feature + ": " + choice;
            std::cout << "seed " << seed << ": " << told << "\n" << writing.output << "\n";
        }
    }
    for (const auto& [drawn, counts] : tried_and_failed) {
        if (counts.second > 0)
            std::cout << fmt::format("{:20} {:22} {:4} of {:4}\n", drawn.first, drawn.second, counts.second, counts.first);
    }
    EXPECT_EQ(failed, 0) << "of " << count;
}

}  // namespace
