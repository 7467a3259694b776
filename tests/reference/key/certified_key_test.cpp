// The certified keys of the two sample scenes, as constants. A comment next to each derives it by hand. Roots are
// written with 20 digits, so that the compiler rounds them to the nearest double.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "reference/key/answer_key.h"
#include "reference/key/key_formats.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace reference;

constexpr double sqrt_2 = 1.41421356237309504880;
constexpr double half_sqrt_2 = 0.70710678118654752440;

const Answer* find(const AnswerKey& key, int number, std::string_view name, std::size_t which = 0) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (question.number == number && item.spec.name == name && which < item.answers.size()) {
                return &item.answers[which];
            }
        }
    }
    return nullptr;
}

/// `exact`: every component is a double, so lo = hi.
void expect_item(const AnswerKey& key, int number, std::string_view name, const Numbers& value, bool exact) {
    SCOPED_TRACE(name);
    const Answer* answer = find(key, number, name);
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(std::get<Numbers>(answer->value), value);
    ASSERT_EQ(answer->lo.size(), value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        EXPECT_TRUE(answer->lo[i] <= value[i] && value[i] <= answer->hi[i]);
        if (exact) {
            EXPECT_EQ(answer->lo[i], answer->hi[i]);
        }
        EXPECT_GE(answer->allowance[i], 0);
        EXPECT_LT(answer->allowance[i], 0.01);
    }
}

AnswerKey key_of(const std::string& name) {
    return make_key(load_assignment(name, RAYGRADE_ASSIGNMENTS), Precision::certified);
}

TEST(CertifiedKey, MatchesTheHandDerivationOfA6_2021) {
    const AnswerKey key = key_of("a6-2021");
    // Pixel (150, 100) of 301 x 201 is the window's middle: -2 + 4 * 301/602 = 0.
    expect_item(key, 1, "P_VCS", {0, 0, -2}, true);
    // eye - lookat = (0, 0, 4) and vup = y.
    expect_item(key, 2, "X_vcs", {1, 0, 0}, true);
    expect_item(key, 2, "Y_vcs", {0, 1, 0}, true);
    expect_item(key, 2, "Z_vcs", {0, 0, 1}, true);
    expect_item(key, 3, "M_VCS_to_WCS", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 4, 1}, true);
    expect_item(key, 4, "P_WCS", {0, 0, 2}, true);
    expect_item(key, 5, "V", {0, 0, -1}, true);
    // S - C = (-1, -1, 2): b = 2 * -2, c = 6 - 4, d = 16 - 8, t = (4 - 2√2) / 2.
    expect_item(key, 6, "a", {1}, true);
    expect_item(key, 6, "b", {-4}, true);
    expect_item(key, 6, "c", {2}, true);
    expect_item(key, 6, "d", {8}, true);
    expect_item(key, 6, "t", {0.58578643762690495120}, false);
    // (0, 0, 2 - t), less (1, 1, 0), over 2.
    expect_item(key, 6, "hit", {0, 0, sqrt_2}, false);
    expect_item(key, 7, "normal", {-0.5, -0.5, half_sqrt_2}, false);
    // -V, B - A = (2, 4, 0), C - A = (-2, 4, 0); S - A = (0, 2, 0) = 1/4 (B - A) + 1/4 (C - A).
    expect_item(key, 8, "matrix", {0, 0, 1, 2, 4, 0, -2, 4, 0}, true);
    expect_item(key, 8, "rhs", {0, 2, 0}, true);
    expect_item(key, 8, "t", {0}, true);
    expect_item(key, 8, "u", {0.25}, true);
    expect_item(key, 8, "v", {0.25}, true);
    expect_item(key, 8, "hit", {0, 0, 2}, true);
    expect_item(key, 9, "normal", {0, 0, 1}, true);
    EXPECT_EQ(std::get<FirstObject>(find(key, 10, "verdict")->value), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(std::get<FirstObject>(find(key, 10, "verdict", 1)->value), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(key.decisions.of(reference::Subject::sphere), "hit");
    EXPECT_EQ(key.decisions.of(reference::Subject::triangle), "boundary");
    EXPECT_EQ(key.decisions.first, "triangle");
    EXPECT_EQ(key.decisions.policy, std::vector<std::string>{"boundary"});
}

TEST(CertifiedKey, MatchesTheHandDerivationOfA6_Edge) {
    const AnswerKey key = key_of("a6-edge");
    expect_item(key, 1, "P_VCS", {0, 0, -2}, true);
    // eye - lookat = (6, 0, 0), so Z = x, X = y cross x = -z.
    expect_item(key, 2, "X_vcs", {0, 0, -1}, true);
    expect_item(key, 2, "Y_vcs", {0, 1, 0}, true);
    expect_item(key, 2, "Z_vcs", {1, 0, 0}, true);
    expect_item(key, 3, "M_VCS_to_WCS", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 6, 1, 0, 1}, true);
    expect_item(key, 4, "P_WCS", {4, 1, 0}, true);
    expect_item(key, 5, "V", {-1, 0, 0}, true);
    // S - C = (3, 1, -1): b = 2 * -3, c = 11 - 4, d = 36 - 28, t = (6 - 2√2) / 2.
    expect_item(key, 6, "a", {1}, true);
    expect_item(key, 6, "b", {-6}, true);
    expect_item(key, 6, "c", {7}, true);
    expect_item(key, 6, "d", {8}, true);
    expect_item(key, 6, "t", {1.58578643762690495120}, false);
    expect_item(key, 6, "hit", {2.41421356237309504880, 1, 0}, false);
    expect_item(key, 7, "normal", {half_sqrt_2, 0.5, -0.5}, false);
    // B - A = (0, 0, 2), C - A = (-2, 3, 3), S - A = (1, 1, 1). By y, 3v = 1; by z, 2u + 3v = 1, so u = 0 exactly; by
    // x, t - 2v = 1.
    expect_item(key, 8, "matrix", {1, 0, 0, 0, 0, 2, -2, 3, 3}, true);
    expect_item(key, 8, "rhs", {1, 1, 1}, true);
    expect_item(key, 8, "t", {1.66666666666666666667}, false);
    expect_item(key, 8, "u", {0}, true);
    expect_item(key, 8, "v", {0.33333333333333333333}, false);
    expect_item(key, 8, "hit", {2.33333333333333333333, 1, 0}, false);
    // (B-A) x (C-A) = (-6, -4, 0).
    expect_item(key, 9, "normal", {-0.83205029433784368303, -0.55470019622522912202, 0}, false);
    EXPECT_EQ(std::get<FirstObject>(find(key, 10, "verdict")->value), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(find(key, 10, "verdict", 1), nullptr);
    EXPECT_EQ(key.decisions.of(reference::Subject::sphere), "hit");
    EXPECT_EQ(key.decisions.of(reference::Subject::triangle), "hit");
    EXPECT_EQ(key.decisions.first, "sphere");
    EXPECT_TRUE(key.decisions.policy.empty());
}

TEST(CertifiedKey, WritesEnclosuresIn17DigitsThatReadBackAsTheSameDoubles) {
    const AnswerKey key = key_of("a6-2021");
    const std::string text = to_json(key);
    // 2 - √2 lies between these two doubles.
    EXPECT_NE(text.find("\"lo\": 0.58578643762690485"), std::string::npos) << text;
    EXPECT_NE(text.find("\"hi\": 0.58578643762690497"), std::string::npos);
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["precision"], "certified");
    const auto& t = json["questions"][5]["items"][4];
    EXPECT_EQ(t["name"], "t");
    EXPECT_EQ(t["value"].get<double>(), 0.58578643762690495120);
    EXPECT_GT(t["allowance"].get<double>(), 0);
    EXPECT_EQ(json["questions"][2]["items"][0]["allowance"].size(), 4);
    EXPECT_EQ(json["decisions"]["triangle"], "boundary");
    EXPECT_EQ(json["decisions"]["policy"], nlohmann::json::array({"boundary"}));
    EXPECT_FALSE(json.contains("notes"));
}

/// The 2021 camera with these objects.
AnswerKey key_of_scene(const std::string& objects, const std::string& rubric = "",
                       std::string_view pixels = student::middle_pixel) {
    const std::string toml = student::camera_on_the_axis(4, pixels) + objects + "\n[rubric]\n" + rubric;
    return make_key(parse_assignment(toml, "scene.toml"), Precision::certified);
}

TEST(CertifiedKey, HasAHitOnTheEdgeFromBToC) {
    // The ray runs down the z axis, through the middle of the edge from (2, -2, 0) to (-2, 2, 0): u = v = 1/2.
    const AnswerKey key = key_of_scene("[[triangle]]\nvertices = [[-2, -2, 0], [2, -2, 0], [-2, 2, 0]]");
    expect_item(key, 8, "u", {0.5}, true);
    expect_item(key, 8, "v", {0.5}, true);
    EXPECT_EQ(key.decisions.of(reference::Subject::triangle), "hit");
    const AnswerKey beside =
        key_of_scene("[[triangle]]\nvertices = [[-2, -2, 0], [1.99999999999999999999, -2, 0], [-2, 2, 0]]");
    EXPECT_EQ(beside.decisions.of(reference::Subject::triangle), "miss") << "the edge passes the axis by 10^-20";
}

TEST(CertifiedKey, ComparesATriangleWithTheFarRoot) {
    // The ray starts in the sphere, at (0, 0, 2), and leaves it at z = -1, t = 3.
    const std::string sphere = "[[sphere]]\ncenter = [0, 0, 1]\nradius = 2\n[[triangle]]\nvertices = ";
    const auto first = [&](const std::string& z) {
        return key_of_scene(sphere + "[[-9, -9, " + z + "], [9, -9, " + z + "], [0, 9, " + z + "]]").decisions.first;
    };
    EXPECT_EQ(first("-1"), "tie");
    EXPECT_EQ(first("-0.99999999999999999999"), "triangle");
    EXPECT_EQ(first("-1.00000000000000000001"), "sphere");
}

TEST(CertifiedKey, ComparesATriangleWithTheNearRoot) {
    // The ray starts at (0, 0, 2) and runs through the sphere from z = 1 to z = -1.
    const auto first = [&](const std::string& z, bool turned) {
        const std::string a = "[-9, -9, " + z + "]", b = "[9, -9, " + z + "]", c = "[0, 9, " + z + "]";
        return key_of_scene("[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n[[triangle]]\nvertices = [" +
                            (turned ? b + ", " + a : a + ", " + b) + ", " + c + "]")
            .decisions.first;
    };
    for (const bool turned : {false, true}) {
        EXPECT_EQ(first("1.5", turned), "triangle") << "before the sphere";
        EXPECT_EQ(first("1", turned), "tie");
        EXPECT_EQ(first("0.5", turned), "sphere") << "inside, before the middle";
        EXPECT_EQ(first("-0.5", turned), "sphere") << "inside, behind the middle";
        EXPECT_EQ(first("-1", turned), "sphere") << "at the far root";
        EXPECT_EQ(first("-1.5", turned), "sphere") << "behind the sphere";
    }
}

TEST(CertifiedKey, AsksAboutTheNearestOfSeveralTriangles) {
    // The ray starts at (0, 0, 2) and meets z = 1 first, whichever way a triangle is turned.
    const auto triangle = [](const std::string& z, bool turned) {
        const std::string a = "[-9, -9, " + z + "]", b = "[9, -9, " + z + "]", c = "[0, 9, " + z + "]";
        return "[[triangle]]\nvertices = [" + (turned ? b + ", " + a : a + ", " + b) + ", " + c + "]\n";
    };
    for (const bool near_is_turned : {false, true}) {
        for (const bool far_is_turned : {false, true}) {
            const std::string near = triangle("1", near_is_turned), far = triangle("0", far_is_turned);
            expect_item(key_of_scene(near + far), 8, "t", {1}, true);
            expect_item(key_of_scene(far + near), 8, "t", {1}, true);
        }
    }
    const std::string missed = "[[triangle]]\nvertices = [[5, 5, 1.5], [6, 5, 1.5], [5, 6, 1.5]]\n";
    expect_item(key_of_scene(missed + triangle("1", false)), 8, "t", {1}, true);
    expect_item(key_of_scene(triangle("1", false) + missed), 8, "t", {1}, true);
}

TEST(CertifiedKey, AsksAboutTheNearestOfSeveralSpheres) {
    // Where the ray from (0, 0, 2) down the z axis meets each: on its way in at t = 1 and t = 10, on its way out at
    // t = 4 and t = 9; it passes the last one.
    const auto sphere = [](const std::string& center, const std::string& radius) {
        return "[[sphere]]\ncenter = " + center + "\nradius = " + radius + "\n";
    };
    const std::string in_1 = sphere("[0, 0, 0]", "1"), in_10 = sphere("[0, 0, -9]", "1"),
                      out_4 = sphere("[0, 0, 0.5]", "2.5"), out_9 = sphere("[0, 0, -2]", "5"),
                      missed = sphere("[9, 9, 0]", "1");
    const auto expect_t = [&](double t, const std::string& one, const std::string& other) {
        expect_item(key_of_scene(one + other), 6, "t", {t}, true);
        expect_item(key_of_scene(other + one), 6, "t", {t}, true);
    };
    expect_t(1, in_1, in_10);
    expect_t(1, in_1, out_4);
    expect_t(4, out_4, in_10);
    expect_t(4, out_4, out_9);
    expect_t(9, out_9, in_10);
    expect_t(1, in_1, missed);
    expect_t(9, out_9, missed);
}

TEST(CertifiedKey, SaysHowTheRayTouchesOrPasses) {
    const auto of_sphere = [](const std::string& x) {
        return key_of_scene("[[sphere]]\ncenter = [" + x + ", 0, 0]\nradius = 1")
            .decisions.of(reference::Subject::sphere);
    };
    EXPECT_EQ(of_sphere("1"), "tangent");
    EXPECT_EQ(of_sphere("0.99999999999999999999"), "hit");
    EXPECT_EQ(of_sphere("1.00000000000000000001"), "miss");
    // A triangle in a plane along the ray.
    const auto of_triangle = [](const std::string& x) {
        return key_of_scene("[[triangle]]\nvertices = [[" + x + ", -1, 0], [" + x + ", 1, 0], [" + x + ", 0, -3]]")
            .decisions.of(reference::Subject::triangle);
    };
    EXPECT_EQ(of_triangle("0"), "coplanar");
    EXPECT_EQ(of_triangle("0.00000000000000000001"), "miss");
}

TEST(CertifiedKey, CountsAStartOnTheSphereAsTheRubricSays) {
    // The ray starts at (0, 0, 2), where it enters the first sphere and leaves the second.
    const std::string entered = "[[sphere]]\ncenter = [0, 0, 1]\nradius = 1",
                      left = "[[sphere]]\ncenter = [0, 0, 3]\nradius = 1";
    const std::string from_zero = "boundary = \"nonnegative\"", above_zero = "boundary = \"positive\"";
    expect_item(key_of_scene(entered, from_zero), 6, "t", {0}, true);
    expect_item(key_of_scene(entered, above_zero), 6, "t", {2}, true);
    expect_item(key_of_scene(left, from_zero), 6, "t", {0}, true);
    EXPECT_TRUE(std::holds_alternative<NoValue>(find(key_of_scene(left, above_zero), 6, "t")->value));
}

TEST(CertifiedKey, PutsAGridOfOnePixelInTheMiddle) {
    const AnswerKey key = key_of_scene("", "pixel_conventions = [\"grid\"]", "width = 1\nheight = 3\npixel = [0, 2]\n");
    expect_item(key, 1, "P_VCS", {0, 1, -2}, true);
}

}  // namespace
