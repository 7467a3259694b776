// Which of a student's answers an explaining picture shows, and that it reveals nothing of the key.
#include "harness/report/sketch/printed_sketch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "harness/record/marking.h"
#include "harness/report/picture/layout.h"
#include "harness/report/picture/picture.h"
#include "harness/report/picture/view.h"
#include "harness/report/sketch/assignment_sketch.h"
#include "reference/key/key_formats.h"
#include "tests/given/report/drawn.h"
#include "tests/given/report/picture_scenes.h"
#include "tests/harness/report/picture/picture_of.h"

namespace {

using namespace harness;
using namespace harness::report;
using picture_scenes::graded;
using picture_scenes::hard_scenes;
using picture_scenes::marking_of;
using picture_scenes::Named;
using picture_scenes::random_marking;
using testing::HasSubstr;

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
    EXPECT_TRUE(drawn::has_text(svg, "printed, not right"));
    const std::string right = picture_of(marking, to_text(marking.key));
    EXPECT_EQ(right.find(printed_colour), std::string::npos);
    EXPECT_FALSE(drawn::has_text(right, "printed, not right"));
}

// Computed by hand: the cross is at z = -√2, where the ray leaves the sphere; the eye is at z = 4 and P_WCS at z = 2.
TEST(PrintedAnswers, AreDrawnAtThePrintedCoordinates) {
    const std::string svg = picture_of(marking_of("2021"), "Question 6: hit: (0, 0, -1.41421)\n");
    const auto in_side_view = [&](const std::string& colour) {
        for (const drawn::Spot& spot : drawn::dots_in(svg, colour)) {
            if (spot.x < 274 && spot.y > 318) return spot;
        }
        ADD_FAILURE() << colour;
        return drawn::Spot{};
    };
    const drawn::Spot eye = in_side_view("currentColor");
    const double unit = (in_side_view("#d0591c").x - eye.x) / 2;
    const double x = eye.x + (4 + std::sqrt(2)) * unit;
    bool found = false;
    for (const drawn::Spot& spot : drawn::spots_in(svg))
        found = found || (std::abs(spot.x - (x - 4)) < 0.2 && std::abs(spot.y - (eye.y - 4)) < 0.2);
    EXPECT_TRUE(found) << "the cross's upper left end";
}

TEST(PrintedAnswers, OfTheCylinderAreDrawn) {
    const Marking marking = marking_of("2024");
    const std::string wrong = picture_of(marking, "Question 4:\nt: 1.5\nP_c: (3.5, 1.2, 0)\nN: (0, 1, 0)\n");
    for (const char* name : {"P_c", "printed P_c", "N at P_c", "printed N_c"})
        EXPECT_TRUE(drawn::has_name(wrong, name)) << name;
    const std::string right = picture_of(marking, to_text(marking.key), false);
    for (const char* name : {"printed P_c", "printed N_c", "printed P_s", "center"})
        EXPECT_TRUE(drawn::has_name(right, name)) << name;
    const std::string own = picture_of(marking, "Question 4:\nt: 1\nP_c: none\nN: (0, 0, 0)\n");
    EXPECT_TRUE(drawn::has_text(own, "N_c (question 4) was printed as the zero vector: not drawn."));
}

TEST(PrintedAnswers, AreCrossesIfWrongEvenInTheImagePlane) {
    const auto crosses = [](const char* P_VCS) {
        const std::string output = std::string("Question 1: P_VCS: ") + P_VCS + "\n";
        return drawn::crosses_in(picture_of(marking_of("2021"), output, false)).size();
    };
    EXPECT_EQ(crosses("(0, 0, -2)"), 1U) << "in the key";
    EXPECT_EQ(crosses("(1, 0.5, -2)"), 2U);
}

// In an empty scene only the camera determines the frame.
TEST(WithoutAnswers, ThePrintedImagePlaneFits) {
    const std::string svg =
        picture_of(marking_of("nothing"), "Question 2:\nX_vcs: (1, 0, 0)\nY_vcs: (0, 1, 0)\nZ_vcs: (0, 0, 1)\n", false);
    EXPECT_TRUE(drawn::has_text(svg, "The image plane is drawn with the axes your program printed."));
}

TEST(PrintedAnswers, AreNamedIfTheyCannotBeDrawn) {
    const std::string svg = picture_of(marking_of("2021"),
                                       "Question 2:\nX_vcs: (0, 0, 0)\nY_vcs: (0, 50, 0)\nZ_vcs: (nan, nan, nan)\n"
                                       "Question 4: P_WCS: (1e30, 0, 0)\nQuestion 5: V: (inf, 0, 0)\n"
                                       "Question 1: P_VCS: (70, 0, -2)\n");
    for (const char* note : {"X_vcs (question 2) was printed as the zero vector: not drawn.",
                             "Y_vcs (question 2) was printed with length 50; only its direction is drawn.",
                             "Z_vcs (question 2) was printed as (nan, nan, nan): not drawn.",
                             "P_WCS (question 4) was printed as (1e30, 0, 0): beyond the frame.",
                             "V (question 5) was printed as (inf, 0, 0): not drawn.",
                             "P_VCS (question 1) was printed outside of the image plane: not drawn."})
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

// Without answers the picture is the same for every key, so it reveals nothing of the key.
TEST(WithoutAnswers, ThePictureDoesNotDependOnTheKey) {
    const auto check = [](const Marking& marking, std::uint64_t seed) {
        Graded student = graded(picture_scenes::random_output(seed, marking), marking);
        const std::string before = explaining_picture(marking, nullptr, false, "p-");
        const std::string before_printed = explaining_picture(marking, &student, false, "p-");
        Marking other = marking;
        for (reference::KeyQuestion& question : other.key.questions) {
            for (reference::KeyItem& item : question.items) {
                for (reference::Answer& answer : item.answers) {
                    if (auto* numbers = std::get_if<reference::Numbers>(&answer.value)) {
                        for (double& x : *numbers) x = 0.3 - 1.7 * x;
                    } else {
                        answer.value = reference::NoValue{};
                    }
                }
            }
        }
        using reference::Subject;
        other.key.decisions = {{{Subject::sphere, "miss"}, {Subject::triangle, "hit"}, {Subject::cylinder, "miss"}},
                               "triangle",
                               {"boundary"}};
        ASSERT_NE(explaining_picture(other, nullptr, true, "p-"), explaining_picture(marking, nullptr, true, "p-"));
        EXPECT_EQ(explaining_picture(other, nullptr, false, "p-"), before);
        EXPECT_EQ(explaining_picture(other, &student, false, "p-"), before_printed);
        EXPECT_EQ(ExplainingPictures(other, false, "c-").shared_part(),
                  ExplainingPictures(marking, false, "c-").shared_part());
    };
    for (const Named& scene : hard_scenes()) {
        SCOPED_TRACE(scene.name);
        check(marking_of(scene), 5);
    }
    for (std::uint64_t seed = 0; seed < 8; ++seed) check(random_marking(seed), seed);
}

/// The key's points and the tips of its vectors. Coordinates of the picture could reveal them.
std::vector<picture::Point> secrets(const Marking& marking, const picture::DoubleScene& scene,
                                    const picture::Frame& frame) {
    const picture::RightValues right = picture::right_values(marking.key, scene);
    std::vector<picture::Point> secrets;
    if (right.P_WCS) secrets.push_back(*right.P_WCS);
    for (const auto& [kind, met] : right.objects) {
        if (met.hit) secrets.push_back(*met.hit);
    }
    const auto tip = [&](const picture::Point& at, const std::optional<picture::Point>& vector) {
        if (vector) secrets.push_back(at + *vector * frame.arrow);
    };
    tip(scene.camera.eye, right.X_vcs);
    tip(scene.camera.eye, right.Y_vcs);
    tip(*right.P_WCS, right.V);
    const picture::RightHit sphere = right.of(reference::Subject::sphere);
    if (sphere.hit) tip(*sphere.hit, sphere.normal);
    const auto corners = picture::window_corners(scene, *right.X_vcs, *right.Y_vcs, *right.Z_vcs);
    secrets.insert(secrets.end(), corners.begin(), corners.end());
    return secrets;
}

/// How many of the points some coordinate of the picture reveals, to a third of a page unit.
int shown(const std::string& svg, const std::vector<picture::Point>& secrets, const picture::View& view,
          const picture::Frame& frame) {
    int count = 0;
    const auto spots = drawn::spots_in(svg);
    for (const picture::Point& secret : secrets) {
        const auto at = view.spot(frame.inside(secret));
        for (const drawn::Spot& spot : spots) {
            constexpr double near = 0.33;
            if (std::abs(spot.x - at.x) > near || std::abs(spot.y - at.y) > near) continue;
            ++count;
            break;
        }
    }
    return count;
}

TEST(WithoutAnswers, NoCoordinateShowsTheKeysPoints) {
    int shown_with = 0;
    int shown_without = 0;
    int all = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Marking marking = random_marking(seed);
        const picture::DoubleScene scene = picture::double_scene(marking.assignment);
        std::vector<std::string> notes;
        const picture::Frame frame = choose_frame(scene, {}, picture::Room::for_scene, notes);
        const auto secret = secrets(marking, scene, frame);
        const std::string svg = explaining_picture(marking, nullptr, false, "p-");
        const std::vector<picture::Point> no_secret{scene.camera.eye, scene.triangles[0].A, scene.triangles[0].B};
        for (const picture::View& view : parallel_views(scene, frame, {picture::side_box, picture::other_box})) {
            shown_without += shown(svg, secret, view, frame);
            shown_with += shown(svg, no_secret, view, frame);
            all += static_cast<int>(secret.size());
        }
    }
    EXPECT_GT(all, 300);
    EXPECT_GT(shown_with, 20 * 2 * 2) << "what the handout gives is found by this very search";
    EXPECT_LE(shown_without, all / 100) << "but for accidents";
}

TEST(WithoutAnswers, NoTextShowsTheKeysNumbers) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Marking marking = random_marking(seed);
        const std::string svg = explaining_picture(marking, nullptr, false, "p-");
        std::string words = svg.substr(svg.find("<desc"), svg.find("</desc>") - svg.find("<desc"));
        for (const drawn::Text& text : drawn::texts_in(svg)) words += " " + text.words;
        const auto has = [&](const std::string& number) { return words.find(number) != std::string::npos; };
        for (const reference::KeyQuestion& question : marking.key.questions) {
            for (const reference::KeyItem& item : question.items) {
                const auto* numbers = std::get_if<reference::Numbers>(&item.answers.front().value);
                if (numbers == nullptr) continue;
                for (const double x : *numbers) {
                    // Short numbers, such as 0, 1.5 or the eye's in the matrix, occur in every text.
                    if (fmt::format("{:.5g}", x) == fmt::format("{:.10g}", x)) continue;
                    EXPECT_FALSE(has(fmt::format("{:.3f}", x))) << question.number << item.spec.name << ' ' << words;
                    EXPECT_FALSE(has(fmt::format("{:.4g}", x))) << question.number << item.spec.name << ' ' << words;
                }
            }
        }
        for (const char* name :
             {"X_vcs", "Y_vcs", "Z_vcs", "P_VCS", "P_WCS", "V", "P_s", "P_t", "N at P_s", "N of ABC"})
            EXPECT_FALSE(drawn::has_name(svg, name)) << name;
        EXPECT_EQ(words.find("the ray"), std::string::npos);
    }
}

TEST(WithoutAnswers, AllPrintedAnswersAreDrawn) {
    const Marking marking = marking_of("ones");
    const std::string svg = picture_of(marking, to_text(marking.key), false);
    for (const char* name : {"X_vcs", "Y_vcs", "Z_vcs", "P_VCS", "P_WCS", "V", "P_s", "P_t", "N_s", "N_t"})
        EXPECT_TRUE(drawn::has_name(svg, fmt::format("printed {}", name))) << name;
    EXPECT_TRUE(drawn::has_text(svg, "The image plane is drawn with the axes your program printed."));
    EXPECT_TRUE(drawn::has_text(svg, "printed, right"));
}

TEST(SharedPictures, ConsistOfTheSharedPartAndLittleMore) {
    for (const char* name : {"2021", "ones", "z is up"}) {
        const Marking marking = marking_of(name);
        const ExplainingPictures pictures(marking, true, "class-");
        const std::string shared = pictures.shared_part();
        EXPECT_THAT(shared, HasSubstr("<g id=\"class-scene\">"));
        EXPECT_THAT(shared, HasSubstr(">P_s"));
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Graded student = graded(picture_scenes::random_output(seed, marking), marking);
            const std::string svg = pictures.picture(&student, fmt::format("s{}-", seed));
            EXPECT_LT(svg.size(), 6U << 10U) << seed;
            EXPECT_THAT(svg, HasSubstr("<use href=\"#class-scene\"/>"));
            EXPECT_THAT(svg, HasSubstr(fmt::format("<title id=\"s{0}-t\">", seed)));
            for (std::size_t at = svg.find(" id=\""); at != std::string::npos; at = svg.find(" id=\"", at + 1))
                EXPECT_EQ(svg.compare(at + 5, 1, "s"), 0);
        }
    }
}

// Inserts the shared part where it is used, as a browser does.
TEST(SharedPictures, KeepTheirWordsApartFromTheSharedWords) {
    for (const Named& scene : hard_scenes()) {
        const Marking marking = marking_of(scene);
        const ExplainingPictures pictures(marking, true, "class-");
        const std::vector<drawn::Text> shared = drawn::texts_in(pictures.shared_part());
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            SCOPED_TRACE(fmt::format("{}, seed {}", scene.name, seed));
            const Graded student = graded(picture_scenes::random_output(seed, marking), marking);
            const std::vector<drawn::Text> own = drawn::texts_in(pictures.picture(&student, "s-"));
            for (std::size_t i = 0; i < own.size(); ++i) {
                std::vector<drawn::Text> others = shared;
                others.insert(others.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(i));
                for (const drawn::Text& other : others) {
                    EXPECT_FALSE(own[i].left < other.right && other.left < own[i].right && own[i].top < other.bottom &&
                                 other.top < own[i].bottom)
                        << own[i].words << " over " << other.words;
                }
            }
        }
    }
}

}  // namespace
