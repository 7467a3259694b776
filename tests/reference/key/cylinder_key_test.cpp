// The certified key of scenes with a cylinder. Comments derive the constants by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reference/key/answer_key.h"
#include "reference/key/key_formats.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace reference;

constexpr double root_of_2 = 1.41421356237309504880;

const std::string asks_for_the_cylinder =
    "[[question]]\nnumber = 4\nitems = [\"cylinder.a\", \"cylinder.b\", \"cylinder.c\", \"cylinder.d\", "
    "\"cylinder.t\", \"cylinder.hit\", \"cylinder.normal\"]\n";

/// The camera and the sphere of 2024.
const std::string camera_2024 = R"(
[camera]
eye = [6, 1, 0]
lookat = [0, 1, 0]
vup = [0, 1, 0]
[window]
clip_left = -2
clip_right = 2
clip_bottom = -1
clip_top = 1
clip_near = 2
width = 401
height = 301
pixel = [200, 150]
)";
const std::string sphere_2024 = "[[sphere]]\ncenter = [1, 0, 1]\nradius = 2\n";

std::string cylinder(const std::string& center, const std::string& radius, const std::string& height) {
    return "[[cylinder]]\ncenter = [" + center + "]\nradius = " + radius + "\nheight = " + height + "\n";
}

AnswerKey key_of_text(const std::string& toml) {
    return make_key(parse_assignment(toml, "scene.toml"), Precision::certified);
}

const std::vector<Answer>& answers_to(const AnswerKey& key, const ItemId& id) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == id) return item.answers;
        }
    }
    for (const KeyItem& item : key.not_asked) {
        if (item.spec.id == id) return item.answers;
    }
    throw std::out_of_range(std::string(id.name));
}

void expect_value(const AnswerKey& key, const ItemId& id, const Numbers& value) {
    SCOPED_TRACE(id.name);
    const std::vector<Answer>& answers = answers_to(key, id);
    EXPECT_EQ(answers.size(), 1U);
    EXPECT_EQ(std::get<Numbers>(answers.front().value), value);
    for (const double allowance : answers.front().allowance) EXPECT_LT(allowance, 1e-4);
}

TEST(CylinderKey, MatchesTheHandDerivationOfA6_2024) {
    const AnswerKey key = make_key(load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS), Precision::certified);
    expect_value(key, item::P_VCS, {0, 0, -2});
    expect_value(key, item::P_WCS, {4, 1, 0});
    expect_value(key, item::V, {-1, 0, 0});
    // S - C = (3, 1, -1): c = 11 - 4.
    expect_value(key, item::sphere::a, {1});
    expect_value(key, item::sphere::b, {-6});
    expect_value(key, item::sphere::c, {7});
    expect_value(key, item::sphere::d, {8});
    expect_value(key, item::sphere::t, {3 - root_of_2});
    // S + 2V = (2, 1, 0) = A + 1/4 (0, 0, 2) + 1/2 (-2, 4, 1).
    expect_value(key, item::triangle::t, {2});
    expect_value(key, item::triangle::u, {0.25});
    expect_value(key, item::triangle::v, {0.5});
    // S - C = (2, 1, 0).
    expect_value(key, item::cylinder::a, {1});
    expect_value(key, item::cylinder::b, {-4});
    expect_value(key, item::cylinder::c, {3});
    expect_value(key, item::cylinder::d, {4});
    expect_value(key, item::cylinder::t, {1});
    expect_value(key, item::cylinder::hit, {3, 1, 0});
    expect_value(key, item::cylinder::normal, {1, 0, 0});
    EXPECT_EQ(std::get<FirstObject>(answers_to(key, item::first_object).front().value),
              FirstObject(reference::Subject::cylinder));
    EXPECT_EQ(key.decisions.of(reference::Subject::cylinder), "hit");
    EXPECT_EQ(key.decisions.first, "cylinder");
    EXPECT_EQ(nlohmann::json::parse(to_json(key))["decisions"]["cylinder"], "hit");
    EXPECT_THAT(key.notes, testing::IsEmpty());
}

/// The camera of 2024: the ray starts at (4, 1, 0) and runs along -x.
Decisions decisions_of_2024(const std::string& objects) {
    return key_of_text(camera_2024 + objects).decisions;
}

TEST(CylinderKey, SaysHowTheRayTouchesOrPasses) {
    const auto at_z = [](const std::string& z) {
        return decisions_of_2024(cylinder("0, 0, " + z, "1", "4")).of(Subject::cylinder);
    };
    EXPECT_EQ(at_z("1"), "tangent");
    EXPECT_EQ(at_z("0.99999999999999999999"), "hit");
    EXPECT_EQ(at_z("-1.00000000000000000001"), "miss");
    const auto at_y = [](const std::string& y) {
        return decisions_of_2024(cylinder("0, " + y + ", 0", "1", "4")).of(Subject::cylinder);
    };
    EXPECT_EQ(at_y("-1"), "hit") << "in the plane of the top cap";
    EXPECT_EQ(at_y("-1.00000000000000000001"), "miss");
    EXPECT_EQ(at_y("3"), "hit") << "in the plane of the bottom cap";
    EXPECT_EQ(at_y("3.00000000000000000001"), "miss");
    EXPECT_EQ(decisions_of_2024(cylinder("3, 0, 0", "1", "4")).of(Subject::cylinder), "boundary");
    EXPECT_EQ(decisions_of_2024(cylinder("4, -1, 0", "1", "4")).of(Subject::cylinder), "boundary") << "on the top cap";
    EXPECT_EQ(decisions_of_2024(cylinder("4, 0, 0", "1", "4")).of(Subject::cylinder), "hit") << "inside";
    EXPECT_EQ(decisions_of_2024(cylinder("3, -2, 0", "1", "4")).of(Subject::cylinder), "miss")
        << "above the tube's rim";
    EXPECT_EQ(decisions_of_2024(sphere_2024).of(Subject::cylinder), "");
}

TEST(CylinderKey, NamesTheNearestOfThreeObjects) {
    // The sphere is met at t = 3, the plane of the triangle at t = 2, the cylinder at the t of each line.
    const std::string others =
        "[[sphere]]\ncenter = [0, 1, 0]\nradius = 1\n"
        "[[triangle]]\nvertices = [[2, -9, -9], [2, -9, 9], [2, 19, 0]]\n";
    const auto first = [&](const std::string& x) {
        return decisions_of_2024(others + cylinder(x + ", 0, 0", "0.5", "4")).first;
    };
    EXPECT_EQ(first("2.50000000000000000001"), "cylinder");
    EXPECT_EQ(first("1.5"), "tie");
    EXPECT_EQ(first("1.49999999999999999999"), "triangle");
    EXPECT_EQ(first("0.5"), "triangle") << "the cylinder and the sphere are a tie behind it";
    EXPECT_EQ(first("-7"), "triangle");
    EXPECT_EQ(decisions_of_2024(sphere_2024 + cylinder("-7, 0, 0", "1", "4")).first, "sphere");
    EXPECT_EQ(decisions_of_2024(cylinder("9, 0, 0", "1", "4") + "[[sphere]]\ncenter = [0, 5, 0]\nradius = 1\n").first,
              "none");
    // Both circles have the radius √2 in the plane y = 1: t = 4 - √2.
    EXPECT_EQ(decisions_of_2024("[[sphere]]\ncenter = [0, 1, 1]\nradius = 2\n" + cylinder("0, 0, 1", "2", "4")).first,
              "tie");
}

TEST(CylinderKey, AsksAboutTheNearestOfSeveralCylinders) {
    const std::string near = cylinder("2, 0, 0", "1", "4"), far = cylinder("0, 0, 0", "1", "4"),
                      around = cylinder("4, 0, 0", "1.5", "4"), missed = cylinder("3, 9, 0", "1", "4");
    const auto expect_t = [&](double t, const std::string& one, const std::string& other) {
        for (const std::string& both : {one + other, other + one})
            expect_value(key_of_text(camera_2024 + both + asks_for_the_cylinder), item::cylinder::t, {t});
    };
    expect_t(1, near, far);
    expect_t(1, near, around);
    expect_t(1, near, missed);
    expect_t(1.5, around, far);
    expect_t(3, far, missed);
}

/// A camera at (0, 3, 4) that looks at the origin: the ray is (0, 3 - 3s, 4 - 4s), t = 5s - 2.
constexpr std::string_view slanting_camera = R"(
[camera]
eye = [0, 3, 4]
lookat = [0, 0, 0]
vup = [0, 1, 0]
[window]
clip_left = -2
clip_right = 2
clip_bottom = -1
clip_top = 1
clip_near = 2
width = 401
height = 301
pixel = [200, 150]
)";

AnswerKey slanting_key(const std::string& center_y, const std::string& boundary = "nonnegative") {
    return key_of_text(std::string(slanting_camera) + cylinder("0, " + center_y + ", 0", "1", "2") +
                       asks_for_the_cylinder + "[rubric]\nboundary = \"" + boundary + "\"\n");
}

TEST(CylinderKey, HasTheCapsHitAndNormal) {
    // The plane y = 1/2 is crossed at s = 5/6, z = 2/3.
    const AnswerKey top = slanting_key("-0.5");
    expect_value(top, item::cylinder::t, {13.0 / 6});
    expect_value(top, item::cylinder::hit, {0, 0.5, 2.0 / 3});
    expect_value(top, item::cylinder::normal, {0, 1, 0});
    // The tube: a = 16/25; S = (0, 9/5, 12/5), so b = 2 * 12/5 * -4/5 and c = 144/25 - 1.
    expect_value(top, item::cylinder::a, {0.64});
    expect_value(top, item::cylinder::b, {-3.84});
    expect_value(top, item::cylinder::c, {4.76});
    expect_value(top, item::cylinder::d, {2.56});
    // The tube is met at s = 3/4, y = 3/4.
    expect_value(slanting_key("0"), item::cylinder::hit, {0, 0.75, 1});
    expect_value(slanting_key("0"), item::cylinder::normal, {0, 0, 1});
    EXPECT_TRUE(std::holds_alternative<NoValue>(answers_to(slanting_key("9"), item::cylinder::t).front().value));
    expect_value(slanting_key("9"), item::cylinder::d, {2.56});
}

TEST(CylinderKey, AcceptsTheCapsNormalAtARimIfTheRubricLeavesTheBoundaryOpen) {
    const AnswerKey key = slanting_key("-0.25", "either");
    expect_value(key, item::cylinder::t, {1.75});
    expect_value(key, item::cylinder::hit, {0, 0.75, 1});
    const std::vector<Answer>& normals = answers_to(key, item::cylinder::normal);
    ASSERT_EQ(normals.size(), 2U);
    EXPECT_EQ(std::get<Numbers>(normals[0].value), (Numbers{0, 0, 1}));
    EXPECT_EQ(std::get<Numbers>(normals[1].value), (Numbers{0, 1, 0}));
    EXPECT_EQ(reason(normals[1], key), "the ray hits the cylinder's rim, which belongs to the tube and to the cap");
    EXPECT_EQ(normals[1].allowance, (Numbers{0, 0, 0}));
    EXPECT_THAT(key.decisions.policy, testing::ElementsAre("boundary"));
    for (const char* boundary : {"positive", "nonnegative"})
        EXPECT_EQ(answers_to(slanting_key("-0.25", boundary), item::cylinder::normal).size(), 1U);
    EXPECT_EQ(answers_to(slanting_key("-0.25000000000000000001", "either"), item::cylinder::normal).size(), 1U);
}

TEST(CylinderKey, AllowsForBothFormulasAtARim) {
    const auto allowance = [](const std::string& center_y) {
        return answers_to(slanting_key(center_y), item::cylinder::hit).front().allowance;
    };
    const Numbers rim = allowance("-0.25"), tube = allowance("-0.2499"), cap = allowance("-0.2501");
    // The cap's y and the tube's z come out most exactly.
    EXPECT_LT(cap[1], tube[1] / 2);
    EXPECT_LT(tube[2], cap[2] / 2);
    EXPECT_GE(rim[1], 0.99 * tube[1]);
    EXPECT_GE(rim[2], 0.99 * cap[2]);
}

TEST(CylinderKey, CountsAStartOnTheCylinderAsTheRubricSays) {
    const auto key = [](const std::string& x, const std::string& boundary) {
        return key_of_text(camera_2024 + cylinder(x + ", 0, 0", "1", "4") + asks_for_the_cylinder +
                           "[rubric]\nboundary = \"" + boundary + "\"\n");
    };
    expect_value(key("3", "nonnegative"), item::cylinder::t, {0});
    expect_value(key("3", "positive"), item::cylinder::t, {2});
    expect_value(key("5", "nonnegative"), item::cylinder::t, {0});
    EXPECT_TRUE(std::holds_alternative<NoValue>(answers_to(key("5", "positive"), item::cylinder::t).front().value));
}

}  // namespace
