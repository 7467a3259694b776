// Validates the file against a schema with xmllint, and reads it back with python3's XML parser.
#include "harness/report/exchange/junit.h"

#include <gmock/gmock.h>

#include "tests/given/golden.h"
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

/// The output of a Python program that has the root element as `r`. Fails unless the schema holds and the counts match
/// the test cases.
std::string told_of_junit(const Graded& graded, const std::string& program) {
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

TEST(Junit, IsAsInTheGoldenFile) {
    EXPECT_EQ(told_of_junit(telling_class().front(), ""), "");
    EXPECT_TRUE(is_golden(junit(telling_class().front(), marking()), "junit.xml"));
}

TEST(Junit, SkipsTheAnswersAfterACompileError) {
    EXPECT_EQ(told_of_junit(broken(),
                            "f = case('broken', 'broken', 'compiles')[0]\n"
                            "print(f.tag, f.get('message'), f.text.splitlines()[-1])\n"
                            "print(r.get('tests'), r.get('failures'), r.get('skipped'), r.get('errors'))\n"
                            "print(r[0][0][0].get('value'))\n"),
              "failure The program does not compile. ray_cast.cpp:19:1: error: expected ';' <T> & ]]>\n"
              "24 1 23 0\n0.00\n");
}

TEST(Junit, EscapesHostileText) {
    Graded evil = hostile();
    evil.execution.explanation = "\x1b[31m\xEF\xBF\xBE\xEF\xBF\xBF\xff <!-- ]]> &amp;";
    evil.execution.outcome = Outcome::crashed;
    EXPECT_EQ(
        told_of_junit(evil, "print(r[0].get('name'))\nprint(ascii(r[0].findall('testcase')[1][0].get('message')))\n"),
        "=HYPERLINK(\"x\"),|`id`\n'\\\\x1b[31m\\\\ufffe\\\\uffff\\\\xff <!-- ]]> &amp;'\n");
}

}  // namespace
}  // namespace harness::report
