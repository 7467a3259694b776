#include "reference/toml/variants_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"
#include "tests/given/student/scenes.h"
#include "tests/reference/toml/complaint.h"

namespace reference {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

const std::string scene_of_a_sphere =
    student::camera_on_the_axis(4) + "[[sphere]]\ncenter = [1, 1, 0]\nradius = 2.50\n";

std::string complaint_about_variant(const std::string& variant) {
    return complaint_about(scene_of_a_sphere + variant, "a.toml");
}

TEST(VariantsReader, OverridesTheGivenKeys) {
    const Assignment assignment =
        parse_assignment(scene_of_a_sphere +
                             "[[variant]]\nname = \"aside\"\ncamera.eye = [1, 2, 3.50]\nsphere.radius = "
                             "3\n[[variant]]\nwindow.pixel = [0, 200]\n",
                         "a.toml");
    ASSERT_THAT(assignment.variants, SizeIs(2));
    const Variant& aside = assignment.variants[0];
    EXPECT_EQ(aside.name, "aside");
    EXPECT_EQ(aside.scene.camera.eye.z.text(), "3.50");
    EXPECT_EQ(aside.scene.camera.vup.y.text(), "1");
    EXPECT_EQ(aside.scene.spheres.front().radius.text(), "3");
    EXPECT_EQ(assignment.variants[1].name, "variant 2");
    EXPECT_EQ(assignment.variants[1].scene.pixel.y, 200);
    EXPECT_EQ(assignment.scene.camera.eye.z.text(), "4");
}

TEST(DealtScenes, AreThoseOfTheStudents) {
    const Assignment assignment = parse_assignment(
        scene_of_a_sphere +
            "[[student]]\nid = \"s7\"\nwindow.pixel = [3, 4]\nsphere.radius = 3\n[[student]]\nid = \"s8\"\n",
        "a.toml");
    const Assignment own = of_student(assignment, "s7");
    EXPECT_EQ(own.name, "a@s7");
    EXPECT_EQ(own.scene.pixel.y, 4);
    EXPECT_EQ(own.scene.spheres.front().radius.text(), "3");
    EXPECT_EQ(own.scene.camera.eye.z.text(), "4");
    EXPECT_THAT(own.dealt, IsEmpty());
    EXPECT_EQ(scene_toml(of_student(assignment, "s8").scene), scene_toml(assignment.scene)) << "it may be the same";
    EXPECT_EQ(assignment.scene.spheres.front().radius.text(), "2.50");
}

TEST(DealtScenes, RefuseUnusableEntries) {
    EXPECT_THAT(complaint_about_variant("[[student]]\nsphere.radius = 3\n"), HasSubstr("student[1].id"));
    EXPECT_THAT(complaint_about_variant("[[student]]\nid = \"\"\n"), HasSubstr("is empty"));
    EXPECT_THAT(complaint_about_variant("[[student]]\nid = \"s7\"\n[[student]]\nid = \"s7\"\n"),
                AllOf(HasSubstr("student[2].id"), HasSubstr("twice; keep one scene")));
    EXPECT_THAT(complaint_about_variant("[[student]]\nid = \"s7\"\nsphere.radius = -3\n"),
                AllOf(HasSubstr("student[1].sphere.radius"), HasSubstr("\"s7\"")));
    const Assignment for_one = parse_assignment(scene_of_a_sphere + "[[student]]\nid = \"s7\"\n", "a.toml");
    EXPECT_THAT([&] { of_student(for_one, "s77"); }, ThrowsMessage<AssignmentError>(HasSubstr("did you mean s7")));
}

TEST(VariantsReader, RefusesOverridesThatDoNotFitTheScene) {
    EXPECT_THAT(complaint_about_variant("[[variant]]\ncamera.eyes = [1, 2, 3]\n"),
                AllOf(HasSubstr("a.toml"), HasSubstr("eyes")));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nwindow.width = 3\n"), HasSubstr("width"));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nwindow.pixel = [301, 0]\n"),
                HasSubstr("301, which is not a pixel"));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nwindow.pixel = [1.5, 0]\n"),
                HasSubstr("1.5, which is not a pixel"));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nname = \"same\"\nsphere.radius = 2.50\n"),
                HasSubstr("\"same\", which changes nothing"));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nname = \"near\"\nsphere.radius = 2\n"
                                        "[[variant]]\nname = \"near\"\nsphere.radius = 3\n"),
                AllOf(HasSubstr("variant[2].name"), HasSubstr("\"near\" twice")));
    EXPECT_THAT(complaint_about_variant("[[variant]]\ntriangle.vertices = [[0,0,0],[1,0,0],[0,1,0]]\n"),
                HasSubstr("no triangle"));
}

TEST(VariantsReader, RefusesASceneThatCantBeMarked) {
    const auto line = [](int of_variant) {
        return fmt::format("a.toml:{}: ",
                           std::count(scene_of_a_sphere.begin(), scene_of_a_sphere.end(), '\n') + of_variant);
    };
    EXPECT_THAT(
        complaint_about_variant("[[variant]]\nname = \"blind\"\ncamera.eye = [0, 0, 0]\n"),
        AllOf(HasSubstr(line(3) + "variant[1].camera"), HasSubstr("\"blind\""), HasSubstr("camera.lookat equals eye")));
    EXPECT_THAT(complaint_about_variant("[[variant]]\nname = \"small\"\nsphere.radius = -1\n"),
                AllOf(HasSubstr(line(3) + "variant[1].sphere.radius is -1"), HasSubstr("\"small\"")));
}

TEST(SceneToml, ReadsBackAsTheSameScene) {
    const Assignment assignment = parse_assignment(scene_of_a_sphere, "a.toml");
    EXPECT_EQ(scene_toml(parse_assignment(scene_toml(assignment.scene), "b.toml").scene), scene_toml(assignment.scene));
    EXPECT_THAT(scene_toml(assignment.scene), HasSubstr("radius = 2.50"));
}

}  // namespace
}  // namespace reference
