// The contents of an explaining picture, read from its SVG.
#include "harness/report/picture/picture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "harness/record/marking.h"
#include "harness/report/picture/printed_sketch.h"
#include "reference/key/key_formats.h"
#include "tests/given/cases.h"
#include "tests/given/golden.h"
#include "tests/given/report/drawn.h"
#include "tests/given/report/picture_scenes.h"
#include "tests/given/temporary_folder.h"
#include "tests/harness/report/picture/picture_of.h"

namespace {

using namespace harness;
using namespace harness::report;
using picture_scenes::graded;
using picture_scenes::hard_scenes;
using picture_scenes::marking_of;
using picture_scenes::Named;
using picture_scenes::random_marking;

const int random_scenes = static_cast<int>(cases(6));

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
            pictures.push_back({full, drawing(marking, with_answers)});
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

void expect_all_on_the_page(const std::string& svg) {
    const auto spots = drawn::spots_in(svg);
    EXPECT_GT(spots.size(), 40U);
    for (const drawn::Spot& spot : spots) {
        EXPECT_TRUE(spot.x >= 0 && spot.x <= drawn::width_of(svg) && spot.y >= 0 && spot.y <= drawn::height_of(svg))
            << spot.x << ' ' << spot.y;
    }
}

// Only attributes are checked: they contain no other letters next to numbers. Texts may quote a printed nan or inf.
void expect_finite_numbers(std::string svg) {
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at))
        svg.erase(at, svg.find("</text>", at) - at + 7);
    svg.erase(svg.find("<desc"), svg.find("</desc>") - svg.find("<desc"));
    for (const char* none : {"nan", "NaN", "inf", "0e", "1e", "2e", "5e"}) EXPECT_FALSE(has(svg, none)) << none;
}

void expect_safe_under_any_policy(const std::string& svg) {
    for (const char* word : {"style", "<script", "<image", "<foreignObject", "url(", "onload", "<a ", "href"})
        EXPECT_FALSE(has(svg, word)) << word;
}

TEST(ExplainingPicture, IsReadableSmallAndSafe) {
    for (const Picture& each : all_pictures()) {
        SCOPED_TRACE(each.name);
        expect_texts_apart(each.svg);
        expect_all_on_the_page(each.svg);
        expect_finite_numbers(each.svg);
        expect_safe_under_any_policy(each.svg);
        EXPECT_LT(each.svg.size(), 28U << 10U);
    }
}

TEST(ExplainingPicture, IsWellFormed) {
    const TemporaryFolder folder;
    std::size_t count = 0;
    std::string files;
    for (const Picture& each : all_pictures())
        files += ' ' + folder.write(fmt::format("{}.svg", ++count), each.svg).string();
    ASSERT_GT(count, 80);
    EXPECT_EQ(std::system(("xmllint --noout --nonet" + files).c_str()), 0);
}

// Without the coordinates, which other tests check.
TEST(ExplainingPicture, IsAsInTheGoldenFile) {
    const Marking marking = marking_of("2024");
    const std::string svg =
        picture_of(marking,
                   "Question 1:\nP_WCS: (4, 1, 0.5)\nX_vcs: (1, 0, 0)\nQuestion 4:\nt: 1.5\nP_c: (3.5, 1.2, "
                   "0)\nN: (0, 0, 0)\nQuestion 5: P_s: (1e30, 0, 0)\n");
    const std::regex coordinates(" (d|x|y|width|height|viewBox)=\"[^\"]*\"");
    EXPECT_TRUE(is_golden(std::regex_replace(svg, coordinates, ""), "explain.svg"));
}

/// The only dot of a colour in the side view, which is below the view from a corner.
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
    const std::string svg = drawing(marking_of("2021"));
    const drawn::Spot eye = dot_in_side_view(svg, "currentColor");
    const drawn::Spot P_WCS = dot_in_side_view(svg, "#d0591c");
    const drawn::Spot P_s = dot_in_side_view(svg, "#2f7fc8");
    const double unit = (P_WCS.x - eye.x) / 2;
    EXPECT_GT(unit, 15);
    EXPECT_NEAR(P_s.x, eye.x + (4 - std::sqrt(2)) * unit, 0.2);
    EXPECT_NEAR(P_s.y, eye.y, 0.11);
    EXPECT_NEAR(P_WCS.y, eye.y, 0.11);
}

TEST(ExplainingPicture, NumbersThePointsOf2021WhereTheyAre) {
    const std::string svg = drawing(marking_of("2021"));
    for (const auto& [name, colour] :
         {std::pair("eye", "currentColor"), std::pair("P_WCS", "#d0591c"), std::pair("P_s", "#2f7fc8")}) {
        const drawn::Spot dot = dot_in_side_view(svg, colour);
        const std::string number = fmt::format(", {},", drawn::number_of(svg, name));
        const auto texts = drawn::texts_in(svg);
        EXPECT_EQ(std::ranges::count_if(texts,
                                        [&](const drawn::Text& text) {
                                            return has(", " + text.words + ",", number) && drawn::is_beside(text, dot);
                                        }),
                  1)
            << name;
    }
}

bool is_number(const drawn::Text& text) {
    return text.words.find_first_not_of("0123456789, ") == std::string::npos;
}

TEST(ExplainingPicture, KeepsNumbersOffItsLines) {
    std::size_t numbers = 0, on_lines = 0;
    for (const auto& [name, svg] : all_pictures()) {
        const auto lines = drawn::lines_in(svg);
        for (const drawn::Text& text : drawn::texts_in(svg)) {
            if (!is_number(text)) continue;
            ++numbers;
            on_lines +=
                std::ranges::any_of(lines, [&](const auto& line) { return drawn::is_under(line, text); }) ? 1 : 0;
        }
    }
    EXPECT_GT(numbers, 1000U);
    EXPECT_LE(on_lines, numbers / 1000) << "a crowded picture may have no free place for a number";
}

/// Whether the spot has a number beside it, or a line that leads to one.
bool has_number(const drawn::Spot& spot, const std::vector<drawn::Text>& texts, const std::vector<drawn::Line>& lines) {
    const auto is_beside = [&](const drawn::Spot& end) {
        return std::ranges::any_of(texts, [&](const drawn::Text& text) { return drawn::is_beside(text, end); });
    };
    return is_beside(spot) || std::ranges::any_of(lines, [&](const drawn::Line& line) {
               return std::hypot(line.from.x - spot.x, line.from.y - spot.y) < 1 && is_beside(line.to);
           });
}

TEST(ExplainingPicture, LeavesNoDotWithoutANumber) {
    for (const auto& [name, svg] : all_pictures()) {
        SCOPED_TRACE(name);
        if (!name.ends_with(", with answers") || name.starts_with("seed")) continue;
        const auto texts = drawn::texts_in(svg);
        const auto lines = drawn::lines_in(svg);
        for (const char* colour : {"currentColor", "#d0591c", "#2f7fc8", "#2c8f57", "#8563d6"}) {
            for (const drawn::Spot& dot : drawn::dots_in(svg, colour))
                EXPECT_TRUE(has_number(dot, texts, lines)) << colour << " at " << dot.x << ' ' << dot.y;
        }
    }
}

// Of two spheres, the one farther from the camera is filled first.
TEST(ExplainingPicture, DrawsNearObjectsOverFarObjects) {
    const std::string camera = "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n";
    const std::string window =
        "[window]\nclip_left = -2\nclip_right = 2\nclip_bottom = -1\nclip_top = 1\nclip_near = 2\nwidth = "
        "301\nheight = 201\npixel = [150, 100]\n";
    const std::string near = "[[sphere]]\ncenter = [0, 0, 1]\nradius = 0.5\n";
    const std::string far = "[[sphere]]\ncenter = [0, 0, -3]\nradius = 0.7\n";
    for (const std::string& objects : {near + far, far + near}) {
        const std::string svg = drawing(marking_of(Named{"two", camera + window + objects}));
        std::vector<double> sizes;  // of the fills
        const std::size_t begin = svg.find("<g><path");
        const std::string first = svg.substr(begin, svg.find("</g>", begin) - begin);
        for (std::size_t at = first.find("<path d=\"M"); at != std::string::npos;
             at = first.find("<path d=\"M", at + 1)) {
            const auto spots = drawn::spots_in(first.substr(at, first.find("/>", at) + 2 - at) + "<");
            if (spots.size() < 10) continue;
            const auto [left, right] = std::ranges::minmax_element(spots, {}, &drawn::Spot::x);
            sizes.push_back(right->x - left->x);
        }
        ASSERT_EQ(sizes.size(), 2U);
        EXPECT_GT(sizes[0], sizes[1]);
    }
}

TEST(ExplainingPicture, ShowsAStartOnTheTriangleEvenIfItIsNotAHit) {
    const std::string svg =
        drawing(marking_of(Named{"no hit at 0", hard_scenes().front().toml + "[rubric]\nboundary = \"positive\"\n"}));
    EXPECT_TRUE(drawn::has_name(svg, "P_t"));
    EXPECT_TRUE(drawn::has_text(svg, "P_t: the ray starts on the triangle, t = 0."));
}

TEST(ExplainingPicture, ShowsTheKeysAnswers) {
    const auto says = [](const char* scene, const char* sentence) {
        EXPECT_TRUE(drawn::has_text(drawing(marking_of(scene)), sentence)) << scene << ": " << sentence;
    };
    says("2021", "Which object is hit first depends on whether t = 0 counts as a hit.");
    says("tangent", "P_s: the ray touches the sphere in this one point, d = 0.");
    says("starts on the sphere", "The ray starts on the sphere, c = 0.");
    says("coplanar", "The ray lies in the triangle&#39;s plane.");
    says("beside the plane", "The ray misses the triangle: it is parallel to its plane.");
    says("behind the start", "The ray misses the triangle: P_t is behind its start, t &lt; 0.");
    says("grazes an edge", "P_t: the ray hits the triangle, t = 2.");
    says("eye within", "P_s is outside the picture.");
    says("eye within", "The sphere reaches far outside the picture and is cut off.");
    says("far", "lookat is far outside the picture.");
    says("millions", "Unit vectors are drawn 2e+06 long.");
    says("a crowd", "Only 6 of 40 spheres are drawn.");
    says("2024", "P_c: the ray hits the cylinder&#39;s tube, t = 1.");
    says("2024", "cylinder, R = 1, height 4");
    says("on the cap", "P_c: the ray hits the cylinder&#39;s top cap, t = 7.11.");
    says("under the cap", "P_c: the ray hits the cylinder&#39;s bottom cap, t = 6.552.");
    says("past the cylinder", "The ray misses the cylinder.");
    says("along the tube", "P_c: the ray touches the cylinder&#39;s tube in this one point, d = 0.");
    says("starts on the cylinder", "The ray starts on the cylinder, t = 0.");
    says("within a cylinder", "The cylinder reaches far outside the picture and is cut off.");
    says("nine cylinders", "Only 6 of 9 cylinders are drawn.");
}

TEST(ExplainingPicture, NeverContradictsTheKey) {
    int missed = 0;
    for (int seed = 0; seed < random_scenes; ++seed) {
        const Marking marking = random_marking(static_cast<std::uint64_t>(seed));
        SCOPED_TRACE(seed);
        const std::string svg = drawing(marking);
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

constexpr const char* printed_colour = "#c23f9a";

TEST(PrintedVectors, AreReadAsInMarking) {
    const auto is = [](const char* printed, double x, double y, double z) {
        const auto vector = picture::printed_vector(printed);
        ASSERT_TRUE(vector) << printed;
        EXPECT_EQ(*vector, picture::Point(x, y, z)) << printed;
    };
    is("(0, -1.5, 2e3)", 0, -1.5, 2000);
    is("vec3(0.000000, 1.000000, 0.500000)", 0, 1, 0.5);
    is("vec4(1.000000, 2.000000, 3.000000, 1.000000)", 1, 2, 3);
    is("1.5 2.5 3.5", 1.5, 2.5, 3.5);
    is("1.5; 2.5; 3.5", 1.5, 2.5, 3.5);
    EXPECT_FALSE(picture::printed_vector("none"));
    EXPECT_FALSE(picture::printed_vector("1.5 2.5"));
    EXPECT_FALSE(picture::printed_vector(""));
    const auto none = picture::printed_vector("(nan, inf, 0)");
    ASSERT_TRUE(none);
    EXPECT_FALSE(picture::is_finite(*none));
}

TEST(PrintedAnswers, AreDrawnNextToTheRightOnesIfWrong) {
    const Marking marking = marking_of("2021");
    const std::string svg = picture_of(
        marking, "Question 4: P_WCS: (0, 0, 6)\nQuestion 5: V: (0, 0, -1)\nQuestion 6: hit: (0, 0, -1.41421)\n");
    EXPECT_TRUE(drawn::has_name(svg, "printed P_WCS"));
    EXPECT_TRUE(drawn::has_name(svg, "P_WCS"));
    EXPECT_TRUE(drawn::has_name(svg, "printed P_s"));
    EXPECT_TRUE(drawn::has_name(svg, "P_s"));
    EXPECT_FALSE(drawn::has_name(svg, "printed V")) << "it is right";
    EXPECT_TRUE(drawn::has_text(svg, "printed, wrong"));
    const std::string right = picture_of(marking, to_text(marking.key));
    EXPECT_EQ(right.find(printed_colour), std::string::npos);
    EXPECT_FALSE(drawn::has_text(right, "printed, wrong"));
}

// Computed by hand: the cross is at z = -√2, where the ray leaves the sphere; the eye is at z = 4 and P_WCS at z = 2.
TEST(PrintedAnswers, AreDrawnAtThePrintedCoordinates) {
    const std::string svg = picture_of(marking_of("2021"), "Question 6: hit: (0, 0, -1.41421)\n");
    const drawn::Spot eye = dot_in_side_view(svg, "currentColor");
    const double unit = (dot_in_side_view(svg, "#d0591c").x - eye.x) / 2;
    const double x = eye.x + (4 + std::sqrt(2)) * unit;
    bool found = false;
    for (const drawn::Spot& spot : drawn::spots_in(svg))
        found = found || (std::abs(spot.x - (x - 4)) < 0.2 && std::abs(spot.y - (eye.y - 4)) < 0.2);
    EXPECT_TRUE(found) << "the cross's upper left end";
}

TEST(PrintedAnswers, AreCrossesIfWrongEvenInTheImagePlane) {
    const auto crosses = [](const char* P_VCS) {
        const std::string output = std::string("Question 1: P_VCS: ") + P_VCS + "\n";
        return drawn::crosses_in(picture_of(marking_of("2021"), output, false)).size();
    };
    EXPECT_EQ(crosses("(0, 0, -2)"), 1U) << "in the key";
    EXPECT_EQ(crosses("(1, 0.5, -2)"), 2U);
}

TEST(PrintedAnswers, AreNamedIfTheyCannotBeDrawn) {
    const std::string svg = picture_of(marking_of("2021"),
                                       "Question 2:\nX_vcs: (0, 0, 0)\nY_vcs: (0, 50, 0)\nZ_vcs: (nan, nan, nan)\n"
                                       "Question 4: P_WCS: (1e30, 0, 0)\nQuestion 5: V: (inf, 0, 0)\n"
                                       "Question 1: P_VCS: (70, 0, -2)\n");
    for (const char* note : {"X_vcs (question 2) was printed as the zero vector, so it is not drawn.",
                             "Y_vcs (question 2) was printed with length 50; only its direction is drawn.",
                             "Z_vcs (question 2) was printed as &quot;(nan, nan, nan)&quot;, so it is not drawn.",
                             "P_WCS (question 4) was printed as &quot;(1e30, 0, 0)&quot;, outside the picture.",
                             "V (question 5) was printed as &quot;(inf, 0, 0)&quot;, so it is not drawn.",
                             "P_VCS (question 1) was printed outside the image plane, so it is not drawn."})
        EXPECT_TRUE(drawn::has_text(svg, note)) << note;
    for (const char* name : {"printed X_vcs", "printed Z_vcs", "printed P_WCS", "printed V", "printed P_VCS"})
        EXPECT_FALSE(drawn::has_name(svg, name)) << name;
    EXPECT_TRUE(drawn::has_name(svg, "printed Y_vcs"));
}

TEST(PrintedAnswers, AreEscaped) {
    const Marking marking = marking_of("2021");
    Graded student = graded("", marking);
    for (QuestionScore& question : student.score.questions) {
        for (ItemScore& item : question.items) {
            item.printed = "</desc><script>\"'&\x1b[31m\xff\xef\xbf\xbe nan";
            item.verdict = ItemVerdict::wrong;
        }
    }
    for (const bool with_answers : {true, false}) {
        const std::string svg = explaining_picture(marking, &student, with_answers, "p-");
        EXPECT_EQ(svg.find("<script"), std::string::npos);
        EXPECT_NE(svg.find("&lt;script&gt;"), std::string::npos);
        EXPECT_EQ(svg.find('\x1b'), std::string::npos);
        EXPECT_LT(svg.size(), 20U << 10U);
    }
}

}  // namespace
