#include "harness/report/text/feedback.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/mark_transcript.h"
#include "harness/record/marking.h"
#include "harness/report/text/item_text.h"
#include "harness/report/text/sentences.h"
#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/read_page.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(Feedback, IsAsInTheGoldenFiles) {
    const Graded ada = telling_class().front();
    EXPECT_TRUE(is_golden(feedback_markdown(ada, marking()), "feedback.md"));
    EXPECT_TRUE(is_golden(check_text(ada), "check.txt"));
}

TEST(Feedback, NeverShowsAnExpectedValue) {
    Graded wrong = graded("s01", wrong_everywhere());
    const std::vector<std::string> traces = traces_of_key();
    ASSERT_GT(traces.size(), 30U);
    wrong.findings.variants = broken_on_a_variant(traces[0], traces[1]);
    EXPECT_THAT(feedback_markdown(wrong, marking()), HasSubstr("no longer right: question 6 (t)."));
    for (const std::string& text : {feedback_markdown(wrong, marking()), check_text(wrong),
                                    item_sentence(wrong.score.questions[5].items[4], Outcome::graded)}) {
        for (const std::string& trace : traces) EXPECT_THAT(text, Not(HasSubstr(trace)));
        EXPECT_THAT(text, Not(HasSubstr("sphere first")));
    }
}

TEST(Feedback, NeverShowsAnExpectedValueForNamedMistakes) {
    const std::vector<std::string> traces = traces_of_key();
    const student::Program right(marking().assignment, {});
    for (const student::NamedMistake& mistake : student::named_mistakes()) {
        const Score score =
            harness::score(read_transcript(print(student::Program(marking().assignment, {}, mistake.mistake)), 10),
                           marking().key, marking().assignment);
        for (const QuestionScore& question : score.questions) {
            for (const ItemScore& item : question.items) {
                for (const std::string& trace : traces)
                    EXPECT_THAT(item_sentence(item, Outcome::graded), Not(HasSubstr(trace))) << mistake.name;
            }
        }
    }
}

TEST(Feedback, ShowsHostileTextInABlockThatItCannotEnd) {
    const std::string text = feedback_markdown(hostile(), marking());
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_THAT(text, Not(HasSubstr("\xff")));
    EXPECT_THAT(text, HasSubstr("\\x1b[31m")) << "visible, not obeyed";
    EXPECT_THAT(text, AllOf(HasSubstr("\n`````\n"), HasSubstr("\nray_cast.cpp:1: ````")))
        << "the fence is longer than any run of backticks in it";
}

TEST(Feedback, ShowsAllMarkupAsText) {
    Marking titled = marking();
    titled.assignment.title = markup(0);
    Graded one = markup_everywhere();
    one.execution.explanation += " ![x](y) *z* [a]: `b` \\<b>\x1b[31m\n# c";
    one.score.questions.front().title = markup(last_markup + 1) + " a|b";
    const json read = read_markdown(feedback_markdown(one, titled));
    for (const char* element : {"b", "img", "a", "em"}) EXPECT_FALSE(read.at("counts").contains(element)) << element;
    EXPECT_EQ(read.at("counts").at("h1"), 1);
    const std::string text = read.at("text");
    EXPECT_THAT(text, HasSubstr(markup(4) + " ![x](y) *z* [a]: `b` \\<b>\\x1b[31m # c"));
    for (const int n : {0, 2, 5, 7, 8, 10, 11, 12, 13, 14, 15}) EXPECT_THAT(text, HasSubstr(markup(n))) << n;
    EXPECT_THAT(text, HasSubstr(markup(last_markup + 1) + " a|b")) << "a question's title";
}

TEST(Feedback, ShowsTheBeginningOfManyCompilerMessagesInEveryText) {
    Graded one;
    one.execution.outcome = Outcome::compile_error;
    for (int i = 1; i <= 100; ++i) one.execution.build.diagnostics += "candidate " + std::to_string(i) + "\n";
    for (const std::string& text : {check_text(one), feedback_markdown(one, marking()), submission_text(one)}) {
        EXPECT_THAT(text, AllOf(HasSubstr("candidate 1\n"), HasSubstr("candidate 40\n… 60 more lines\n"),
                                Not(HasSubstr("candidate 41"))));
    }
}

TEST(Feedback, SaysWhyThereAreNoMarksWithoutTheInstructorsPath) {
    Graded bob = not_graded("bob");
    bob.submission.file = "/home/prof/class/bob/ray_cast.cpp";
    bob.submission.problem = "\"/home/prof/class/bob/ray_cast.cpp\" is a symbolic link. Put the file itself there.";
    const std::string text = feedback_markdown(bob, marking());
    EXPECT_THAT(text, HasSubstr("Not graded.\n\"ray_cast.cpp\" is a symbolic link."));
    EXPECT_THAT(text, Not(HasSubstr("prof")));
    EXPECT_THAT(text, Not(HasSubstr(" points")));
}

TEST(Feedback, HidesTheMachinesFailuresFromTheStudent) {
    Graded bob = not_graded("bob");
    bob.execution.explanation = "The disk of \"/srv/grading\" has less than 256 MiB left.";
    const std::string text = feedback_markdown(bob, marking());
    EXPECT_THAT(text, HasSubstr("not your program's fault"));
    EXPECT_THAT(text, Not(HasSubstr("/srv")));
}

TEST(CheckText, HasColourOnATerminalOnly) {
    const Graded one = graded("s01", output_with_a_mistake());
    const std::string text = check_text(one, reference::Feedback::mistake, Colors::terminal);
    EXPECT_THAT(text, HasSubstr("P_VCS         \x1b[32mright     \x1b[0m"));
    EXPECT_THAT(text, HasSubstr("\x1b[31mwrong     \x1b[0m"));
    EXPECT_THAT(check_text(one), Not(HasSubstr("\x1b")));
}

TEST(CheckText, SaysOnceWhatOtherScenesShow) {
    Graded one = graded("s01", output_with_a_mistake());
    one.score.questions[5].items[0].experiment = "Line 9 was read as a because it changes as a does on 2 other scenes.";
    one.score.questions[6].items[0].verdict = ItemVerdict::missing;
    one.score.questions[6].items[0].experiment = "Nothing printed changes as normal does on 2 other scenes.";
    for (const std::string& text : {check_text(one), feedback_markdown(one, marking())}) {
        for (const char* note : {"Line 9 was read as a because", "Nothing printed changes as normal does"}) {
            const std::size_t at = text.find(note);
            EXPECT_NE(at, std::string::npos) << note;
            EXPECT_EQ(text.find(note, at + 1), std::string::npos) << note;
        }
    }
}

TEST(CheckText, ShowsNoControlBytes) {
    EXPECT_THAT(check_text(hostile()), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace harness::report
