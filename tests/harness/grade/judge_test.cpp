#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/grade/grade_submission.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/record/concerns.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Marking& off_axis() {
    static const Marking made = make_marking(student::off_axis_scene().assignment);
    return made;
}

Graded judged(const std::string& output) {
    Graded graded;
    judge(graded, score(read_transcript(output, 10), off_axis().key, off_axis().assignment), "", output, off_axis(),
          nullptr);
    return graded;
}

std::vector<std::string> kinds_of(const Graded& graded) {
    std::vector<std::string> kinds;
    for (const Flag& flag : graded.findings.flags) kinds.push_back(flag.kind);
    return kinds;
}

TEST(MostlyFollowing, FlagsNumbersThatWereMadeUp) {
    const Graded made_up = judged(
        "Question 4:\nP_WCS: (0, 0, 14)\nQuestion 5:\nV: (0, 0, 1)\nQuestion 6:\na: 7\nb: 0\nc: 1000\nd: -28000\n"
        "the ray misses the sphere\nQuestion 7:\nnone\nQuestion 8:\nA: mat3x3((1, 0, 0), (0, 1, 0), (0, 0, 1))\n"
        "rhs: (2, 3, 4)\nt: 2\nu: 3\nv: 4\nP_t: none\nQuestion 10:\nnothing is hit\n");
    EXPECT_GT(made_up.score.points, 20);
    ASSERT_THAT(kinds_of(made_up), ElementsAre("mostly_following"));
    EXPECT_THAT(made_up.findings.flags.front().evidence, HasSubstr("; none is right."));
}

TEST(MostlyFollowing, DoesNotFlagAnHonestMistake) {
    EXPECT_THAT(kinds_of(judged(print(student::Program(off_axis().assignment, {})))), ElementsAre());
    for (const reference::ItemId& id : {reference::item::P_VCS, reference::item::Z_vcs}) {
        const student::Program::Mistake early{id, [](const student::Program&, const auto& right) {
                                                  student::Floats wrong = right.value();
                                                  for (auto& x : wrong) x *= 1.25F;
                                                  return std::optional(wrong);
                                              }};
        const Graded graded = judged(print(student::Program(off_axis().assignment, {}, early)));
        EXPECT_LT(graded.score.points, graded.score.max_points) << id.name;
        EXPECT_THAT(kinds_of(graded), ElementsAre()) << id.name;
    }
}

TEST(ReadingDoubtful, IsFlaggedEvenIfTheStudentSeesNothing) {
    const Graded graded = judged("Question 6:\nt: 3.29988\nb2: 2.29988\n");  // the second is the right t
    ASSERT_THAT(kinds_of(graded), ElementsAre("reading_doubtful"));
    EXPECT_EQ(graded.findings.flags.front().evidence, "") << "which number is right";
    EXPECT_TRUE(flags_for_student(graded).empty());
}

}  // namespace
}  // namespace harness
