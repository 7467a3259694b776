// Right answers get full marks in the way of writing of any student. A failing printout is printed whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "harness/mark/score/doubts_text.h"
#include "harness/mark/score/mark_transcript.h"
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
                lost.push_back(fmt::format("{}.{} {}: {}", question.number, item.spec.name, to_string(item.verdict),
                                           item.printed));
        }
    }
    return lost;
}

/// Marks the program's answers in the ways of writing of some hundreds of students, and tells which lose points. One in
/// `per_loss` may.
void expect_full_marks(std::string_view scene, std::uint64_t per_loss) {
    const student::Marking marking = student::scene_named(scene);
    const student::Program program(marking.assignment, {});
    const int questions = last_question(marking.assignment.questions);
    std::map<std::pair<std::string, std::string>, std::pair<int, int>> tried_and_failed;
    const std::uint64_t count = cases(300);
    int failed = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const Writing writing = write(program, seed);
        const auto lost = lost_by(score(read_transcript(writing.output, questions), marking.key, marking.assignment));
        failed += lost.empty() ? 0 : 1;
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
    EXPECT_LE(failed, static_cast<int>(count / per_loss)) << "of " << count;
}

TEST(Writings, GetFullMarksForRightAnswers) {
    expect_full_marks("off axis", 1000);
}

// A program that prints question 1 last, and then begins with it for another pixel, is read as if it went on.
TEST(Writings, GetFullMarksForRightAnswersInFiveQuestions) {
    for (const char* scene : {"handout of 2024", "tube and bottom", "top and tube", "in the cylinder"}) {
        SCOPED_TRACE(scene);
        expect_full_marks(scene, 150);
    }
}

/// The line with each run of `characters` replaced by what `replace` makes of it and of the characters around it.
std::string with_runs(const std::string& line, const std::string& characters,
                      const std::function<std::string(const std::string&, char, char)>& replace) {
    std::string text;
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t end = std::min(line.find_first_not_of(characters, i), line.size());
        if (end == i) {
            text += line[i++];
            continue;
        }
        text += replace(line.substr(i, end - i), i > 0 ? line[i - 1] : ' ', end < line.size() ? line[end] : ' ');
        i = end;
    }
    return text;
}

/// The printout with something in it that nobody could foresee: other signs between the numbers of a line, headings or
/// labels that mean nothing, a word that is glued to each number, lines that are joined.
std::string garbled(const Writing& writing, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto one_of = [&](std::initializer_list<const char*> list) {
        return *(list.begin() + random() % list.size());
    };
    const auto kind = random() % 5;
    std::string text;
    std::istringstream lines(writing.output);
    const std::string heading = writing.features.contains("heading") ? writing.features.at("heading") : "";
    const std::string before_number = heading.substr(0, heading.find('1'));
    for (std::string line; std::getline(lines, line);) {
        std::string changed = line;
        if (kind == 0) {
            const std::string sign = one_of({" .. ", " <-> ", " to ", " # ", " $ ", " %% ", " then ", " @ "});
            changed = with_runs(line, " ,;|/_&\t", [&](const std::string& run, char before, char after) {
                return std::isdigit(before) && (std::isdigit(after) || after == '-') ? sign : run;
            });
        } else if (kind == 1) {
            const std::string word = one_of({"foo", "qux", "zzz", "lorem"});
            const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
            changed = with_runs(line, letters,
                                [&](const std::string& run, char, char) { return run.size() > 1 ? word : run; });
        } else if (kind == 2) {
            const std::string before_it = one_of({"", "", "v", "'"}), behind = one_of({"m", "_px", "'"});
            changed = with_runs(line, "0123456789.", [&](const std::string& run, char, char) {
                return run.find('.') == std::string::npos ? run : before_it + run + behind;
            });
        } else if (kind == 3 && random() % 4 == 0) {
            text += changed + " ~ ";
            continue;
        } else if (kind == 4) {
            if (before_number.size() > 1 && changed.starts_with(before_number)) changed = "next";
        }
        text += changed + "\n";
    }
    return text;
}

TEST(Writings, ThatAreMisreadAreDoubted) {
    const student::Marking marking = student::off_axis_scene();
    const student::Program program(marking.assignment, {});
    std::uint64_t misread = 0, unnoticed = 0;
    for (std::uint64_t seed = 1; seed <= cases(100); ++seed) {
        const std::string output = garbled(write(program, seed), seed);
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
