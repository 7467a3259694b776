#include "harness/report/page/student_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/record/marking.h"
#include "harness/report/text/feedback.h"
#include "tests/given/golden.h"
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

TEST(StudentPage, IsAsInTheGoldenFiles) {
    for (const Graded& one : telling_class()) {
        const std::string page = student_page(one, marking());
        EXPECT_THAT(read_page(page).at("problems"), IsEmpty()) << one.submission.id;
        EXPECT_EQ(xml_problems(page), "") << one.submission.id;
        EXPECT_TRUE(is_golden(bare(page), fmt::format("student_{}.html", one.submission.id)));
    }
}

TEST(StudentPage, HasNoScript) {
    const json page = read_page(student_page(hostile(), marking()));
    EXPECT_FALSE(page.at("counts").contains("script"));
    EXPECT_THAT(page.at("policy"), Not(HasSubstr("script-src")));
}

TEST(StudentPage, RevealsNoMoreThanTheRubricAllows) {
    Marking strict = marking();
    strict.assignment.rubric.feedback = reference::Feedback::verdict;
    const Graded one = graded("s01", output_with_a_mistake());
    EXPECT_THAT(text_of(one, strict), AllOf(HasSubstr("That is not the right value."), Not(HasSubstr("far root"))));
    for (const std::string& text : {feedback_markdown(one, strict), check_text(one, reference::Feedback::hint)})
        EXPECT_THAT(text, Not(HasSubstr("far root")));
    EXPECT_THAT(check_text(one), HasSubstr("far root"));
}

TEST(StudentPage, SaysWhatOtherScenesShowOfAQuestionThatLostPoints) {
    Graded one = graded("s01", output_with_a_mistake());
    for (ItemScore& item : one.score.questions[5].items)
        item.experiment = fmt::format("Line 9 was read as {} because it changes so.", item.spec.name);
    const std::string text = text_of(one);
    for (const ItemScore& item : one.score.questions[5].items) EXPECT_THAT(text, HasSubstr(item.experiment));
}

TEST(StudentPage, ShowsOnlyTheLimitIfNothingWasPrinted) {
    Graded one = graded("nil", "");
    one.execution.outcome = Outcome::timed_out;
    one.execution.explanation = "Time limit: the program was stopped.";
    const std::string text = text_of(one);
    EXPECT_THAT(text, HasSubstr("Time limit: the program was stopped. By question"));
    EXPECT_THAT(text, Not(HasSubstr("No answer was found")));
    EXPECT_THAT(text, Not(HasSubstr("Start with question")));
    EXPECT_THAT(text_of(graded("nil", "The pixel is nice.\n")), HasSubstr("No answer was found"));
}

TEST(StudentPage, SaysAllRightOnlyForAllPoints) {
    Graded one = graded("s01", print(student::Program(marking().assignment, {})));
    one.score.questions[6].items[0].verdict = ItemVerdict::follow;
    one.score.points -= 5;
    EXPECT_THAT(text_of(one), Not(HasSubstr("Every answer is right.")));
}

TEST(StudentPage, NeverShowsAnExpectedValue) {
    const std::vector<std::string> traces = traces_of_key();
    ASSERT_GT(traces.size(), 30U);
    Graded one = graded("s01", wrong_everywhere());
    one.findings.flags = {{"nondeterministic", "Question 1: run 1 printed 1"}};
    one.findings.variants = broken_on_a_variant(traces[0], traces[1]);
    const std::string page = student_page(one, marking());
    EXPECT_THAT(page, HasSubstr("no longer right: question 6 (t)."));
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
    EXPECT_THAT(page, HasSubstr("Correct value: "));
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
    EXPECT_THAT(read_page(of_ungraded).at("text"), HasSubstr("Not graded. \"'><b>mark 20<"));
}

TEST(StudentPage, OmitsOverridesThatCountNowhere) {
    Graded one = graded("s01", output_with_a_mistake());
    one.review.overrides = {{0, "variants", 5, "of an earlier rubric", "prof", ""}};
    EXPECT_THAT(text_of(one), AllOf(HasSubstr("98.33 of 100 points"), Not(HasSubstr("Your instructor gave"))));
}

}  // namespace
}  // namespace harness::report
