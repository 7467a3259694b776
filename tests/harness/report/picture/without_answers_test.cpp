// What a picture without answers shows.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "harness/report/picture/scene_sketch.h"
#include "harness/report/picture/view.h"
#include "reference/key/key_formats.h"
#include "reference/stages/scene_numbers.h"
#include "tests/given/report/drawn.h"
#include "tests/harness/report/picture/picture_of.h"

namespace {

using namespace harness;
using namespace harness::report;
using picture_scenes::graded;
using picture_scenes::hard_scenes;
using picture_scenes::marking_of;
using picture_scenes::Named;
using picture_scenes::random_marking;

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
    const picture::RightValues right = picture::right_values(marking.key, marking.assignment);
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
    const picture::RightHit& sphere = right.objects.at(reference::Subject::sphere);
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
        const picture::DoubleScene scene = reference::in_double(marking.assignment.scene);
        std::vector<std::string> notes;
        const picture::Frame frame = picture::choose_frame(scene, {}, false, notes);
        const auto secret = secrets(marking, scene, frame);
        const std::string svg = explaining_picture(marking, nullptr, false, "p-");
        const std::vector<picture::Point> no_secret{scene.camera.eye, scene.triangles[0].A, scene.triangles[0].B};
        for (const picture::View& view : views_of(scene, frame)) {
            shown_without += shown(svg, secret, view, frame);
            shown_with += shown(svg, no_secret, view, frame);
            all += static_cast<int>(secret.size());
        }
    }
    EXPECT_GT(all, 450);
    EXPECT_GT(shown_with, 20 * 3 * 2) << "what the handout gives is found by this very search";
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

}  // namespace
