// Reads the file back with python3's json, and checks it against what the runner and the collector of Classroom 50
// accept.
#include "harness/report/exchange/classroom50.h"

#include <gmock/gmock.h>

#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/told_by.h"

namespace harness::report {
namespace {

using namespace report_samples;

/// The contract of classroom50/result/v1. The runner adds owner and assignment_type if they are missing.
constexpr const char* read_result = R"(
import re
d = json.load(open(sys.argv[1], encoding='utf-8'))
must = {'schema', 'classroom', 'assignment', 'submission', 'commit', 'release', 'review', 'datetime', 'score',
        'max-score', 'tests'}
may = {'assignment_type', 'owner', 'graded_at', 'submitted_by'}
assert must <= set(d) <= must | may, set(d) ^ must
assert d['schema'] == 'classroom50/result/v1' and d['submission'].startswith('submit/')
assert all(isinstance(d[k], str) and d[k] for k in must - {'score', 'max-score', 'tests'})
assert re.fullmatch(r'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ', d['datetime'])
for t in [d] + d['tests']:
    assert type(t['score']) is int and type(t['max-score']) is int and 0 <= t['score'] <= t['max-score']
for t in d['tests']:
    assert isinstance(t['test-name'], str) and t['test-name'] and type(t['passed']) is bool
)";

const Classroom50Submission submission{"cs770",
                                       "ray-casting",
                                       "submit/2026-06-01T14-32-05Z-a1b2c3d",
                                       "https://github.com/o/r/commit/a1",
                                       "https://github.com/o/r/releases/tag/s",
                                       "https://github.com/o/r/compare/a0...a1",
                                       "alice",
                                       "individual",
                                       "2026-11-22T09:30:00Z"};

std::string told_of_classroom50(const Graded& graded, const std::string& program,
                                const Classroom50Submission& of = submission) {
    return python(read_result + program, classroom50_result(graded, marking(), of));
}

TEST(Classroom50, IsAsInTheGoldenFile) {
    EXPECT_EQ(told_of_classroom50(telling_class().front(), ""), "") << "as the contract demands";
    EXPECT_TRUE(is_golden(classroom50_result(telling_class().front(), marking(), submission), "classroom50.json"));
}

TEST(Classroom50, LeavesUnknownFieldsToTheRunner) {
    Classroom50Submission short_ = submission;
    short_.owner = short_.assignment_type = "";
    EXPECT_EQ(told_of_classroom50(graded("ada", output_with_a_mistake()),
                                  "print('owner' in d, 'assignment_type' in d)\n", short_),
              "False False\n");
}

TEST(Classroom50, HasWholePointsThatAddUp) {
    Graded one = graded("ada", output_with_a_mistake());
    // 10 x 8.3333 is 83.33: each question rounded by itself would be 80.
    for (QuestionScore& question : one.score.questions)
        one.review.overrides.push_back({question.number, "", 25.0 / 3, "for the test", "ada", ""});
    EXPECT_EQ(told_of_classroom50(
                  one,
                  "print(d['score'], sum(t['score'] for t in d['tests']), sum(t['max-score'] for t in d['tests']))\n"
                  "print({t['points'] for t in d['tests']}, {t['passed'] for t in d['tests']})\n"),
              "83 83 100\n{8.33} {False}\n");
}

TEST(Classroom50, NeverExceedsTheMaximum) {
    Graded one = graded("ada", output_with_a_mistake());
    one.review.overrides = {{6, "", 14, "a good idea", "ada", ""}};
    EXPECT_EQ(told_of_classroom50(
                  one, "print(d['score'], d['tests'][5]['score'], d['tests'][5]['points'], d['tests'][5]['passed'])\n"),
              "100 10 14.0 True\n");
}

TEST(Classroom50, RoundsHalvesUp) {
    for (const auto& [points, whole] : {std::pair{49.5, "50"}, {49.49, "49"}, {0.5, "1"}, {0.0, "0"}}) {
        Graded one = graded("ada", output_with_a_mistake());
        one.review.overrides = {{0, "", points, "for the test", "ada", ""}};
        EXPECT_EQ(told_of_classroom50(one, "print(d['score'])\n"), std::string(whole) + "\n") << points;
    }
}

TEST(Classroom50, SurvivesHostileText) {
    EXPECT_EQ(told_of_classroom50(hostile(),
                                  "o = d['tests'][5]['output']\n"
                                  "print('<b>&' in o, [c for c in o if c < ' ' and c != '\\n'])\n"),
              "True []\n");
}

TEST(Classroom50, IsNotWrittenWithoutPoints) {
    EXPECT_THROW(classroom50_result(not_graded("ada"), marking(), submission), std::logic_error);
}

}  // namespace
}  // namespace harness::report
