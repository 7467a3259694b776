// Large meshes: a tree gives what trying every object gives, and every set of instructions gives the same.
#include "reference/render/scene/walk.h"

#include <gtest/gtest.h>

#include "reference/render/scene/instructions.h"
#include "reference/render/trace/visibility.h"
#include "tests/given/render/meshes.h"
#include "tests/given/render/scenes.h"

namespace {

using namespace reference;
using namespace reference::render;
using accuracy::Random;

/// Scales at which products of the scene's numbers leave the range of doubles, and where t does.
constexpr std::array scales{1.0, 0x1p-900, 0x1p-200, 0x1p200, 0x1p900};
constexpr std::array direction_scales{1.0, 0x1p-1000, 0x1p-900, 0x1p200, 0x1p900};

PreparedScene with(PreparedScene scene, Instructions instructions) {
    scene.tree->instructions = instructions;
    return scene;
}

/// Compares each set of instructions with the list of objects.
template <class AnyRay>
void expect_as_without_tree(const PreparedScene& scene, const std::vector<AnyRay>& rays) {
    for (const Instructions instructions : all_instructions()) {
        const PreparedScene walked = with(scene, instructions);
        for (const AnyRay& ray : rays) {
            const Nearest in_tree = ObjectTree::first_hit(walked, ray);
            const Nearest in_list = ObjectList::first_hit(scene, ray);
            EXPECT_EQ(in_tree.t, in_list.t);
            EXPECT_EQ(in_tree.object, in_list.object);
            EXPECT_EQ(ObjectTree::is_blocked(walked, ray, HUGE_VAL), in_list.is_hit());
        }
    }
}

CameraRay placed(const kernel::Ray<float>& ray, double scale, double direction_scale) {
    const kernel::Ray<double> given = kernel::as_double(ray);
    return {{scaled(given.origin, scale), scaled(given.direction, direction_scale)}};
}

TEST(Walk, FindsInEachKindOfMeshWhatTheListFinds) {
    Random random(1);
    for (const meshes::Mesh& mesh : meshes::all_kinds(600, random)) {
        std::vector<CameraRay> rays;
        for (const auto& ray : mesh.aimed) rays.push_back(placed(ray, 1, 1));
        for (const auto& ray : meshes::scattered_rays(500, random)) rays.push_back(placed(ray, 1, 1));
        for (const auto& ray : meshes::camera_rays(20)) rays.push_back(placed(ray, 1, 1));
        expect_as_without_tree(meshes::scene_of(mesh), rays);
    }
}

TEST(Walk, FindsTheSameWhateverTheSizeOfTheNumbers) {
    Random random(2);
    for (const meshes::Mesh& mesh : meshes::all_kinds(200, random)) {
        for (const double scale : scales) {
            std::vector<CameraRay> rays;
            for (const double direction_scale : direction_scales) {
                for (int i = 0; i < 15; ++i) {
                    const auto& ray = mesh.aimed[random.bits() % mesh.aimed.size()];
                    rays.push_back(placed(ray, scale, direction_scale));
                }
            }
            expect_as_without_tree(meshes::scene_of(mesh, scale), rays);
        }
    }
}

/// Starts that are rounded, in a scene so far from 0 that they are off by much.
TEST(Walk, FindsWhatTheListFindsOnRaysFromASurface) {
    Random random(3);
    for (const double offset : {0.0, 1e5, 1e12}) {
        const meshes::Mesh mesh = meshes::large_and_tiny(300, random);
        const PreparedScene scene = meshes::scene_of(mesh, 1, {offset, -offset, offset});
        std::vector<SurfaceRay> rays;
        for (int i = 0; i < 150; ++i) {
            const auto object = static_cast<std::uint32_t>(random.bits() % scene.object_count);
            const auto& triangle = scene.triangles[object];
            const Start start = start_on(triangle, object, triangle.A + scaled(triangle.p, 0.3));
            rays.push_back({{start.point, random.direction()}, start});
        }
        expect_as_without_tree(scene, rays);
    }
}

TEST(Walk, LetsNoRaySlipThroughAMesh) {
    Random random(4);
    for (const meshes::Mesh& mesh : meshes::all_kinds(5000, random)) {
        const PreparedScene scene = meshes::scene_of(mesh);
        for (const Instructions instructions : all_instructions()) {
            const PreparedScene walked = with(scene, instructions);
            int slipped = 0;
            for (const auto& ray : mesh.aimed) {
                if (!ObjectTree::first_hit(walked, placed(ray, 1, 1)).is_hit()) ++slipped;
            }
            EXPECT_EQ(slipped, 0) << mesh.name;
        }
    }
}

TEST(Walk, DrawsTheSamePictureWithAllInstructions) {
    for (const bool many : {false, true}) {
        const PreparedScene scene = scenes::prepared(scenes::room({true, true, true, false, many}));
        const auto expected = scenes::colors_of(with(scene, Instructions::portable), all_effects);
        for (const Instructions instructions : all_instructions()) {
            EXPECT_EQ(scenes::colors_of(with(scene, instructions), all_effects), expected);
        }
    }
}

}  // namespace
