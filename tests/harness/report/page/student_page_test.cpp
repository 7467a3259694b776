#include "harness/report/page/student_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/record/marking.h"
#include "harness/report/text/feedback.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/read_page.h"
#include "tests/given/student/printout.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string text_of(const Graded& one, const Marking& how = marking()) {
    return read_page(student_page(one, how)).at("text");
}

TEST(StudentPage, ParsesWithoutErrors) {
    Graded one = graded("s01", output_with_a_mistake());
    one.execution.build.diagnostics = "ray_cast.cpp:3:5: warning: unused variable 'x' [-Wunused-variable]\n";
    for (const Graded& each : {one, hostile(), not_graded("bob"), graded("nil", "")}) {
        const std::string page = student_page(each, marking());
        EXPECT_THAT(read_page(page).at("problems"), IsEmpty()) << each.submission.id;
        EXPECT_EQ(xml_problems(page), "") << each.submission.id;
    }
}

TEST(StudentPage, HasNoScript) {
    const json page = read_page(student_page(hostile(), marking()));
    EXPECT_FALSE(page.at("counts").contains("script"));
    EXPECT_THAT(page.at("policy"), Not(HasSubstr("script-src")));
}

TEST(StudentPage, ShowsVerdictsTheMistakeAndWhereToBegin) {
    const std::string text = text_of(graded("s01", output_with_a_mistake()));
    EXPECT_THAT(text, HasSubstr("98.33 of 100 points"));
    EXPECT_THAT(text, HasSubstr("Look at question 6 first: it is the only one with a wrong answer."));
    EXPECT_THAT(text, HasSubstr("look here first"));
    EXPECT_THAT(text, HasSubstr("far root of the quadratic; the smaller positive root is asked for. far root"));
    EXPECT_THAT(
        text, HasSubstr("This step is correct for the values you had; fix question 6 and this one will be right too."));
    EXPECT_THAT(text, HasSubstr("1✓, pixel in VCS: right, 10 of 10 points"));
}

TEST(StudentPage, CallsTheStudentOnceByName) {
    Graded one = graded("rossigiulia", output_with_a_mistake());
    one.submission.lms = read_canvas_name("rossigiulia_40119_900221_ray_cast.cpp");
    one.submission.file = "rossigiulia_40119_900221_ray_cast.cpp";
    EXPECT_THAT(text_of(one), HasSubstr("rossigiulia, ray_cast.cpp 98.33"));
    one.submission.name = "Rossi, Giulia";
    EXPECT_THAT(text_of(one), AllOf(HasSubstr("Rossi, Giulia, ray_cast.cpp 98.33"), Not(HasSubstr("rossigiulia"))));
}

TEST(StudentPage, SaysOfACrashWhereItWasAndOnceWhatIsMissing) {
    Graded one = graded("s01", output_with_a_mistake());
    one.execution.outcome = Outcome::crashed;
    one.execution.run.ended = Ended::signalled;
    one.execution.explanation = "The program crashed (SIGSEGV). It ended after line 2 of its output.";
    one.execution.printout = "Question 1:\nP\n";
    for (int question : {6, 7, 8, 9}) {
        one.score.questions[question].verdict = ItemVerdict::missing;
        for (ItemScore& item : one.score.questions[question].items) item.verdict = ItemVerdict::missing;
    }
    const std::string page = student_page(one, marking());
    const std::string text = read_page(page).at("text");
    EXPECT_THAT(read_page(page).at("problems"), IsEmpty());
    EXPECT_THAT(page, HasSubstr("It ended after <a href=\"#o2\">line 2</a> of its output."));
    EXPECT_THAT(text, HasSubstr("To see at which line: raygrade check --sanitize ray_cast.cpp"));
    EXPECT_LT(text.find("It ended after line 2"), text.find("Then look at question 6"));
    EXPECT_THAT(text, HasSubstr("Not printed before the program ended: questions 7 to 10."));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("Not found in what")), Not(HasSubstr("look here first"))));
    EXPECT_THAT(page, HasSubstr("<li class=\"missing\"><a href=\"#missing\">"));
    EXPECT_THAT(page, Not(HasSubstr("id=\"q8\"")));
}

TEST(StudentPage, ShowsTheNewMarkOfAnOverrideAndTheOldOneSmall) {
    Graded one = graded("s01", wrong_everywhere());
    one.review.overrides = {{10, "", 5, "half an idea", "prof", ""}, {6, "t", 1, "so", "prof", ""}};
    const std::string page = student_page(one, marking());
    EXPECT_THAT(page, HasSubstr("<li class=\"set\"><a href=\"#q10\">"));
    EXPECT_THAT(page, HasSubstr(">5 of 10 points <s class=\"old\">0</s></span></h2>"));
    EXPECT_THAT(page, HasSubstr(">1 of 1.67, set by your instructor <s class=\"old\">0</s></span>"));
    const std::string section = page.substr(page.find("id=\"q10\""));
    EXPECT_THAT(section, Not(HasSubstr("0 of 10"))) << "the item's old points";
    EXPECT_THAT(section.substr(0, section.find("</p>")), HasSubstr("points set by your instructor"));
}

TEST(StudentPage, SaysInOneLineWhatWasAccepted) {
    Graded one = graded("s01", print(student::Program(marking().assignment, {})));
    for (QuestionScore& question : one.score.questions)
        for (ItemScore& item : question.items) item.accepted_as = "the grid pixel convention";
    const std::string text = text_of(one);
    EXPECT_EQ(text.find("the grid pixel convention"), text.rfind("the grid pixel convention"));
    EXPECT_THAT(text, AllOf(HasSubstr("Accepted: the grid pixel convention (1.P_VCS"), Not(HasSubstr("You printed"))));
}

TEST(StudentPage, TellsNoMoreThanTheRubricLetsBeTold) {
    Marking strict = marking();
    strict.assignment.rubric.feedback = reference::Feedback::verdict;
    const Graded one = graded("s01", output_with_a_mistake());
    EXPECT_THAT(text_of(one, strict), AllOf(HasSubstr("That is not the right value."), Not(HasSubstr("far root"))));
    for (const std::string& text : {feedback_markdown(one, strict), check_text(one, reference::Feedback::hint)})
        EXPECT_THAT(text, Not(HasSubstr("far root")));
    EXPECT_THAT(check_text(one), HasSubstr("far root"));
}

TEST(StudentPage, IsShortForARightProgram) {
    const std::string text = text_of(graded("s01", print(student::Program(marking().assignment, {}))));
    EXPECT_THAT(text, HasSubstr("100 of 100 points"));
    EXPECT_THAT(text, HasSubstr("Every answer is right."));
    EXPECT_THAT(text, Not(HasSubstr("You printed")));
}

TEST(StudentPage, ShowsOnlyTheLimitIfNothingWasPrinted) {
    Graded one = graded("nil", "");
    one.execution.outcome = Outcome::timed_out;
    one.execution.explanation = "Time limit: the program was stopped.";
    const std::string text = text_of(one);
    EXPECT_THAT(text, HasSubstr("Time limit: the program was stopped. By question"));
    EXPECT_THAT(text, Not(HasSubstr("No answer was found")));
    EXPECT_THAT(text, Not(HasSubstr("Look at question")));
    EXPECT_THAT(text_of(graded("nil", "The pixel is nice.\n")), HasSubstr("No answer was found"));
}

TEST(StudentPage, SaysAllRightOnlyForAllPoints) {
    Graded one = graded("s01", print(student::Program(marking().assignment, {})));
    one.score.questions[6].items[0].verdict = ItemVerdict::follow;
    one.score.points -= 5;
    EXPECT_THAT(text_of(one), Not(HasSubstr("Every answer is right.")));
}

TEST(StudentPage, SaysOnceThatAnAnswerFollowsAndItsSourceIfKnown) {
    const std::string sentence = "Not the right value, but it follows correctly";
    Graded one = graded("s01", output_with_a_mistake());
    const std::string text = text_of(one);
    EXPECT_EQ(text.find(sentence), text.rfind(sentence)) << "of 6.hit; question 7 has a note";
    EXPECT_THAT(text, HasSubstr(sentence));
    one.score.questions[0].items[0].verdict = ItemVerdict::wrong;
    EXPECT_THAT(text_of(one), HasSubstr("fix the earlier answers and this one will be right too."));
    EXPECT_THAT(text_of(one), Not(HasSubstr("fix question")));
}

TEST(StudentPage, NeverShowsAnExpectedValue) {
    const std::vector<std::string> traces = traces_of_key();
    ASSERT_GT(traces.size(), 30U);
    Graded one = graded("s01", wrong_everywhere());
    one.findings.flags = {{"nondeterministic", "Question 1: run 1 printed 1"}};
    one.findings.variants = broken_on_a_variant(traces[0], traces[1]);
    const std::string page = student_page(one, marking());
    EXPECT_THAT(page, HasSubstr("no longer right: 6.t."));
    for (const std::string& trace : traces) EXPECT_THAT(page, Not(HasSubstr(trace)));
    EXPECT_THAT(page, Not(HasSubstr("sphere first")));
}

TEST(StudentPage, ShowsExpectedValuesIfTheRubricAllowsIt) {
    Marking open = marking();
    open.assignment.rubric.feedback = reference::Feedback::expected;
    const std::string page = student_page(graded("s01", wrong_everywhere()), open);
    std::size_t found = 0;
    const std::vector<std::string> traces = traces_of_key();
    for (const std::string& trace : traces) found += page.find(trace) != std::string::npos ? 1 : 0;
    EXPECT_GT(found, traces.size() / 2) << "six significant digits of the canonical value hold most traces";
    EXPECT_THAT(page, HasSubstr("Right value: "));
}

TEST(StudentPage, ShowsHostileTextAsText) {
    Graded one = hostile();
    one.submission.id = "<script>alert(1)</script>&amp;";
    one.score.questions[5].items[4].printed = "\"><img src=x onerror=alert(1)> {{points}} {{{style}}}";
    one.execution.build.diagnostics = "ray_cast.cpp:1:1: error: </pre><b>x\x1b[2J\xff\n";
    const std::string page = student_page(one, marking());
    const json read = read_page(page);
    EXPECT_THAT(read.at("problems"), IsEmpty());
    EXPECT_THAT(read.at("text"), HasSubstr("<script>alert(1)</script>&amp;"));
    EXPECT_THAT(read.at("text"), HasSubstr("\"><img src=x onerror=alert(1)> {{points}} {{{style}}}"));
    EXPECT_THAT(read.at("text"), HasSubstr("</pre><b>x\\x1b[2J\\xff"));
    EXPECT_FALSE(read.at("counts").contains("img"));
    EXPECT_FALSE(read.at("counts").contains("b"));
}

TEST(StudentPage, ShowsAllMarkupAsText) {
    Marking titled = marking();
    titled.assignment.title = markup(0);
    Graded ungraded = not_graded("bob");
    ungraded.submission.problem = markup(last_markup + 1);
    const std::string page = student_page(markup_everywhere(), titled);
    const std::string of_ungraded = student_page(ungraded, titled);
    EXPECT_EQ(xml_problems(page), "");
    for (const json& read : {read_page(page), read_page(of_ungraded)}) {
        EXPECT_THAT(read.at("problems"), IsEmpty()) << read.at("problems");
        EXPECT_FALSE(read.at("counts").contains("b")) << read.at("counts");
    }
    const std::string text = read_page(page).at("text");
    for (int n = 0; n < first_for_instructor; ++n) {
        if (n == 1) continue;         // the id, where there is a name
        const bool is_name = n == 3;  // a file name, so the slash is missing
        EXPECT_THAT(text, HasSubstr(is_name ? "<b>mark 3<" : markup(n))) << n;
    }
    for (int n = first_for_instructor; n <= last_markup; ++n) EXPECT_THAT(text, Not(HasSubstr(markup(n)))) << n;
    // Up to the slash of what looks like a path in quotes.
    EXPECT_THAT(read_page(of_ungraded).at("text"), HasSubstr("Not graded. \"b>&amp;"));
}

TEST(StudentPage, NamesTheLinesOfCompilerMessages) {
    Graded one = graded("mateo", "");
    one.execution.outcome = Outcome::compile_error;
    one.execution.explanation = "The source does not compile.";
    one.execution.build.diagnostics =
        "ray_cast.cpp:7:3: warning: unused\nray_cast.cpp: In function 'int main()':\nray_cast.cpp:19:24: error: "
        "expected ';'\n";
    const std::string text = text_of(one);
    EXPECT_THAT(text, HasSubstr("The source does not compile. The compiler’s messages Line 19 error expected ';'"));
    EXPECT_THAT(text, HasSubstr("Line 7 warning unused"));
    EXPECT_THAT(text, Not(HasSubstr("By question")));
}

TEST(StudentPage, AppliesOverridesAndTheLateDeduction) {
    Graded one = graded("s01", output_with_a_mistake());
    one.review.overrides = {{6, "t", 0.5, "half right", "prof", "2026-11-22T09:20:00Z"},
                            {6, "t", 1, "a good <idea>", "prof", "2026-11-22T09:30:00Z"}};
    one.late_share = 0.1;
    const std::string text = text_of(one);
    EXPECT_THAT(text, Not(HasSubstr("half right"))) << "a later one counts";
    EXPECT_THAT(text, HasSubstr("89.4 of 100 points"));
    EXPECT_THAT(text, HasSubstr("Your instructor gave 1 points for question 6, t: a good <idea>"));
    EXPECT_THAT(text, HasSubstr("Handed in late: 9.93 points are taken off."));
    EXPECT_THAT(text, HasSubstr("9.33 of 10 points"));
    EXPECT_THAT(text, Not(HasSubstr("prof")));
}

TEST(StudentPage, NamesThePartOfAQuestion) {
    Graded one = graded("s01", output_with_a_mistake());
    for (ItemScore& item : one.score.questions[5].items) item.spec.part = 'b';
    EXPECT_THAT(text_of(one), AllOf(HasSubstr("b) t"), HasSubstr("Right: b) a, b) b")));
}

TEST(StudentPage, ShowsVariantsAndWhetherTheyCount) {
    Graded one = graded("s01", output_with_a_mistake());
    one.findings.variants = broken_on_a_variant("1.25", "1.5");
    EXPECT_THAT(text_of(one), HasSubstr("On other scenesThis costs no points. The program was also run"));
    one = graded_on_variants("s01");
    one.findings.variants = broken_on_a_variant("1.25", "1.5");
    EXPECT_THAT(text_of(one), HasSubstr("On other scenesOther scenes: 6 of 10 points. The program was also run"));
}

TEST(StudentPage, CountsPointsForVariants) {
    Graded one = graded_on_variants("s01");
    EXPECT_THAT(text_of(one), HasSubstr("104.33 of 110 points"));
    EXPECT_THAT(text_of(one), HasSubstr("Other scenes: 6 of 10 points."));
    one.review.overrides = {{0, "variants", 9, "it works", "prof", ""}};
    EXPECT_THAT(text_of(one), HasSubstr("107.33 of 110 points"));
    EXPECT_THAT(text_of(one), HasSubstr("Other scenes: 9 of 10 points."));
    EXPECT_THAT(text_of(one), HasSubstr("Your instructor gave 9 points for the other scenes: it works"));
}

TEST(StudentPage, OmitsOverridesThatCountNowhere) {
    Graded one = graded("s01", output_with_a_mistake());
    one.review.overrides = {{0, "variants", 5, "of an earlier rubric", "prof", ""}};
    EXPECT_THAT(text_of(one), AllOf(HasSubstr("98.33 of 100 points"), Not(HasSubstr("Your instructor gave"))));
}

TEST(StudentPage, SaysWhyThereAreNoMarksWithoutTheInstructorsPath) {
    Graded bob = not_graded("bob");
    bob.submission.file = "/home/prof/class/bob/ray_cast.cpp";
    bob.submission.problem = "\"/home/prof/class/bob/ray_cast.cpp\" is a symbolic link.";
    bob.execution.explanation = "The disk of \"/home/prof\" is full.";
    const std::string page = student_page(bob, marking());
    EXPECT_THAT(read_page(page).at("text"), HasSubstr("Not graded. \"ray_cast.cpp\" is a symbolic link."));
    EXPECT_THAT(page, Not(HasSubstr("prof")));
    EXPECT_THAT(page, Not(HasSubstr("of 100 points")));
}

TEST(StudentPages, DoNotDependOnTheNumberOfMakers) {
    StudentPages pages(marking());
    const Graded one = graded("s01", output_with_a_mistake());
    const std::string first = pages.page(one);
    pages.page(hostile());
    EXPECT_EQ(pages.page(one), first);
    EXPECT_EQ(student_page(one, marking()), first);
}

}  // namespace
}  // namespace harness::report
