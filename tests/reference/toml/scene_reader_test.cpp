// A mistake in a scene is reported with file, line, key and remedy. An unusual but valid scene is accepted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "reference/key/answer_key.h"
#include "reference/key/key_formats.h"
#include "reference/toml/assignment_error.h"
#include "tests/reference/toml/complaint.h"

namespace reference {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The tests below refer to these line numbers.
const std::string whole_scene =
    "[camera]\n"                                        // 1
    "eye = [0, 0, 4]\n"                                 // 2
    "lookat = [0, 0, 0]\n"                              // 3
    "vup = [0, 1, 0]\n"                                 // 4
    "[window]\n"                                        // 5
    "clip_left = -2\n"                                  // 6
    "clip_right = 2\n"                                  // 7
    "clip_bottom = -1\n"                                // 8
    "clip_top = 1\n"                                    // 9
    "clip_near = 2\n"                                   // 10
    "width = 301\n"                                     // 11
    "height = 201\n"                                    // 12
    "pixel = [150, 100]\n"                              // 13
    "[[sphere]]\n"                                      // 14
    "center = [1, 1, 0]\n"                              // 15
    "radius = 2\n"                                      // 16
    "[[triangle]]\n"                                    // 17
    "vertices = [[0, -2, 2], [2, 2, 2], [-2, 2, 2]]\n"  // 18
    "[rubric]\n";                                       // 19

std::string scene_with(const std::string& line, const std::string& other) {
    std::string text = whole_scene;
    const std::size_t at = text.find(line);
    EXPECT_NE(at, std::string::npos) << line;
    return text.replace(at, line.size(), other);
}

Assignment assignment_in(const std::string& text) {
    return parse_assignment(text, "folder/year.toml");
}

std::string complaint_about_scene(const std::string& line, const std::string& other) {
    return complaint_about(scene_with(line, other), "folder/year.toml");
}

auto says(const std::string& place, const std::string& what) {
    return AllOf(HasSubstr("folder/year.toml:" + place), HasSubstr(what));
}

TEST(SceneReader, AcceptsTheSceneThatTheseTestsBreak) {
    EXPECT_EQ(assignment_in(whole_scene).notes.size(), 0U);
}

/// H31, H33, H43, H53, H55 are hard cases.
TEST(SceneReader, RefusesABrokenSceneByLineKeyAndRemedy) {
    const char *const eye = "eye = [0, 0, 4]", *const vup = "vup = [0, 1, 0]", *const center = "center = [1, 1, 0]",
                      *const radius = "radius = 2", *const near = "clip_near = 2", *const pixel = "pixel = [150, 100]",
                      *const vertices = "[[0, -2, 2], [2, 2, 2], [-2, 2, 2]]";
    const std::string all_axes = std::string(eye) + "\nlookat = [0, 0, 0]\n" + vup;
    const struct {
        std::string line, other, place, words;
    } broken[] = {
        {vup, "vup = [0, 0, 1]", "4: camera.vup", "such as [0, 1, 0]"},  // H53
        {eye, "eye = [0, -7.5, 0]", "4: camera.vup", "such as [0, 0, 1]"},
        // In doubles 0.1 * 3 is not 0.3; in decimals this vup is exactly parallel to the view.
        {all_axes, "eye = [0.1, 0.1, 0.1]\nlookat = [0, 0, 0]\nvup = [0.3, 0.3, 0.3]", "4: camera.vup", "parallel"},
        {vup, "vup = [0, 0, 0]", "4: camera.vup", "is zero"},
        {eye, "eye = [0, 0.0, -0e9]", "3: camera.lookat", "equals eye"},    // H55
        {radius, "radius = 0", "16: sphere[1].radius", "must be above 0"},  // H31
        {radius, "radius = -1", "16: sphere[1].radius", "must be above 0"},
        {radius, "radius = inf", "16: sphere[1].radius", "is not a finite number"},
        {eye, "eye = [nan, 0, 4]", "2: camera.eye", "is not a finite number"},  // H33
        {center, "center = [1, -inf, 0]", "15: sphere[1].center", "finite"},
        {center, "center = [1, 1e151, 0]", "15: sphere[1].center", "1e151, which is out of range"},
        {"clip_left = -2", "clip_left = -1e-301", "6: window.clip_left", "out of range"},
        {radius, "radius = 100000000000000000000000", "16:", "write large numbers with an exponent, as in 1e30"},
        {"[2, 2, 2]", "[2, 2, 2e200]", "18: triangle[1].vertices", "out of range"},
        {"clip_right = 2", "clip_right = -2.0", "7: window.clip_right", "window is empty"},
        {"clip_top = 1", "clip_top = -1", "9: window.clip_top", "window is empty"},
        {near, "clip_near = 0", "10: window.clip_near", "must be above 0"},
        {near, "clip_near = -2", "10: window.clip_near", "must be above 0"},
        {whole_scene, "", "1: window", "add a table [window]"},
        {radius, "radios = 2", "16: sphere[1].radios", "did you mean radius?"},
        {center, "centre = [1, 1, 0]", "15: sphere[1].centre", "did you mean center?"},
        {"width = 301", "width = 0", "11: window.width", "from 1 to"},
        {"height = 201", "height = -1", "12: window.height", "from 1 to"},
        {pixel, "pixel = [301, 100]", "13: window.pixel", "from 0 to 300"},
        {pixel, "pixel = [150, -1]", "13: window.pixel", "from 0 to 200"},
        {pixel, "pixel = [150.5, 100]", "13: window.pixel", "whole"},
        {pixel, "pixel = [150.00000000000000000001, 100]", "13: window.pixel", "whole"},  // the nearest double is 150
        {vertices, "[[0.1, 0.1, 0], [0.2, 0.2, 0], [0.3, 0.3, 0]]", "18: triangle[1].vertices", "no area"},  // H43
        {vertices, "[[1, 1, 1], [1, 1, 1], [2, 3, 4]]", "18: triangle[1].vertices", "no area"},
    };
    for (const auto& [line, other, place, words] : broken)
        EXPECT_THAT(complaint_about_scene(line, other), says(place, words)) << other;
    EXPECT_EQ(complaint_about_scene(pixel, "pixel = [150.0, 100]"), "accepted");
    EXPECT_EQ(complaint_about_scene(vertices, "[[0.1, 0.1, 0], [0.2, 0.2, 0], [0.3, 0.3, 1e-290]]"), "accepted");
}

TEST(SceneReader, RefusesARubricForAnItemThatDoesNotExist) {
    EXPECT_THAT(complaint_about_scene("radius = 2", "radius = 2\n[rubric.points]\n6 = {z = 1}"),
                testing::HasSubstr("z is not an item of question 6; there are a, b, c, d, t, hit"));
    EXPECT_THAT(complaint_about_scene("radius = 2", "radius = 2\n[rubric.tolerance]\n8 = {zz = 1}"),
                testing::HasSubstr("zz is not an item of question 8"));
}

TEST(SceneReader, ReadsALateSchedule) {
    const Rubric rubric =
        assignment_in(scene_with("[rubric]\n", "[rubric]\nlate = [[1, 0.05], [2, 1.0]]\ngrace_minutes = 10\n")).rubric;
    ASSERT_EQ(rubric.late.size(), 2U);
    EXPECT_EQ(rubric.late[1].days, 2);
    EXPECT_EQ(rubric.late[1].share, 1.0);
    EXPECT_EQ(rubric.grace_minutes, 10);
    const auto refused = [](const std::string& late) {
        return complaint_about_scene("[rubric]\n", "[rubric]\nlate = " + late + "\n");
    };
    EXPECT_THAT(refused("[[2, 0.1], [1, 0.2]]"), says("20: rubric.late", "ascending"));
    EXPECT_THAT(refused("[[0, 0.1]]"),
                says("20: rubric.late", "has 0, which is not a number of days; write a whole number from 1 to 365"));
    EXPECT_THAT(refused("[[400, 0.1]]"), says("20: rubric.late", "400, which is not a number of days"));
    EXPECT_THAT(refused("[[1, 1.5]]"), says("20: rubric.late", "1.5, which is not a share"));
    EXPECT_THAT(refused("[[1, 0.5], [2, 0.1]]"), says("20: rubric.late", "only 0.1 from day 2"));
    EXPECT_THAT(refused("0.5"), says("20: rubric.late", "array"));
    EXPECT_THAT(refused("[[1, 0.1]]\nlate_deduction = 0.1"), testing::HasSubstr("keep one of the two"));
}

TEST(RubricReader, ReadsWhenTheAssignmentIsDue) {
    const auto due = [](const std::string& value) {
        return assignment_in(scene_with("[rubric]\n", "[rubric]\ndue = " + value + "\n")).rubric.due.value().minutes;
    };
    EXPECT_EQ(due("\"1970-01-01 01:00\""), 60);
    EXPECT_EQ(due("1970-01-01T01:00:00"), 60) << "a date of TOML";
    EXPECT_EQ(due("1970-01-01T01:00:00+01:00"), 0);
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\ndue = \"tomorrow\"\n"),
                AllOf(HasSubstr("rubric.due"), HasSubstr("is not a date with a time; write")));
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\ndue = 5\n"), HasSubstr("rubric.due"));
}

TEST(Rubric, UsesFeedbackAfterDueAfterTheDeadline) {
    using namespace std::chrono_literals;
    const auto day = [](int days) { return std::chrono::system_clock::time_point{} + days * 24h; };
    const std::string due = "due = \"1970-01-11 00:00Z\"\n", after = "feedback_after_due = \"expected\"\n";
    const Rubric rubric = assignment_in(whole_scene + due + "feedback = \"hint\"\n" + after).rubric;
    EXPECT_EQ(feedback_at(rubric, day(10)), Feedback::hint);
    EXPECT_EQ(feedback_at(rubric, day(10) + 1min), Feedback::expected);
    EXPECT_EQ(feedback_at(assignment_in(whole_scene + due).rubric, day(20)), Feedback::mistake);
    const Rubric lenient = assignment_in(whole_scene + due + after + "grace_minutes = 30\n").rubric;
    EXPECT_EQ(feedback_at(lenient, day(10) + 30min), Feedback::mistake) << "a hand-in is still on time";
    EXPECT_EQ(feedback_at(lenient, day(10) + 31min), Feedback::expected);
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\n" + after),
                says("20: rubric.feedback_after_due", "needs due"));
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\n" + due + "feedback_after_due = \"all\"\n"),
                says("21: rubric.feedback_after_due", "is not one of \"verdict\""));
}

TEST(SceneReader, AcceptsAndNotesAMirroredWindow) {
    const Assignment mirrored = assignment_in(scene_with("clip_right = 2", "clip_right = -3"));
    EXPECT_THAT(mirrored.notes, ElementsAre(HasSubstr("mirrored left to right")));
    EXPECT_THAT(assignment_in(scene_with("clip_top = 1", "clip_top = -2")).notes,
                ElementsAre(HasSubstr("mirrored upside down")));
    EXPECT_THAT(to_json(make_key(mirrored, Precision::certified)), HasSubstr("mirrored left to right"));
}

std::vector<int> questions(const AnswerKey& key) {
    std::vector<int> numbers;
    for (const KeyQuestion& question : key.questions) numbers.push_back(question.number);
    return numbers;
}

TEST(SceneReader, AsksOnlyAboutObjectsInTheScene) {
    const std::string sphere = "[[sphere]]\ncenter = [1, 1, 0]\nradius = 2\n";
    const std::string triangle = "[[triangle]]\nvertices = [[0, -2, 2], [2, 2, 2], [-2, 2, 2]]\n";
    const auto asked = [](const std::string& text) {
        return questions(make_key(assignment_in(text), Precision::certified));
    };
    EXPECT_THAT(asked(whole_scene), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
    EXPECT_THAT(asked(scene_with(triangle, "")), ElementsAre(1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(asked(scene_with(sphere, "")), ElementsAre(1, 2, 3, 4, 5, 8, 9));
    EXPECT_THAT(asked(scene_with(sphere + triangle, "")), ElementsAre(1, 2, 3, 4, 5));
}

TEST(SceneReader, AsksAboutTheFirstSphereThatIsHit) {
    const std::string missed = "[[sphere]]\ncenter = [9, 9, 9]\nradius = 1\n";
    const std::string nearer = "[[sphere]]\ncenter = [0, 0, 1]\nradius = 0.5\n";
    const AnswerKey key =
        make_key(assignment_in(scene_with("[[sphere]]\n", missed + nearer + "[[sphere]]\n")), Precision::certified);
    EXPECT_EQ(std::get<Numbers>(key.questions.at(5).items.at(4).answers.front().value), Numbers{0.5});
    EXPECT_EQ(key.decisions.of(reference::Subject::sphere), "hit");
    // If no sphere is hit, the questions are about the first one listed: its c is 81 + 81 + 49 - 1.
    const AnswerKey none = make_key(
        assignment_in(scene_with("center = [1, 1, 0]\nradius = 2\n",
                                 "center = [9, 9, 9]\nradius = 1\n[[sphere]]\ncenter = [8, 8, 8]\nradius = 1\n")),
        Precision::certified);
    EXPECT_EQ(std::get<Numbers>(none.questions.at(5).items.at(2).answers.front().value), Numbers{210});
    EXPECT_EQ(none.decisions.of(reference::Subject::sphere), "miss");
}

TEST(SceneReader, AsksAboutTheFirstTriangleThatIsHit) {
    const std::string nearer = "[[triangle]]\nvertices = [[0, -2, 1.5], [2, 2, 1.5], [-2, 2, 1.5]]\n";
    const std::string farther = "[[triangle]]\nvertices = [[0, -2, 1], [2, 2, 1], [-2, 2, 1]]\n";
    const AnswerKey key = make_key(assignment_in(scene_with("[[triangle]]\n", farther + nearer + "[[triangle]]\n")),
                                   Precision::certified);
    // With t >= 0 the questions are about the handout's own triangle, with t > 0 about the nearer of the other two.
    const std::vector<Answer>& t = key.questions.at(7).items.at(2).answers;
    ASSERT_EQ(t.size(), 2U);
    EXPECT_EQ(std::get<Numbers>(t[0].value), Numbers{0});
    EXPECT_EQ(std::get<Numbers>(t[1].value), Numbers{0.5});
}

TEST(Rubric, RefusesANarrowToleranceWithTheItemAndBothNumbers) {
    const Assignment narrow = assignment_in(whole_scene + "[rubric.tolerance]\n6.t = 1e-9\n");
    EXPECT_THAT([&] { make_key(narrow, Precision::certified); },
                ThrowsMessage<AssignmentError>(
                    AllOf(HasSubstr("question 6, t"), HasSubstr("1e-09"), HasSubstr("may be off by"))));
    EXPECT_NO_THROW(make_key(narrow, Precision::double_));
    EXPECT_NO_THROW(make_key(assignment_in(whole_scene + "[rubric.tolerance]\n6.t = 0.01\n"), Precision::certified));
}

TEST(Rubric, HasNoToleranceByDefault) {
    EXPECT_FALSE(assignment_in(whole_scene).rubric.tolerance_of(6, "t").has_value());
    EXPECT_EQ(assignment_in(whole_scene + "[rubric.tolerance]\n6.t = 0.5\n").rubric.tolerance_of(6, "t"), 0.5);
    EXPECT_EQ(assignment_in(whole_scene + "[rubric.tolerance]\ndefault = 0.25\n").rubric.tolerance_of(6, "t"), 0.25);
}

TEST(Rubric, DeductsNothingForLatenessAndShowsNoAnswersByDefault) {
    EXPECT_TRUE(assignment_in(whole_scene).rubric.late.empty());
    EXPECT_EQ(assignment_in(whole_scene).rubric.feedback, Feedback::mistake);
    const Rubric written = assignment_in(whole_scene + "late_deduction = 0.2\nshow_expected = true\n").rubric;
    ASSERT_EQ(written.late.size(), 1U);
    EXPECT_EQ(written.late.front().days, 1);
    EXPECT_EQ(written.late.front().share, 0.2);
    EXPECT_EQ(written.feedback, Feedback::expected);
    EXPECT_EQ(assignment_in(whole_scene + "feedback = \"verdict\"\n").rubric.feedback, Feedback::verdict);
    EXPECT_EQ(assignment_in(whole_scene + "feedback = \"hint\"\nshow_expected = false\n").rubric.feedback,
              Feedback::hint);
    EXPECT_EQ(assignment_in(whole_scene + "feedback = \"expected\"\nshow_expected = true\n").rubric.feedback,
              Feedback::expected);
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\nfeedback = \"hint\"\nshow_expected = true\n"),
                says("21: rubric.show_expected", "contradicts feedback"));
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\nlate_deduction = 20\n"),
                says("20: rubric.late_deduction", "must be from 0 to 1"));
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\nshow_expected = 1\n"),
                says("20: rubric.show_expected", "must be true or false"));
}

TEST(Rubric, GivesNoPointsForVariantsByDefault) {
    EXPECT_EQ(assignment_in(whole_scene).rubric.variant_points, 0);
    EXPECT_EQ(assignment_in(whole_scene + "variant_points = 7.5\n").rubric.variant_points, 7.5);
    EXPECT_THAT(complaint_about_scene("[rubric]\n", "[rubric]\nvariant_points = -1\n"),
                says("20: rubric.variant_points", "must be from 0 to 1000000"));
}

}  // namespace
}  // namespace reference
