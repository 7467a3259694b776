// Right answers get full marks in the way of writing of any student. A failing printout is printed whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "harness/mark/score/doubts_text.h"
#include "harness/mark/score/mark_transcript.h"
#include "tests/given/cases.h"
#include "tests/given/student/scenes.h"
#include "tests/given/student/unusual.h"

namespace {

using namespace harness;
using student::Writing;

/// The items that lose points, "6.t", each with its verdict.
std::vector<std::string> lost_by(const Score& score) {
    std::vector<std::string> lost;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict != ItemVerdict::right)
                lost.push_back(fmt::format("{}.{} {}: {}", question.number, item.spec.name, to_string(item.verdict),
                                           item.printed));
        }
    }
    return lost;
}

/// Marks the program's answers in the ways of writing of some hundreds of students, and tells which lose points. One in
/// eight may: an experiment finds their answers, for which a doubt must ask.
void expect_full_marks(std::string_view scene) {
    const student::Marking marking = student::scene_named(scene);
    const student::Program program(marking.assignment, {});
    const int questions = last_question(marking.assignment.questions);
    std::map<std::pair<std::string, std::string>, std::pair<int, int>> tried_and_failed;
    const std::uint64_t count = cases(300);
    int failed = 0, unnoticed = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const Writing writing = write(program, seed);
        const Score marked = score(read_transcript(writing.output, questions), marking.key, marking.assignment);
        const auto lost = lost_by(marked);
        failed += lost.empty() ? 0 : 1;
        unnoticed += !lost.empty() && doubts_text(marked, Audience::instructor).empty() ? 1 : 0;
        for (const auto& drawn : writing.features) {
            ++tried_and_failed[drawn].first;
            tried_and_failed[drawn].second += lost.empty() ? 0 : 1;
        }
        if (const char* show = std::getenv("RAYGRADE_SHOW");
            show != nullptr && !lost.empty() && failed <= std::atoi(show)) {
            std::string told;
            for (const std::string& item : lost) told += item + ", ";
            for (const auto& [feature, choice] : writing.features) told += "\n  " + feature + ": " + choice;
            std::cout << "seed " << seed << ": " << told << "\n" << writing.output << "\n";
        }
    }
    for (const auto& [drawn, counts] : tried_and_failed) {
        if (counts.second > 0)
            std::cout << fmt::format("{:20} {:22} {:4} of {:4}\n", drawn.first, drawn.second, counts.second,
                                     counts.first);
    }
    EXPECT_LE(failed, static_cast<int>(count / 8)) << "of " << count;
    EXPECT_LE(unnoticed, static_cast<int>(count / 100)) << "of " << count;
}

TEST(Writings, GetFullMarksForRightAnswers) {
    expect_full_marks("off axis");
}

// A program that prints question 1 last, and then begins with it for another pixel, is read as if it went on.
TEST(Writings, GetFullMarksForRightAnswersInFiveQuestions) {
    for (const char* scene : {"handout of 2024", "tube and bottom", "top and tube", "in the cylinder"}) {
        SCOPED_TRACE(scene);
        expect_full_marks(scene);
    }
}

TEST(Writings, ThatAreMisreadAreDoubted) {
    const student::Marking marking = student::off_axis_scene();
    const student::Program program(marking.assignment, {});
    std::uint64_t misread = 0, unnoticed = 0;
    for (std::uint64_t seed = 1; seed <= cases(100); ++seed) {
        const std::string output = student::garbled(write(program, seed), seed);
        const Score marked = score(read_transcript(output, 10), marking.key, marking.assignment);
        if (marked.points == marked.max_points) continue;
        ++misread;
        const std::string doubts = doubts_text(marked, Audience::instructor);
        if (!doubts.empty()) continue;
        ++unnoticed;
        std::string told;
        for (const std::string& item : lost_by(marked)) told += item + ", ";
        if (const char* show = std::getenv("RAYGRADE_SHOW");
            show != nullptr && unnoticed <= std::strtoull(show, nullptr, 10))
            std::cout << "seed " << seed << ": " << told << "\n" << output << "\n";
    }
    EXPECT_GT(misread, cases(100) / 6) << "the printouts are not garbled enough";
    EXPECT_LE(unnoticed, misread / 1000) << "of " << misread << " that are misread";
}

}  // namespace
