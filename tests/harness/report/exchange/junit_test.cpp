// Validates the file against a schema with xmllint, and reads it back with python3's XML parser.
#include "harness/report/exchange/junit.h"

#include <gmock/gmock.h>

#include "tests/given/report/graded_samples.h"
#include "tests/given/report/told_by.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::HasSubstr;

Graded broken() {
    Graded one = graded("broken", "");
    one.execution.outcome = Outcome::compile_error;
    one.execution.explanation = "The program does not compile.";
    one.execution.build.diagnostics = "ray_cast.cpp:19:1: error: expected ';' <T> & ]]>";
    return one;
}

Graded crashed() {
    Graded one = graded("crashed", output_with_a_mistake());
    one.execution.outcome = Outcome::crashed;
    one.execution.explanation = "The program was ended by SIGSEGV.";
    one.execution.build.wall = std::chrono::milliseconds(1500);
    one.execution.run.wall = std::chrono::milliseconds(20);
    one.submission.lms = read_canvas_name("crashed_LATE_1_2_ray_cast.cpp");
    return one;
}

/// The output of a Python program that has the root element as `r`. Fails unless the schema holds and the counts match
/// the test cases.
std::string told_of_junit(const std::vector<Graded>& graded, const std::string& program) {
    const std::string xml = junit(graded, marking());
    EXPECT_THAT(told_by("xmllint --noout --schema " RAYGRADE_PROJECT "/tests/given/report/junit.xsd \"$1\"", xml),
                HasSubstr("validates"));
    return python(
        "import xml.etree.ElementTree\n"
        "r = xml.etree.ElementTree.parse(sys.argv[1]).getroot()\n"
        "for e in [r] + r.findall('testsuite'):\n"
        "    n = lambda w: len(e.findall('.//' + w))\n"
        "    assert [n('testcase'), n('failure'), n('error'), n('skipped')] == \\\n"
        "        [int(e.get(w)) for w in ('tests', 'failures', 'errors', 'skipped')]\n"
        "    assert abs(sum(float(t.get('time')) for t in e.findall('.//testcase')) - float(e.get('time'))) < 1e-6\n"
        "case = lambda s, c, n: r.find(f'testsuite[@name=\"{s}\"]/testcase[@classname=\"{c}\"][@name=\"{n}\"]')\n" +
            program,
        xml);
}

TEST(Junit, HasATestSuitePerSubmissionAndATestCasePerAnswer) {
    EXPECT_EQ(told_of_junit({graded("ada", output_with_a_mistake()), crashed()},
                            "print([s.get('name') for s in r], r.get('tests'), r.get('failures'))\n"
                            "print([t.get('classname') + ' ' + t.get('name') for t in r[0].findall('testcase')][:4])\n"
                            "print({p.get('name'): p.get('value') for p in r[0][0]})\n"
                            "print({p.get('name'): p.get('value') for p in r[1][0]})\n"),
              "['ada', 'crashed'] 48 3\n"
              "['ada compiles', 'ada runs', 'ada.question 1 P_VCS', 'ada.question 2 X_vcs']\n"
              "{'points': '98.33', 'max_points': '100.00', 'outcome': 'graded'}\n"
              "{'points': '98.33', 'max_points': '100.00', 'outcome': 'crashed', 'late': 'true'}\n");
}

TEST(Junit, SaysWhyAnAnswerFailsAndWhichFollow) {
    const std::string text =
        told_of_junit({graded("ada", output_with_a_mistake())},
                      "f = case('ada', 'ada.question 6', 't')[0]\n"
                      "print(f.tag, f.get('message'))\nprint(f.text)\n"
                      "print(case('ada', 'ada.question 6', 'hit')[0].tag, len(case('ada', 'ada.question 6', 'a')))\n");
    EXPECT_THAT(text, HasSubstr("failure "));
    EXPECT_THAT(text, HasSubstr("t: wrong, 0 of 1.67 points (line "));
    EXPECT_THAT(text, HasSubstr("far root"));
    EXPECT_THAT(text, HasSubstr("system-out 0\n"))
        << "an answer that follows passes with a word; a right one needs none";
    EXPECT_THAT(text, testing::Not(HasSubstr("Right value")));
}

TEST(Junit, FailsAProgramThatDidNotEndByItself) {
    EXPECT_EQ(told_of_junit({crashed()},
                            "c = case('crashed', 'crashed', 'runs')\n"
                            "print(c[0].tag, c[0].get('message'), c.get('time'))\n"
                            "print(len(case('crashed', 'crashed', 'compiles')))\n"),
              "failure The program was ended by SIGSEGV. 0.020\n0\n");
}

TEST(Junit, SkipsTheAnswersAfterACompileError) {
    EXPECT_EQ(told_of_junit({broken()},
                            "f = case('broken', 'broken', 'compiles')[0]\n"
                            "print(f.tag, f.get('message'), f.text.splitlines()[-1])\n"
                            "print(r.get('tests'), r.get('failures'), r.get('skipped'), r.get('errors'))\n"
                            "print(r[0][0][0].get('value'))\n"),
              "failure The program does not compile. ray_cast.cpp:19:1: error: expected ';' <T> & ]]>\n"
              "24 1 23 0\n0.00\n");
}

TEST(Junit, ReportsAnUngradedSubmissionAsAnError) {
    EXPECT_EQ(told_of_junit({not_graded("eve")},
                            "t = r[0].findall('testcase')\n"
                            "print(len(t), t[0].get('name'), t[0][0].tag, t[0][0].get('message'))\n"
                            "print([p.get('name') for p in r[0][0]])\n"),
              "1 is graded error The folder holds two sources; `keep` one.\n['max_points', 'outcome']\n");
    Graded given = not_graded("eve");
    given.review.overrides = {{0, "", 80, "read by hand", "ada", ""}};
    EXPECT_EQ(
        told_of_junit({given}, "print(r.get('errors'), r[0][0][0].get('value'), 'read by hand' in r[0][1][0].text)\n"),
        "0 80.00 True\n");
}

TEST(Junit, AppliesOverrides) {
    Graded one = graded("ada", output_with_a_mistake());
    one.review.overrides = {{6, "t", 5.0 / 3, "right idea", "ada", ""}, {10, "", 0, "guessed", "ada", ""}};
    EXPECT_EQ(told_of_junit({one},
                            "c = case('ada', 'ada.question 6', 't')[0]\nprint(c.tag, 'right idea' in c.text)\n"
                            "c = case('ada', 'ada.question 10', 'verdict')[0]\nprint(c.tag, 'guessed' in c.text)\n"
                            "print(r[0][0][0].get('value'))\n"),
              "system-out True\nfailure True\n90.00\n");
}

TEST(Junit, SaysLateOnlyIfTheSystemSaidSo) {
    Graded one = graded("ada", output_with_a_mistake());
    one.submission.lms = read_canvas_name("doe_1_2_ray_cast.cpp");
    Graded untold = one;
    untold.submission.lms->late = std::nullopt;
    EXPECT_EQ(
        told_of_junit({one, untold}, "print([{p.get('name'): p.get('value') for p in s[0]}.get('late') for s in r])\n"),
        "['false', None]\n");
}

TEST(Junit, HasATestCaseForVariantsIfTheyGivePoints) {
    Graded all = graded_on_variants("all");
    all.review.overrides = {{0, "variants", 10, "it works", "bea", ""}};
    Graded none = broken();
    none.score.variants = ScenesScore{0, 10};
    EXPECT_EQ(told_of_junit({graded_on_variants("some"), all, none},
                            "cases = [case(s, s, 'other scenes') for s in ('some', 'all', 'broken')]\n"
                            "print([[(e.tag, e.get('message')) for e in c] for c in cases])\n"),
              "[[('failure', 'Other scenes: 6 of 10 points.')], [], [('skipped', 'The program does not compile.')]]\n");
}

TEST(Junit, EscapesHostileText) {
    Graded evil = hostile();
    evil.execution.explanation = "\x1b[31m\xEF\xBF\xBE\xEF\xBF\xBF\xff <!-- ]]> &amp;";
    evil.execution.outcome = Outcome::crashed;
    EXPECT_EQ(
        told_of_junit({evil}, "print(r[0].get('name'))\nprint(ascii(r[0].findall('testcase')[1][0].get('message')))\n"),
        "=HYPERLINK(\"x\"),|`id`\n'\\\\x1b[31m\\\\ufffe\\\\uffff\\\\xff <!-- ]]> &amp;'\n");
}

TEST(Junit, IsAReportForAnEmptyClass) {
    EXPECT_EQ(told_of_junit({}, "print(r.tag, len(r), r.get('tests'))\n"), "testsuites 0 0\n");
}

}  // namespace
}  // namespace harness::report
