#include "harness/grade/own_scene_score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/mark_transcript.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

using testing::HasSubstr;

const Marking& marking() {
    static const Marking edge = make_marking(student::edge_scene().assignment);
    return edge;
}

/// What a right program prints whose sphere is 0.25 higher.
std::string output_with_higher_sphere() {
    reference::Assignment other = marking().assignment;
    auto& y = other.scene.spheres.front().center.y;
    y = reference::Decimal::parse(std::to_string(y.to_double() + 0.25)).value();
    return print(student::Program(other, {}));
}

std::string center_in_source(double higher) {
    const auto& center = marking().assignment.scene.spheres.front().center;
    return "glm::vec3 center(" + center.x.text() + ", " + std::to_string(center.y.to_double() + higher) + ", " +
           center.z.text() + ");";
}

std::optional<OwnSceneScore> on_own_scene(const std::string& output, const std::string& source) {
    return score_on_own_scene(score(read_transcript(output, 10), marking().key, marking().assignment), output, source,
                              marking());
}

TEST(OwnSceneScore, ExistsIfTheSourceStatesTheSceneOfTheAnswers) {
    const std::string output = output_with_higher_sphere();
    const auto own = on_own_scene(output, center_in_source(0.25));
    ASSERT_TRUE(own);
    EXPECT_THAT(own->scene.cause, HasSubstr("center"));
    const Score first = score(read_transcript(output, 10), marking().key, marking().assignment);
    EXPECT_GT(own->score.points, first.points);
    EXPECT_EQ(score_again_on(own->scene, first, read_transcript(output, 10), marking()).points, own->score.points)
        << "the kept scene gives the same score";
}

TEST(OwnSceneScore, UsesAnotherPixelUnlessTheFirstAnswerFitsTheAssignments) {
    reference::Assignment other = marking().assignment;
    other.scene.pixel.x += 20;
    const auto& pixel = other.scene.pixel;
    const std::string source = "pixel(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ");";
    const std::string output = print(student::Program(other, {}));
    const auto own = on_own_scene(output, source);
    ASSERT_TRUE(own);
    EXPECT_THAT(own->scene.cause, HasSubstr("P_DCS"));

    const std::string given = print(student::Program(marking().assignment, {}));
    const std::string first_answer_as_given =
        given.substr(0, given.find("Question 2")) + output.substr(output.find("Question 2"));
    EXPECT_FALSE(on_own_scene(first_answer_as_given, source));
}

TEST(AnswersOfOthers, AreFlaggedWhereScenesAreDealt) {
    reference::Assignment assignment = marking().assignment;
    assignment.dealt["ada"] = assignment.dealt["ben"] = assignment.scene;
    assignment.dealt["ben"].pixel.x += 20;
    assignment.dealt["cy"] = assignment.scene;
    assignment.dealt["cy"].pixel.y += 20;
    const Marking of_class = make_class_marking(assignment);
    const auto graded = [&](const char* id, const std::string& whose) {
        Graded one;
        one.submission.id = id;
        one.execution.outcome = Outcome::graded;
        one.execution.printout = print(student::Program(reference::of_student(assignment, whose), {}));
        const Marking& own = own_marking(of_class, one.submission);
        one.score = score(read_transcript(one.execution.printout, 10), own.key, own.assignment);
        return one;
    };
    std::vector<Graded> all = {graded("ada", "ada"), graded("ben", "cy"), graded("cy", "cy")};
    const auto found = flag_answers_of_others(all, of_class);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].submission, "ben");
    EXPECT_EQ(found[0].student, "cy");
    ASSERT_EQ(all[1].findings.flags.size(), 1U);
    EXPECT_EQ(all[1].findings.flags[0].kind, "scene_of_another");
    EXPECT_THAT(all[1].findings.flags[0].evidence, testing::Not(HasSubstr("cy"))) << "its student reads it";

    std::vector<Graded> from_handout = {graded("ben", "ada")};  // ada's scene is the assignment's own
    EXPECT_EQ(flag_answers_of_others(from_handout, of_class).at(0).student, "ada");
    EXPECT_TRUE(flag_answers_of_others(all, marking()).empty()) << "where no scenes are dealt";
}

TEST(AnswersOfOthers, AreFlaggedIfThereAreAtLeastThree) {
    reference::Assignment assignment = marking().assignment;
    assignment.dealt["ben"] = assignment.dealt["cy"] = assignment.scene;
    assignment.dealt["cy"].pixel.x += 20;
    const Marking of_class = make_class_marking(assignment);
    const std::string of_cy = print(student::Program(reference::of_student(assignment, "cy"), {}));
    // Questions 1, 4 and 5 ask for one answer each, which depends on the pixel.
    const auto question = [&](int number) {
        const auto begin = of_cy.find("Question " + std::to_string(number));
        return of_cy.substr(begin, of_cy.find("Question " + std::to_string(number + 1)) - begin);
    };
    const auto found = [&](const std::string& printout) {
        Graded ben;
        ben.submission.id = "ben";
        ben.execution.outcome = Outcome::graded;
        ben.execution.printout = printout;
        const Marking& own = own_marking(of_class, ben.submission);
        ben.score = score(read_transcript(printout, 10), own.key, own.assignment);
        std::vector<Graded> all{ben};
        return flag_answers_of_others(all, of_class).size();
    };
    EXPECT_EQ(found(question(4) + question(5)), 0U) << "which may be chance";
    EXPECT_EQ(found(question(1) + question(4) + question(5)), 1U);
}

TEST(OwnSceneScore, IsMissingIfSourceAndAnswersDiffer) {
    EXPECT_FALSE(on_own_scene(output_with_higher_sphere(), center_in_source(0.5)));
    EXPECT_FALSE(on_own_scene(output_with_higher_sphere(), center_in_source(0)));
    EXPECT_FALSE(on_own_scene(print(student::Program(marking().assignment, {})), center_in_source(0.25)))
        << "all is right";
}

}  // namespace
}  // namespace harness
