// Reads the file back with python3's json.
#include "harness/report/exchange/gradescope_results.h"

#include <gmock/gmock.h>

#include "harness/record/marking.h"
#include "reference/key/key_formats.h"
#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/told_by.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::HasSubstr;
using testing::Not;

/// The file is then `d`, and `texts` what students read in it. tests/checks/gradescope_autograder has the schema.
constexpr const char* read_results = R"(
d = json.load(open(sys.argv[1], encoding='utf-8'))
texts = [d['output']] + [t['output'] for t in d.get('tests', [])]
assert sum(map(len, texts)) < 100000
assert not any(c < ' ' and c not in '\n\t' for t in texts for c in t)
)";

std::string told_of_gradescope(const Graded& graded, const std::string& program, const Marking& by = marking()) {
    return python(read_results + program, gradescope_results(graded, by));
}

TEST(Gradescope, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(gradescope_results(telling_class().front(), marking()), "gradescope.json"));
}

TEST(Gradescope, ShowsPrintedAnswersAndNeverRightOnes) {
    const std::string output =
        told_of_gradescope(graded("ada", output_with_a_mistake()), "print(d['tests'][5]['output'])\n");
    EXPECT_THAT(output, HasSubstr("t: wrong, 0 of 1.67 points (line "));
    EXPECT_THAT(output, HasSubstr("  You printed "));
    EXPECT_THAT(output, HasSubstr("far root"));
    EXPECT_THAT(output, Not(HasSubstr("Correct value")));

    Marking open = marking();
    open.assignment.rubric.feedback = reference::Feedback::expected;
    const std::string shown =
        told_of_gradescope(graded("ada", output_with_a_mistake()), "print(d['tests'][5]['output'])\n", open);
    const std::string right =
        value_text(open.key.questions[5].items[4].answers.front().value, reference::Shape::scalar);
    EXPECT_THAT(shown, HasSubstr("  Correct value: " + right + "\n"));
    EXPECT_THAT(output, Not(HasSubstr(right)));
}

TEST(Gradescope, GivesZeroAndTheMessagesForACompileError) {
    Graded broken = graded("ada", "");
    broken.execution.outcome = Outcome::compile_error;
    broken.execution.explanation = "The program does not compile.";
    broken.execution.build.diagnostics = "ray_cast.cpp:19:1: error: expected ';'";
    EXPECT_EQ(told_of_gradescope(
                  broken,
                  "print(d['score'], [t['score'] for t in d['tests']] == [0] * 10, {t['status'] for t in d['tests']})\n"
                  "print(d['output'])\n"),
              "0.0 True {'failed'}\n"
              "0 of 100 points\nThe program does not compile.\n\nMessages from the compiler:\n"
              "ray_cast.cpp:19:1: error: expected ';'\n\n");
}

TEST(Gradescope, GivesNoScoreToAnUngradedSubmission) {
    EXPECT_EQ(told_of_gradescope(not_graded("ada"),
                                 "print('score' in d, 'tests' in d, d['extra_data']['outcome'])\n"
                                 "print(d['output'])\n"),
              "False False not_graded\nNot graded.\nThe folder holds two sources; `keep` one.\n\n");
    Graded given = not_graded("ada");
    given.review.overrides = {{0, "", 80, "read by hand", "ada", ""}};
    EXPECT_EQ(told_of_gradescope(given, "print(d['score'], 'tests' in d)\n"), "80.0 False\n");
}

TEST(Gradescope, SaysLateOnlyIfTheSystemSaidSo) {
    Graded one = graded("ada", output_with_a_mistake());
    EXPECT_EQ(told_of_gradescope(one, "print('late' in d['extra_data'])\n"), "False\n");
    one.submission.lms = read_canvas_name("doe_1_2_ray_cast.cpp");
    EXPECT_EQ(told_of_gradescope(one, "print(d['extra_data']['late'])\n"), "False\n");
    one.submission.lms->late = std::nullopt;
    EXPECT_EQ(told_of_gradescope(one, "print('late' in d['extra_data'])\n"), "False\n");
}

TEST(Gradescope, GivesOtherScenesTheirOwnNumber) {
    Graded one = graded_on_variants("ada");
    one.score.questions.back().number = 11;
    EXPECT_EQ(told_of_gradescope(one, "print([t['number'] for t in d['tests']][-2:])\n"), "['11', '12']\n");
}

TEST(Gradescope, IsBoundedHoweverManyQuestionsThereAre) {
    Graded one = graded_on_variants("ada");
    one.execution.outcome = Outcome::compile_error;
    one.execution.build.diagnostics = std::string(300'000, 'x');
    QuestionScore longest = one.score.questions.back();
    for (ItemScore& item : longest.items) {
        item.verdict = ItemVerdict::wrong;
        item.advice = std::string(5'000, 'a');
    }
    for (int number = 11; number <= 99; ++number) {
        one.score.questions.push_back(longest);
        one.score.questions.back().number = number;
    }
    EXPECT_EQ(told_of_gradescope(one, "print(sum(map(len, texts)) > 80000, len(d['tests'][98]['output']) > 400)\n"),
              "True True\n");
}

TEST(Gradescope, IsBoundedAndSafeForHostileText) {
    Graded one = hostile();
    one.execution.build.diagnostics = "é\x1b" + std::string(300'000, '\xff');
    for (QuestionScore& question : one.score.questions) {
        for (ItemScore& item : question.items) {
            item.verdict = ItemVerdict::wrong;
            item.printed = std::string(200, '\x01');
            item.advice = std::string(3'000, 'a');
        }
    }
    EXPECT_EQ(told_of_gradescope(one, "print(d['output'].endswith('(cut here)\\n'), len(d['output']) > 30000)\n"),
              "True True\n");
}

TEST(Gradescope, HasItsMarkBeforeAnyTextOfTheStudent) {
    Graded broken = graded("ada", "");
    broken.execution.outcome = Outcome::compile_error;
    broken.execution.build.diagnostics = std::string(5'000, 'x');
    for (const std::string& json :
         {gradescope_results(broken, marking()), gradescope_without_score(std::string(5'000, 'x'))})
        EXPECT_LT(json.find(gradescope_mark), 1'000U);
}

}  // namespace
}  // namespace harness::report
