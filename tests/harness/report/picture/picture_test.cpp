// The contents of an explaining picture, read from its SVG.
#include "harness/report/picture/picture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "harness/record/marking.h"
#include "harness/report/picture/layout.h"
#include "tests/given/cases.h"
#include "tests/given/report/drawn.h"
#include "tests/given/report/picture_scenes.h"
#include "tests/given/temporary_folder.h"
#include "tests/harness/report/picture/picture_of.h"

namespace {

using namespace harness;
using namespace harness::report;
using picture_scenes::hard_scenes;
using picture_scenes::marking_of;
using picture_scenes::Named;
using picture_scenes::random_marking;
using testing::HasSubstr;

const int random_scenes = static_cast<int>(cases(30));

std::string picture(const Marking& marking, bool with_answers = true) {
    return explaining_picture(marking, nullptr, with_answers, "p-");
}

struct Picture {
    std::string name;
    std::string svg;
};

std::vector<Picture> make_all_pictures() {
    std::vector<Picture> pictures;
    std::uint64_t seed = 1;
    const auto four = [&](const Marking& marking, const std::string& name) {
        for (const bool with_answers : {true, false}) {
            const std::string full = name + (with_answers ? ", with answers" : ", without answers");
            pictures.push_back({full, picture(marking, with_answers)});
            pictures.push_back({full + ", printed",
                                picture_of(marking, picture_scenes::random_output(++seed, marking), with_answers)});
        }
    };
    for (const Named& scene : hard_scenes()) four(marking_of(scene), scene.name);
    for (int i = 0; i < random_scenes; ++i)
        four(random_marking(static_cast<std::uint64_t>(i)), fmt::format("seed {}", i));
    return pictures;
}

const std::vector<Picture>& all_pictures() {
    static const std::vector<Picture> pictures = make_all_pictures();
    return pictures;
}

/// Calls `test` with pictures of hard scenes and random ones, with and without answers and mistakes.
template <class Test>
void for_all_pictures(Test test) {
    for (const Picture& each : all_pictures()) {
        SCOPED_TRACE(each.name);
        test(each.svg);
    }
}

bool has(const std::string& svg, const std::string& words) {
    return svg.find(words) != std::string::npos;
}

bool overlap(const drawn::Text& one, const drawn::Text& other) {
    return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

void expect_texts_apart(const std::string& svg) {
    const auto texts = drawn::texts_in(svg);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_GE(texts[i].left, 0) << texts[i].words;
        EXPECT_LE(texts[i].right, drawn::width_of(svg)) << texts[i].words;
        EXPECT_GE(texts[i].top, 0) << texts[i].words;
        EXPECT_LE(texts[i].bottom, drawn::height_of(svg)) << texts[i].words;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(texts[i], texts[j])) << texts[i].words << " over " << texts[j].words;
    }
}

TEST(ExplainingPicture, KeepsWordsApartAndOnThePage) {
    for_all_pictures(expect_texts_apart);
}

TEST(ExplainingPicture, DrawsNothingOffThePage) {
    for_all_pictures([](const std::string& svg) {
        const auto spots = drawn::spots_in(svg);
        EXPECT_GT(spots.size(), 40U);
        for (const drawn::Spot& spot : spots) {
            EXPECT_TRUE(spot.x >= 0 && spot.x <= drawn::width_of(svg) && spot.y >= 0 && spot.y <= drawn::height_of(svg))
                << spot.x << ' ' << spot.y;
        }
    });
}

TEST(ExplainingPicture, MarksWhatWasPrintedWithinTheViews) {
    using namespace harness::report::picture;
    std::size_t count = 0;
    for_all_pictures([&](const std::string& svg) {
        const Box key{first_of_key.x, first_of_key.y, page_width, perspective_box.bottom};
        for (const drawn::Spot& spot : drawn::crosses_in(svg)) {
            const auto holds = [&](const Box& box) {
                return spot.x >= box.left && spot.x <= box.right && spot.y >= box.top && spot.y <= box.bottom;
            };
            EXPECT_TRUE(holds(perspective_box) || holds(side_box) || holds(other_box) || holds(image_plane_box) ||
                        holds(key))
                << spot.x << ' ' << spot.y;
            ++count;
        }
    });
    EXPECT_GT(count, 100U);
}

// Only attributes are checked: they contain no other letters next to numbers. Texts may quote a printed nan or inf.
TEST(ExplainingPicture, ContainsOnlyFiniteNumbers) {
    for_all_pictures([](std::string svg) {
        for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at))
            svg.erase(at, svg.find("</text>", at) - at + 7);
        svg.erase(svg.find("<desc"), svg.find("</desc>") - svg.find("<desc"));
        for (const char* none : {"nan", "NaN", "inf", "0e", "1e", "2e", "5e"}) EXPECT_FALSE(has(svg, none)) << none;
    });
}

TEST(ExplainingPicture, IsWellFormed) {
    const TemporaryFolder folder;
    std::size_t count = 0;
    std::string files;
    for_all_pictures(
        [&](const std::string& svg) { files += ' ' + folder.write(fmt::format("{}.svg", ++count), svg).string(); });
    ASSERT_EQ(count, all_pictures().size());
    ASSERT_GT(count, 100);
    EXPECT_EQ(std::system(("xmllint --noout --nonet" + files).c_str()), 0);
}

TEST(ExplainingPicture, IsSafeUnderAnyPolicyAndLoadsNothing) {
    for_all_pictures([](const std::string& svg) {
        for (const char* word : {"style", "<script", "<image", "<foreignObject", "url(", "onload", "<a "})
            EXPECT_FALSE(has(svg, word)) << word;
        EXPECT_FALSE(has(svg, "href"));
    });
}

TEST(ExplainingPicture, StaysSmall) {
    for (const char* name : {"2021", "ones", "thousandths", "millions", "tangent", "floor", "z is up", "down"}) {
        const Marking marking = marking_of(name);
        EXPECT_LT(picture(marking).size(), 12U << 10U) << name;
        EXPECT_LT(picture(marking, false).size(), 8U << 10U) << name;
    }
    for_all_pictures([](const std::string& svg) { EXPECT_LT(svg.size(), 20U << 10U); });
}

TEST(ExplainingPicture, NamesEverythingAsTheHandoutDoes) {
    const std::string svg = picture(marking_of("ones"));
    for (const char* name : {"eye", "lookat", "vup", "X_vcs", "Y_vcs", "Z_vcs", "P_VCS", "P_WCS", "V", "P_s", "P_t",
                             "A", "B", "C", "N at P_s", "N at P_t"})
        EXPECT_TRUE(drawn::has_name(svg, name)) << name;
    for (const char* text : {"In perspective", "From the side", "From above", "clipLeft -2", "clipRight 2",
                             "clipBottom -1", "clipTop 1", "P_DCS (140 90)", "W x H = 301 x 201", "ray P = P_WCS + tV"})
        EXPECT_TRUE(drawn::has_text(svg, text)) << text;
}

TEST(ExplainingPicture, HasATextAlternative) {
    const std::string svg = picture(marking_of("2021"));
    EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"p-t p-d\""));
    EXPECT_THAT(svg, HasSubstr("<title id=\"p-t\">The scene</title>"));
    EXPECT_THAT(svg,
                HasSubstr("<desc id=\"p-d\">The eye at (0 0 4) looks at (0 0 0) through an image plane at distance "
                          "2. P_s: the ray hits the sphere, t = 0.5858. P_t: the ray starts on the triangle, t = "
                          "0."));
}

TEST(ExplainingPicture, IsTheSameEveryTime) {
    const Marking marking = marking_of("ones");
    const std::string output = picture_scenes::random_output(7, marking);
    EXPECT_EQ(picture(marking), picture(marking));
    EXPECT_EQ(picture_of(marking, output), picture_of(marking, output));
}

TEST(ExplainingPicture, DoesNotDependOnEarlierPictures) {
    const Marking marking = marking_of("ones");
    const ExplainingPictures shared(marking, true, "x-");
    for (int round = 0; round < 2; ++round) {
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            const Graded one = picture_scenes::graded(picture_scenes::random_output(seed, marking), marking);
            const ExplainingPictures fresh(marking, true, "x-");
            EXPECT_EQ(shared.picture(&one, "a-"), fresh.picture(&one, "a-")) << seed;
            EXPECT_EQ(shared.whole_picture(&one, "b-"), fresh.whole_picture(&one, "b-")) << seed;
        }
    }
    Graded near = picture_scenes::graded(picture_scenes::random_output(1, marking), marking);
    const std::string before = shared.whole_picture(&near, "c-");
    for (QuestionScore& question : near.score.questions) {
        for (ItemScore& item : question.items) item.verdict = ItemVerdict::right;
    }
    EXPECT_NE(shared.whole_picture(&near, "c-"), before) << "right answers are not drawn beside the right ones";
}

/// The only dot of a colour in the side view, which is below the perspective view.
drawn::Spot dot_in_side_view(const std::string& svg, const std::string& colour) {
    std::vector<drawn::Spot> found;
    for (const drawn::Spot& spot : drawn::dots_in(svg, colour)) {
        if (spot.x < 274 && spot.y > 318) found.push_back(spot);
    }
    EXPECT_EQ(found.size(), 1U) << colour;
    return found.empty() ? drawn::Spot{} : found.front();
}

// Computed by hand: the eye is at z = 4, P_WCS at z = 2 and P_s at z = √2, all on the z axis.
TEST(ExplainingPicture, PutsThePointsOf2021WhereTheyBelong) {
    const std::string svg = picture(marking_of("2021"));
    const drawn::Spot eye = dot_in_side_view(svg, "currentColor");
    const drawn::Spot P_WCS = dot_in_side_view(svg, "#d0591c");
    const drawn::Spot P_s = dot_in_side_view(svg, "#2f7fc8");
    const double unit = (P_WCS.x - eye.x) / 2;
    EXPECT_GT(unit, 15);
    EXPECT_NEAR(P_s.x, eye.x + (4 - std::sqrt(2)) * unit, 0.2);
    EXPECT_NEAR(P_s.y, eye.y, 0.11);
    EXPECT_NEAR(P_WCS.y, eye.y, 0.11);
}

// Computed by hand: the eye is at x = 6, P_WCS at x = 4 and P_c at x = 3. From the side the camera looks to the right.
TEST(ExplainingPicture, PutsTheCylinderOf2024WhereItBelongs) {
    const std::string svg = picture(marking_of("2024"));
    const drawn::Spot eye = dot_in_side_view(svg, "currentColor");
    const drawn::Spot P_WCS = dot_in_side_view(svg, "#d0591c");
    const drawn::Spot P_c = dot_in_side_view(svg, "#8563d6");
    const double unit = (P_WCS.x - eye.x) / 2;
    EXPECT_NEAR(P_c.x, eye.x + 3 * unit, 0.2);
    EXPECT_NEAR(P_c.y, eye.y, 0.11);
    // The tube's edges go from (3, 2) to (3, -2) and from (1, 2) to (1, -2); the eye is at the height 1.
    for (const auto& [x, y] : {std::pair(3, 2), {3, -2}, {1, 2}, {1, -2}}) {
        int corners = 0;
        for (const drawn::Spot& spot : drawn::spots_in(svg)) {
            const bool is_here = std::abs(spot.x - (eye.x + (6 - x) * unit)) < 0.15 &&
                                 std::abs(spot.y - (eye.y + (1 - y) * unit)) < 0.15;
            corners += is_here ? 1 : 0;
        }
        EXPECT_GE(corners, 2) << "of the fill and the edge at " << x << ' ' << y;
    }
}

TEST(ExplainingPicture, NamesThePointsOf2021WhereTheyAre) {
    const std::string svg = picture(marking_of("2021"));
    const auto leaders = drawn::leaders_in(svg);
    for (const auto& [name, colour] :
         {std::pair("eye", "currentColor"), std::pair("P_WCS", "#d0591c"), std::pair("P_s", "#2f7fc8")}) {
        const drawn::Spot dot = dot_in_side_view(svg, colour);
        int beside = 0;
        for (const drawn::Text& text : drawn::texts_in(svg)) {
            const bool is_named = (", " + text.words + ",").find(fmt::format(", {},", name)) != std::string::npos;
            beside += is_named && drawn::belongs(text, dot, leaders) ? 1 : 0;
        }
        EXPECT_EQ(beside, 1) << name;
    }
}

// If several points share a spot, the leader starts at the first.
TEST(ExplainingPicture, LeavesNoDotWithoutAName) {
    for (const Named& scene : hard_scenes()) {
        SCOPED_TRACE(scene.name);
        const std::string svg = picture(marking_of(scene));
        const auto texts = drawn::texts_in(svg);
        const auto leaders = drawn::leaders_in(svg);
        for (const char* colour : {"currentColor", "#d0591c", "#2f7fc8", "#2c8f57", "#8563d6"}) {
            for (const drawn::Spot& dot : drawn::dots_in(svg, colour)) {
                const bool is_named = std::any_of(texts.begin(), texts.end(), [&](const drawn::Text& text) {
                    return drawn::belongs(text, dot, leaders);
                });
                EXPECT_TRUE(is_named) << colour << " at " << dot.x << ' ' << dot.y;
            }
        }
    }
}

// X_vcs points at the viewer of the side view, Y_vcs and vup at the viewer of the top view.
TEST(ExplainingPicture, LeavesArrowsSeenEndOnUnnamed) {
    int seen = 0;
    for (const drawn::Text& text : drawn::texts_in(picture(marking_of("2021")))) {
        if (text.top < 318) continue;
        const bool from_side = text.right < 274;
        const auto names = [&](const char* name) { return text.words.find(name) != std::string::npos; };
        EXPECT_FALSE(from_side && names("X_vcs")) << text.words;
        EXPECT_FALSE(!from_side && (names("Y_vcs") || names("vup"))) << text.words;
        seen += names("X_vcs") || names("Y_vcs") ? 1 : 0;
    }
    EXPECT_EQ(seen, 2) << "each of them in the other view";
}

// Of two equal objects, the one nearer to the camera looks larger from behind the camera.
TEST(ExplainingPicture, DrawsNearObjectsOverFarObjects) {
    const std::string camera = "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n";
    const std::string window =
        "[window]\nclip_left = -2\nclip_right = 2\nclip_bottom = -1\nclip_top = 1\nclip_near = 2\nwidth = "
        "301\nheight = 201\npixel = [150, 100]\n";
    const std::string near = "[[sphere]]\ncenter = [0, 0, 1]\nradius = 0.5\n";
    const std::string far = "[[sphere]]\ncenter = [0, 0, -3]\nradius = 0.5\n";
    for (const std::string& objects : {near + far, far + near}) {
        const std::string svg = picture(marking_of(Named{"two", camera + window + objects}));
        std::vector<double> sizes;
        for (std::size_t at = svg.find(" rx=\""); at != std::string::npos; at = svg.find(" rx=\"", at + 1))
            sizes.push_back(std::strtod(svg.c_str() + at + 5, nullptr));
        ASSERT_EQ(sizes.size(), 2U);
        EXPECT_LT(sizes[0], sizes[1]);
    }
}

TEST(ExplainingPicture, ShowsAStartOnTheTriangleEvenIfItIsNoHit) {
    const std::string svg =
        picture(marking_of(Named{"no hit at 0", hard_scenes().front().toml + "[rubric]\nboundary = \"positive\"\n"}));
    EXPECT_TRUE(drawn::has_name(svg, "P_t"));
    EXPECT_TRUE(drawn::has_text(svg, "P_t: the ray starts on the triangle, t = 0."));
}

TEST(ExplainingPicture, ShowsTheKeysAnswers) {
    const auto says = [](const char* scene, const char* sentence) {
        EXPECT_TRUE(drawn::has_text(picture(marking_of(scene)), sentence)) << scene << ": " << sentence;
    };
    says("2021", "P_t: the ray starts on the triangle, t = 0.");
    says("2021", "Which of the two is hit first depends on whether t = 0 counts as a hit.");
    says("missed", "The ray misses the sphere.");
    says("tangent", "P_s: the ray touches the sphere in this one point, d = 0.");
    says("tangent", "The ray hits the sphere first.");
    says("starts on the sphere", "The ray starts on the sphere, c = 0.");
    says("coplanar", "The ray lies in the triangle&#39;s plane.");
    says("beside the plane", "The ray misses the triangle: it runs beside its plane.");
    says("behind the start", "The ray misses the triangle: P_t is behind its start, t &lt; 0.");
    says("grazes an edge", "P_t: the ray hits the triangle, t = 2.");
    says("eye within", "P_s lies beyond the frame.");
    says("eye within", "The sphere reaches far beyond the frame and is cut there.");
    says("far", "lookat is far beyond the frame.");
    says("millions", "Unit vectors are drawn 2e+06 long.");
    says("a crowd", "Only 6 of 40 spheres are drawn.");
    says("2024", "P_c: the ray hits the cylinder&#39;s tube, t = 1.");
    says("2024", "P_s: the ray hits the sphere.");
    says("2024", "The ray hits the cylinder first.");
    says("2024", "cylinder, R = 1, height 4");
    says("on the cap", "P_c: the ray hits the cylinder&#39;s top cap, t = 7.11.");
    says("under the cap", "P_c: the ray hits the cylinder&#39;s bottom cap, t = 6.552.");
    says("past the cylinder", "The ray misses the cylinder.");
    says("along the tube", "P_c: the ray touches the cylinder&#39;s tube in this one point, d = 0.");
    says("starts on the cylinder", "The ray starts on the cylinder, t = 0.");
    says("within a cylinder", "The cylinder reaches far beyond the frame and is cut there.");
    says("nine cylinders", "Only 6 of 9 cylinders are drawn.");
}

TEST(ExplainingPicture, NeverContradictsTheKey) {
    int missed = 0;
    for (int seed = 0; seed < random_scenes; ++seed) {
        const Marking marking = random_marking(static_cast<std::uint64_t>(seed));
        SCOPED_TRACE(seed);
        const std::string svg = picture(marking);
        const auto& decisions = marking.key.decisions;
        const bool sphere = decisions.of(reference::Subject::sphere) != "miss";
        const bool triangle = decisions.of(reference::Subject::triangle) == "hit" ||
                              decisions.of(reference::Subject::triangle) == "boundary";
        missed += sphere ? 0 : 1;
        EXPECT_EQ(drawn::has_text(svg, "The ray misses the sphere."), !sphere);
        EXPECT_EQ(!drawn::dots_in(svg, "#2f7fc8").empty(), sphere);
        EXPECT_EQ(drawn::has_name(svg, "N of ABC"), !triangle);
        EXPECT_EQ(drawn::has_text(svg, fmt::format("The ray hits the {} first.", decisions.first)),
                  decisions.first != "none" && decisions.first != "tie");
    }
    EXPECT_GT(missed, random_scenes / 10 - 1);
    EXPECT_LT(missed, random_scenes - random_scenes / 10);
}

}  // namespace
