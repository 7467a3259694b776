#include "reference/toml/questions_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/given/student/scenes.h"
#include "tests/reference/toml/complaint.h"

namespace reference {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string a_sphere = "[[sphere]]\ncenter = [1, 1, 0]\nradius = 2\n";
const std::string a_triangle = "[[triangle]]\nvertices = [[0, -2, 2], [2, 2, 2], [-2, 2, 2]]\n";
const std::string a_cylinder = "[[cylinder]]\ncenter = [2, 0, 0]\nradius = 1\nheight = 4\n";

Assignment assignment_with(const std::string& rest) {
    return parse_assignment(student::camera_on_the_axis(4) + rest, "a.toml");
}

std::string complaint_about_questions(const std::string& rest) {
    return complaint_about(student::camera_on_the_axis(4) + rest, "a.toml");
}

std::vector<std::string> asked(const Assignment& assignment) {
    std::vector<std::string> names;
    for (const ItemSpec& spec : asked_items(assignment.questions))
        names.push_back(std::to_string(spec.question) + "." + std::string(spec.name));
    return names;
}

TEST(Questions, AreThoseOf2021ThatTheSceneCallsForIfNoneAreListed) {
    EXPECT_EQ(assignment_with(a_sphere + a_triangle).questions.size(), 10U);
    EXPECT_THAT(asked(assignment_with(a_sphere)),
                ElementsAre("1.P_VCS", "2.X_vcs", "2.Y_vcs", "2.Z_vcs", "3.M_VCS_to_WCS", "4.P_WCS", "5.V", "6.a",
                            "6.b", "6.c", "6.d", "6.t", "6.hit", "7.normal"));
}

TEST(Questions, AskForItemsByName) {
    const Assignment assignment =
        assignment_with(a_sphere + a_cylinder +
                        "[[question]]\ntitle = \"the ray\"\nitems = [\"V\"]\npoints = 4\n"
                        "[[question]]\nitems = [\"cylinder.t\", \"sphere.t\", \"sphere.hit\"]\n"
                        "[[question]]\nnumber = 7\nitems = [\"first_hit\"]\n");
    EXPECT_THAT(asked(assignment), ElementsAre("1.V", "2.cylinder.t", "2.sphere.t", "2.hit", "7.verdict"))
        << "a name that two items of a question have is told by its object";
    EXPECT_EQ(assignment.questions[0].title, "the ray");
    EXPECT_EQ(assignment.rubric.points_of(1), 4);
    EXPECT_EQ(assignment.rubric.points_of(2), 10);
}

const std::string two_parts =
    "[[question]]\nparts = [{title = \"the quadratic\", items = [\"sphere.a\", \"sphere.b\"], points = 3},\n"
    "  {items = [\"sphere.t\", \"cylinder.t\"], points = 8}]\n";

TEST(Questions, HavePartsWithPointsOfTheirOwn) {
    const Assignment assignment = assignment_with(a_sphere + a_cylinder + two_parts);
    EXPECT_THAT(asked(assignment), ElementsAre("1.a", "1.b", "1.sphere.t", "1.cylinder.t"));
    ASSERT_EQ(assignment.questions[0].parts.size(), 2U);
    EXPECT_EQ(assignment.questions[0].parts[0].title, "the quadratic");
    EXPECT_THAT(assignment.questions[0].parts[1].items, ElementsAre(item::sphere::t, item::cylinder::t));
    std::string letters;
    for (const ItemSpec& spec : asked_items(assignment.questions)) letters += spec.part;
    EXPECT_EQ(letters, "aabb");
    EXPECT_EQ(assignment.rubric.points_of(1), 11);
    using Points = std::map<std::string, double>;
    EXPECT_EQ(assignment.rubric.item_points.at(1),
              (Points{{"a", 1.5}, {"b", 1.5}, {"sphere.t", 4}, {"cylinder.t", 4}}));
}

TEST(Questions, ShareTheirPointsEquallyWhereNoPartHasAny) {
    const Assignment assignment =
        assignment_with(a_sphere +
                        "[[question]]\npoints = 6\n[[question.parts]]\nitems = [\"sphere.a\", \"sphere.b\"]\n"
                        "[[question.parts]]\nitems = [\"sphere.t\"]\n");
    EXPECT_EQ(assignment.rubric.points_of(1), 6);
    EXPECT_FALSE(assignment.rubric.item_points.contains(1));
}

TEST(Questions, AreRefusedWithTheirPlaceAndRemedy) {
    const auto asks = [](const std::string& items) { return "[[question]]\nitems = " + items + "\n"; };
    const std::string parts = "[[question]]\nparts = ", a = "{items = [\"sphere.a\"]}",
                      a_for_3 = "{items = [\"sphere.a\"], points = 3}", points_of_1 = "[rubric.points]\n1 = 5\n";
    const struct {
        std::string toml, words, place = "";
    } broken[] = {
        {asks("[\"V\"]") + "parts = [" + a + "]\n", "put each item into its part"},
        {parts + "[]\n", "at least one part"},
        {parts + "[{items = []}]\n", "at least one item"},
        {"[[question]]\npoints = 3\nparts = [" + a_for_3 + "]\n", "keep one"},
        {parts + "[" + a_for_3 + ", {items = [\"sphere.b\"]}]\n", "give each part its points"},
        {parts + "[" + a + ", " + a + "]\n", "twice; ask once"},
        {a_cylinder + two_parts + points_of_1, "keep one"},
        {asks("[\"sphere.x\"]"), "\"sphere.x\", which is not an item; did you mean sphere.a", "question[1].items"},
        {asks("[\"cylinder.t\"]"), "add [[cylinder]]"},
        {asks("[\"first_hit\"]"), "two kinds"},
        {asks("[\"V\"]") + asks("[\"V\"]"), "twice; ask once"},
        {asks("[]"), "at least one item"},
        {asks("[\"V\"]") + "number = 2\n" + asks("[\"P_WCS\"]") + "number = 2\n", "ascending order",
         "question[2].number"},
        {"[rubric.points]\n8 = 10\n", "questions are 1, 2, 3, 4, 5, 6, 7", "rubric.points.8"},
        {asks("[\"V\"]") + "points = 3\n" + points_of_1, "keep one"},
    };
    for (const auto& [toml, words, place] : broken)
        EXPECT_THAT(complaint_about_questions(a_sphere + toml), AllOf(HasSubstr(words), HasSubstr(place)));
}

TEST(Questions, MustGivePointsForSomething) {
    const std::string none = "is 0 for every question; give a question points above 0";
    const auto at = [&](const std::string& place) {
        return AllOf(HasSubstr("a.toml:"), HasSubstr(place + " " + none));
    };
    const std::string nothing_but_V = a_sphere + "[[question]]\nitems = [\"V\"]\n";
    EXPECT_THAT(complaint_about_questions(nothing_but_V + "points = 0\n"), at("question[1].points"));
    EXPECT_THAT(complaint_about_questions(nothing_but_V + "[rubric.points]\n1 = 0\n"), at("rubric.points"));
    EXPECT_THAT(complaint_about_questions(nothing_but_V + "[rubric.points.1]\nV = 0\n"), at("rubric.points"));
    EXPECT_THAT(complaint_about_questions(a_sphere + "[[question]]\nparts = [{items = [\"V\"], points = 0}]\n"),
                at("question[1].parts[1].points"));
    EXPECT_THAT(complaint_about_questions(nothing_but_V + "points = 0\n[rubric]\nvariant_points = 5\n"),
                at("question[1].points"))
        << "on other scenes a share of nothing is earned";
    EXPECT_EQ(complaint_about_questions(nothing_but_V + "points = 0\n[[question]]\nitems = [\"P_WCS\"]\n"), "accepted");
    EXPECT_EQ(complaint_about_questions(nothing_but_V + "points = 0.5\n"), "accepted");
}

}  // namespace
}  // namespace reference
