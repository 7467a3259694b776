// How the ray meets the cylinder in other scenes. The certified key and float programs judge it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "harness/variants/generate.h"
#include "harness/variants/random/cylinder_meeting.h"
#include "harness/variants/random/draw.h"
#include "reference/stages/item_values.h"
#include "reference/toml/assignment.h"
#include "tests/given/cases.h"

namespace harness::variants {
namespace {

using reference::CylinderPart;
using reference::Variant;
using testing::SizeIs;

const reference::Assignment& handout() {
    static const reference::Assignment a6 = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
    return a6;
}

source::PartSet parts_but(std::initializer_list<source::ScenePart> without) {
    source::PartSet parts;
    for (const source::ScenePart part : source::all_parts()) parts.insert(part);
    for (const source::ScenePart part : without) parts.erase(part);
    return parts;
}

template <class S>
reference::SceneAnswers<S> answers_in(const source::DecimalScene& scene, reference::Boundary boundary) {
    return reference::answer_scene(
        reference::convert_scene<S>(
            scene, [](const reference::Decimal& number) { return static_cast<S>(number.to_double()); }),
        reference::PixelConvention::centre, boundary);
}

reference::SceneAnswers<reference::Certified> exact_answers(const source::DecimalScene& scene) {
    return reference::answer_scene(reference::certified_scene(reference::rational_scene(scene)),
                                   reference::PixelConvention::centre, reference::Boundary::nonnegative);
}

bool is_tube(CylinderPart part) {
    return reference::tube_root(part) == reference::RootChoice::smaller;
}
bool is_cap(CylinderPart part) {
    return part == CylinderPart::top_cap || part == CylinderPart::bottom_cap;
}

TEST(CylinderScenes, MeetTheTubeACapAndMissAndEachObjectIsFirst) {
    for (std::uint64_t seed = 1; seed <= cases(15); ++seed) {
        SCOPED_TRACE(seed);
        const auto scenes = variants_for(handout(), parts_but({}), 4, seed);
        ASSERT_THAT(scenes, SizeIs(4));
        std::vector<reference::SceneAnswers<reference::Certified>> exact;
        for (const Variant& each : scenes) exact.push_back(exact_answers(each.scene));
        EXPECT_TRUE(is_tube(exact[0].cylinder->part));
        EXPECT_EQ(exact[0].first_object, reference::FirstObject(reference::Subject::sphere));
        EXPECT_TRUE(is_cap(exact[1].cylinder->part));
        EXPECT_EQ(exact[1].first_object, reference::FirstObject(reference::Subject::triangle));
        EXPECT_TRUE(is_tube(exact[2].cylinder->part));
        EXPECT_EQ(exact[2].first_object, reference::FirstObject(reference::Subject::cylinder));
        EXPECT_EQ(exact[3].cylinder->part, CylinderPart::miss);
        EXPECT_GT(exact[3].cylinder->equations.tube.d.enclosure().lo, 0) << "the endless tube is hit";
    }
}

// Float programs of other formulas differ by a few units in the last place, so the answers may not lie near an edge.
TEST(CylinderScenes, AreClearInFloat) {
    for (std::uint64_t seed = 1; seed <= cases(15); ++seed) {
        for (const Variant& each : variants_for(handout(), parts_but({}), 4, seed)) {
            SCOPED_TRACE(each.name + std::to_string(seed));
            const auto exact = exact_answers(each.scene);
            const auto floats = answers_in<float>(each.scene, reference::Boundary::positive);
            EXPECT_EQ(floats.cylinder->part, exact.cylinder->part);
            EXPECT_EQ(floats.first_object, exact.first_object);
            // Nor does it change with a cylinder that is a fiftieth wider, narrower, higher or lower.
            for (const double times : {0.98, 1.02}) {
                reference::Scene<double> scene = in_double(each.scene);
                scene.cylinders.front().radius *= times;
                const auto wider = reference::answer_scene(scene, reference::PixelConvention::centre,
                                                           reference::Boundary::nonnegative);
                EXPECT_EQ(wider.cylinder->part, exact.cylinder->part);
                scene = in_double(each.scene);
                scene.cylinders.front().height *= times;
                const auto higher = reference::answer_scene(scene, reference::PixelConvention::centre,
                                                            reference::Boundary::nonnegative);
                EXPECT_EQ(higher.cylinder->part, exact.cylinder->part);
                EXPECT_EQ(higher.first_object, exact.first_object);
            }
        }
    }
}

// The handout's ray is parallel to the caps.
TEST(CylinderScenes, MeetTheTubeWhereTheCameraStaysAndIsLevel) {
    source::PartSet cylinder;
    for (const source::ScenePart part :
         {source::part::cylinder::center, source::part::cylinder::radius, source::part::cylinder::height})
        cylinder.insert(part);
    const auto scenes = variants_for(handout(), cylinder, 4, 1);
    ASSERT_THAT(scenes, SizeIs(4));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(is_tube(exact_answers(scenes[i].scene).cylinder->part)) << i;
    EXPECT_EQ(exact_answers(scenes[3].scene).cylinder->part, CylinderPart::miss);
}

TEST(CylinderScenes, HaveNumbersThatEverySourceCanState) {
    for (const Variant& each : variants_for(handout(), parts_but({}), 8, 5)) {
        const auto cylinder = in_double(each.scene).cylinders.front();
        for (const double x : {cylinder.center.x, cylinder.center.y, cylinder.center.z, cylinder.radius})
            EXPECT_EQ(x, std::trunc(x));
        EXPECT_EQ(cylinder.height / 2, std::trunc(cylinder.height / 2)) << "the half and the caps are whole, too";
    }
}

// The meeting's numbers against points of the ray.
TEST(CylinderMeeting, LiesOnTheCylinder) {
    Draw draw(3);
    for (int i = 0; i < 200; ++i) {
        reference::CameraAnswers<double> ray{};
        ray.P_WCS = draw.vector(9);
        ray.V = reference::normalized(draw.vector(9) + reference::Vec3<double>(0.3, 0.2, 0.1));
        const reference::Cylinder<double> cylinder{draw.vector(9), double(draw.whole(1, 9)), double(draw.whole(1, 9))};
        const CylinderMeeting meeting = cylinder_meeting(ray, cylinder);
        const auto from_center = [&](double t) { return ray.P_WCS + t * ray.V - cylinder.center; };
        EXPECT_EQ(meeting.share >= 0, !std::isnan(meeting.enters));
        if (meeting.share > 0.01) {
            EXPECT_LT(meeting.enters, meeting.leaves);
            for (const double t : {meeting.enters, meeting.leaves})
                EXPECT_NEAR(std::hypot(from_center(t).x, from_center(t).z), cylinder.radius, 1e-9);
            EXPECT_NEAR(from_center(meeting.enters).y, meeting.height_at_enters * cylinder.height / 2, 1e-9);
            EXPECT_NEAR(from_center(meeting.leaves).y, meeting.height_at_leaves * cylinder.height / 2, 1e-9);
        }
        const auto at_cap = from_center(meeting.cap_t);
        EXPECT_NEAR(at_cap.y, (ray.V.y < 0 ? 1 : -1) * cylinder.height / 2, 1e-9) << "the cap that faces the ray";
        EXPECT_NEAR(meeting.cap_share,
                    1 - (at_cap.x * at_cap.x + at_cap.z * at_cap.z) / (cylinder.radius * cylinder.radius),
                    1e-6 * (1 - meeting.cap_share));
    }
}

}  // namespace
}  // namespace harness::variants
