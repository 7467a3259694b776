// The picture agrees with the assignment's key: the ray through the key's pixel is the handout's ray, and its first hit
// is the key's.
#include <gtest/gtest.h>

#include "reference/key/answer_key.h"
#include "reference/render/visibility.h"
#include "reference/stages/scene_answers.h"
#include "tests/given/cases.h"
#include "tests/given/random_scene.h"
#include "tests/given/render/scenes.h"

namespace {

using namespace reference;
using namespace reference::render;

Hit through_the_pixel(const PreparedScene& scene, const Pixel& pixel) {
    const RowOfRays row = scene.eye.row(scene.eye.rows.at(static_cast<std::size_t>(pixel.y)));
    return first_hit(scene, {row.ray(scene.eye.columns.at(static_cast<std::size_t>(pixel.x)))});
}

/// Of an object that is hit.
double t_of(const AnswerKey& key, Subject object) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == ItemId{object, "t"}) return std::get<Numbers>(item.answers.front().value).front();
        }
    }
    throw std::logic_error("no such item");
}

Subject kind_of(const PreparedScene& scene, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: return Subject::sphere;
        case ObjectKind::triangle: return Subject::triangle;
        case ObjectKind::cylinder: break;
    }
    return Subject::cylinder;
}

/// Compares the picture with the certified key. Returns whether there is a hit to compare.
bool expect_agreement(const Assignment& assignment) {
    const PreparedScene scene = prepare_scene(assignment, {});
    const AnswerKey key = make_key(assignment, Precision::certified);
    const Hit nearest = through_the_pixel(scene, assignment.scene.pixel);
    const std::string& first = key.decisions.first;
    EXPECT_EQ(nearest.is_hit(), first != "none");
    if (!nearest.is_hit() || first == "none" || first == "tie") return false;
    const Subject object = kind_of(scene, nearest.object);
    EXPECT_EQ(to_string(object), first);
    const double t = t_of(key, object);
    EXPECT_NEAR(nearest.t, t, 1e-7 * std::max(1.0, t));
    return true;
}

TEST(Agreement, HoldsForTheKeyOfEachAssignment) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RAYGRADE_ASSIGNMENTS)) {
        SCOPED_TRACE(entry.path());
        count += expect_agreement(load_assignment(entry.path().string(), "")) ? 1 : 0;
    }
    EXPECT_GE(count, 2);
}

TEST(Agreement, HoldsForTheKeyOfRandomScenes) {
    std::uint64_t hits = 0;
    for (std::uint64_t seed = 1; seed <= cases(20); ++seed) {
        SCOPED_TRACE(seed);
        hits += expect_agreement(random_assignment(seed)) ? 1 : 0;
    }
    EXPECT_GT(hits, cases(20) / 4);
}

/// In 2021 the ray starts on the triangle, at t = 0. The rubric decides whether that is a hit.
TEST(Agreement, HoldsForEachBoundaryPolicyOfTheRubric) {
    Assignment assignment = load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    const Pixel pixel = assignment.scene.pixel;
    EXPECT_EQ(through_the_pixel(prepare_scene(assignment, {}), pixel).object, 1U);
    assignment.rubric.boundary = BoundaryPolicy::positive;
    EXPECT_EQ(through_the_pixel(prepare_scene(assignment, {}), pixel).object, 0U);
    EXPECT_TRUE(expect_agreement(assignment));
}

/// Every ray equals, to the last bit and in each convention, the double results of questions 4 and 5.
TEST(Agreement, HoldsBetweenEveryRayAndTheStages) {
    for (const PixelConvention convention : {PixelConvention::centre, PixelConvention::grid, PixelConvention::corner}) {
        Assignment assignment = load_assignment("a6-edge", RAYGRADE_ASSIGNMENTS);
        assignment.rubric.pixel_conventions = {convention};
        const PreparedScene prepared = prepare_scene(assignment, PictureSize{23, 17});
        Scene<double> scene = convert_scene<double>(assignment.scene, [](const Decimal& x) { return x.to_double(); });
        scene.window.width = 23;
        scene.window.height = 17;
        for (int y = 0; y < 17; ++y) {
            for (int x = 0; x < 23; ++x) {
                scene.pixel = {x, y};
                const CameraAnswers<double> answers = answer_camera(scene, convention);
                const auto ray = prepared.eye.row(prepared.eye.rows[static_cast<std::size_t>(y)])
                                     .ray(prepared.eye.columns[static_cast<std::size_t>(x)]);
                ASSERT_EQ(ray.origin, answers.P_WCS) << x << ", " << y;
                ASSERT_EQ(ray.direction, answers.V) << x << ", " << y;
            }
        }
    }
}

}  // namespace
