#include "harness/report/text/feedback.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/mark_transcript.h"
#include "harness/record/marking.h"
#include "harness/report/text/feedback.h"
#include "harness/report/text/item_text.h"
#include "harness/report/text/sentences.h"
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

TEST(Feedback, NeverShowsAnExpectedValue) {
    Graded wrong = graded("s01", wrong_everywhere());
    const std::vector<std::string> traces = traces_of_key();
    ASSERT_GT(traces.size(), 30U);
    wrong.findings.variants = broken_on_a_variant(traces[0], traces[1]);
    EXPECT_THAT(feedback_markdown(wrong, marking()), HasSubstr("no longer right: 6.t."));
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

TEST(Feedback, ShowsQuestionAndLineAndPrintedAnswerAndMistake) {
    const std::string text = feedback_markdown(graded("s01", output_with_a_mistake()), marking());
    EXPECT_THAT(text, HasSubstr("**98.33 of 100 points**"));
    EXPECT_THAT(text, testing::ContainsRegex(
                          "- Question 6, t \\(line [0-9]+ of your output\\): you printed `t: [0-9.]+`|- Question "
                          "6, t \\(line [0-9]+ of your output\\): you printed `[0-9.]+`"));
    EXPECT_THAT(text, HasSubstr("far root"));
    EXPECT_THAT(text, HasSubstr("it follows correctly from an earlier mistake"));
    EXPECT_THAT(text, HasSubstr("\n`follow`: wrong, but computed correctly from your own earlier answers.\n"));
}

TEST(Feedback, SaysWhichQuestionToLookAtFirst) {
    const Graded one = graded("s01", output_with_a_mistake());
    for (const std::string& text : {feedback_markdown(one, marking()), check_text(one)})
        EXPECT_THAT(text,
                    HasSubstr("Look at question 6 first: it is the only one with a wrong answer. Question 7 only"));
}

TEST(Feedback, OmitsItemsThatAreSimplyRight) {
    const std::string text =
        feedback_markdown(graded("s01", print(student::Program(marking().assignment, {}))), marking());
    EXPECT_THAT(text, HasSubstr("**100 of 100 points**"));
    EXPECT_THAT(text, Not(HasSubstr("Answers to look at")));
}

TEST(Feedback, ShowsHostileTextInCodeThatItCannotEnd) {
    const std::string text = feedback_markdown(hostile(), marking());
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_THAT(text, Not(HasSubstr("\xff")));
    EXPECT_THAT(text, HasSubstr("\\x1b[31m")) << "visible, not obeyed";
    EXPECT_THAT(text, HasSubstr("\n`````\nray_cast.cpp:1: ````"))
        << "the fence is longer than any run of backticks in it";
}

TEST(Feedback, CallsTheStudentByName) {
    Graded one = graded("rossigiulia", output_with_a_mistake());
    EXPECT_THAT(feedback_markdown(one, marking()), HasSubstr("\n\nSubmission `rossigiulia`\n\n"));
    one.submission.name = "Rossi, Giulia";
    EXPECT_THAT(feedback_markdown(one, marking()),
                AllOf(HasSubstr("\n\nRossi, Giulia\n\n"), Not(HasSubstr("rossigiulia"))));
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

TEST(Feedback, ReportsACapThatCutPoints) {
    Graded capped = graded("s01", output_with_a_mistake());
    EXPECT_THAT(feedback_markdown(capped, marking()), Not(HasSubstr("at most")));
    capped.score.follow_cap = 2.5;
    EXPECT_THAT(feedback_markdown(capped, marking()), HasSubstr("earn at most 2.5 points in all"));
    EXPECT_THAT(check_text(capped), HasSubstr("earn at most 2.5 points in all"));
}

TEST(Feedback, ShowsTheBeginningOfManyCompilerMessagesInEveryText) {
    Graded one;
    one.execution.outcome = Outcome::compile_error;
    for (int i = 1; i <= 100; ++i) one.execution.build.diagnostics += "candidate " + std::to_string(i) + "\n";
    for (const std::string& text : {check_text(one), feedback_markdown(one, marking()), submission_text(one)}) {
        EXPECT_THAT(
            text, AllOf(HasSubstr("candidate 1\n"), HasSubstr("candidate 40\n… 60 more lines, which g++ prints too\n"),
                        Not(HasSubstr("candidate 41"))));
    }
}

TEST(Feedback, TellsHowToFindTheLineOfACrash) {
    Graded one = graded("ada", output_with_a_mistake());
    one.execution.outcome = Outcome::crashed;
    one.execution.run.ended = Ended::signalled;
    one.execution.explanation = "The program crashed (SIGSEGV).";
    const auto texts = [&] {
        return std::vector{check_text(one), feedback_markdown(one, marking()), submission_text(one)};
    };
    for (const std::string& text : texts()) EXPECT_THAT(text, HasSubstr("raygrade check --sanitize ray_cast.cpp"));
    one.execution.sanitizer = {"line 45: SEGV"};
    for (const std::string& text : texts()) EXPECT_THAT(text, Not(HasSubstr("--sanitize")));
    one.execution.sanitizer.clear();
    one.execution.run.ended = Ended::exited;
    for (const std::string& text : texts()) EXPECT_THAT(text, Not(HasSubstr("--sanitize")));
}

TEST(Feedback, ShowsFlagsAndSanitizerFindingsWithoutTakingMarks) {
    Graded one = graded("zoe", output_with_a_mistake());
    const std::string before = feedback_markdown(one, marking());
    one.findings.flags = {{"nondeterministic", "Question 1, P_VCS: run 1 printed `1`, run 2 printed 2."}};
    one.execution.sanitizer = {"ray_cast.cpp:7:9: runtime error: division by zero"};
    const std::string text = feedback_markdown(one, marking());
    EXPECT_THAT(text, testing::HasSubstr("answers differ from run to run: "));
    EXPECT_THAT(text, testing::HasSubstr("- `ray_cast.cpp:7:9: runtime error: division by zero`"));
    EXPECT_EQ(text.substr(0, text.find("## ")), before.substr(0, before.find("## ")));
}

TEST(Feedback, DescribesVariantsInNeutralWords) {
    Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_THAT(feedback_markdown(one, marking()), Not(HasSubstr("## On other scenes")));
    one.findings.flags = {{"hard_coded", "Question 6, t: the program prints 0.5"}};
    one.findings.variants = VariantsReport{
        VariantsVerdict::does_not_move, {}, {{"aside", "eye = (1, 2, 3)", "eye = (0, 0, 4)", true, {}}}, 1, {},
        {{6, "t", 0, "0.5", "0.5", ""}}};
    const std::string text = feedback_markdown(one, marking());
    EXPECT_THAT(text, HasSubstr("## On other scenes\n\nThis costs no points."));
    EXPECT_THAT(text, HasSubstr("- Printed numbers may not depend on the scene in the source: `Question 6, t"));
    EXPECT_THAT(text, HasSubstr("- The printed numbers of 6.t do not change when the scene in the source does.\n"));
    EXPECT_THAT(check_text(one), HasSubstr("\nThe printed numbers of 6.t do not change"));
}

TEST(Feedback, ShowsPointsForVariants) {
    Graded one = graded_on_variants("zoe");
    EXPECT_THAT(check_text(one), HasSubstr("\nOther scenes: 6 of 10 points.\n"));
    EXPECT_THAT(feedback_markdown(one, marking()), Not(HasSubstr("## On other scenes")));
    one.findings.variants = broken_on_a_variant("1.25", "1.5");
    const std::string text = feedback_markdown(one, marking());
    EXPECT_THAT(text, HasSubstr("## On other scenes\n\nOther scenes: 6 of 10 points.\n"));
    EXPECT_THAT(text, Not(HasSubstr("This costs no points.")));
    EXPECT_THAT(text, HasSubstr("104.33 of 110 points"));
}

TEST(Feedback, SaysWhyThereAreNoMarksWithoutTheInstructorsPath) {
    Graded bob = not_graded("bob");
    bob.submission.file = "/home/prof/class/bob/ray_cast.cpp";
    bob.submission.problem = "\"/home/prof/class/bob/ray_cast.cpp\" is a symbolic link. Put the file itself there.";
    const std::string text = feedback_markdown(bob, marking());
    EXPECT_THAT(text, HasSubstr("**Not graded.** `\"ray_cast.cpp\" is a symbolic link."));
    EXPECT_THAT(text, Not(HasSubstr("prof")));
    EXPECT_THAT(text, Not(HasSubstr("points**")));
}

TEST(Feedback, NamesNoFolderOfTheInstructorsWhereThereIsNoSource) {
    Graded bob = not_graded("bob");
    bob.submission.problem =
        "\"/home/prof/class/bob/\" holds no C++ source itself; there is one in \"/home/prof/class/bob/src\". Move it "
        "up.";
    EXPECT_THAT(feedback_markdown(bob, marking()),
                HasSubstr("`\"bob\" holds no C++ source itself; there is one in \"src\". Move it up.`"));
}

TEST(Feedback, HidesTheMachinesFailuresFromTheStudent) {
    Graded bob = not_graded("bob");
    bob.execution.explanation = "The disk of \"/srv/grading\" has less than 256 MiB left.";
    const std::string text = feedback_markdown(bob, marking());
    EXPECT_THAT(text, HasSubstr("not the program's fault"));
    EXPECT_THAT(text, Not(HasSubstr("/srv")));
}

TEST(CheckText, EndsWithThePointsOfASourceThatDoesNotCompileToo) {
    Graded one = graded("s01", "");
    one.execution.outcome = Outcome::compile_error;
    EXPECT_THAT(check_text(one), testing::EndsWith("\n0 of 100 points\n"));
}

TEST(CheckText, HasAVerdictForEveryItem) {
    const std::string text = check_text(graded("s01", output_with_a_mistake()));
    std::size_t rows = 0;
    for (std::size_t at = 0; (at = text.find("\n  ", at)) != std::string::npos; ++at)
        rows += text[at + 3] != ' ' ? 1 : 0;
    EXPECT_EQ(rows, reference::default_items().size());
    EXPECT_THAT(text, HasSubstr("98.33 of 100 points"));
}

TEST(CheckText, HasColourOnATerminalOnly) {
    const Graded one = graded("s01", output_with_a_mistake());
    const std::string text = check_text(one, reference::Feedback::mistake, Colors::terminal);
    EXPECT_THAT(text, HasSubstr("P_VCS         \x1b[32mright     \x1b[0m"));
    EXPECT_THAT(text, HasSubstr("\x1b[31mwrong     \x1b[0m"));
    EXPECT_THAT(check_text(one), Not(HasSubstr("\x1b")));
}

TEST(CheckText, ShowsNoControlBytes) {
    EXPECT_THAT(check_text(hostile()), Not(HasSubstr("\x1b")));
}

TEST(Feedback, ShowsOverridesWithTheirReasons) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.review.overrides = {{8, "", 3, "half copied", "bea", ""},
                            {6, "t", 1.5, "the right `idea`\x1b", "bea", ""},
                            {8, "", 4, "copied", "bea", ""}};
    const std::string text = feedback_markdown(zoe, marking());
    EXPECT_THAT(text, HasSubstr("**93.83 of 100 points**"));
    EXPECT_THAT(
        text,
        HasSubstr("- Your instructor gave 1.5 of 1.67 for question 6, t, in place of 0: ``the right `idea`\\x1b"));
    EXPECT_THAT(text, HasSubstr("- Your instructor gave 4 of 10 for question 8, in place of 10: `copied`"));
    EXPECT_THAT(text, Not(HasSubstr("half copied"))) << "a later one counts";
    EXPECT_THAT(text, HasSubstr("| 6 | ray and sphere | wrong | 9.83 of 10 |"));
    EXPECT_THAT(text, HasSubstr(" 0 of 1.67 points; your instructor gave 1.5.\n"));
    EXPECT_THAT(text, Not(HasSubstr("late")));
}

TEST(Feedback, NamesThePartOfAQuestion) {
    Graded one = graded("s01", output_with_a_mistake());
    EXPECT_THAT(feedback_markdown(one, marking()), Not(HasSubstr("Question 6 ")));
    for (ItemScore& item : one.score.questions[5].items) item.spec.part = 'b';
    EXPECT_THAT(feedback_markdown(one, marking()), HasSubstr("- Question 6 b), t (line "));
    EXPECT_THAT(check_text(one), HasSubstr("  b) t "));
}

TEST(Feedback, ShowsTheLateDeduction) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.late_share = 0.1;
    const std::string text = feedback_markdown(zoe, marking());
    EXPECT_THAT(text, HasSubstr("**88.5 of 100 points**"));
    EXPECT_THAT(text, HasSubstr("Handed in late: 9.83 of 98.33 points are taken off (10 %)."));
}

TEST(Feedback, ShowsTheInstructorsMarkOfAnUngradedSubmission) {
    Graded bob = not_graded("bob");
    bob.review.overrides = {{0, "", 40, "by hand", "bea", ""}};
    const std::string text = feedback_markdown(bob, marking());
    EXPECT_THAT(text, HasSubstr("**40 of 100 points**"));
    EXPECT_THAT(text, HasSubstr("- Your instructor gave 40 of 100 for the whole submission: `by hand`"));
    EXPECT_THAT(text, HasSubstr("**Not graded.**"));
}

}  // namespace
}  // namespace harness::report
