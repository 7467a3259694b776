// From colors to a file: bytes, threads, PNGs read by a different reader, and digests of known pictures.
#include "reference/render/picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <limits>

#include "reference/toml/assignment_error.h"
#include "tests/given/render/scenes.h"

namespace {

using namespace reference;
using namespace reference::render;

Rendering rendering_of(const PreparedScene& scene, int jobs = 1) {
    return render::render(scene, effects_of(decide_effects(scene)), jobs);
}

PreparedScene scene_file(const std::string& name) {
    return prepare_scene(load_scene(std::filesystem::path(RAYGRADE_SCENES) / name), PictureSize{64, 36});
}

TEST(ByteOf, RoundsToTheNearestByteAndClamps) {
    EXPECT_EQ(byte_of(0), 0);
    EXPECT_EQ(byte_of(1), 255);
    EXPECT_EQ(byte_of(0.5), 128);
    EXPECT_EQ(byte_of(1 / 255.0), 1);
    EXPECT_EQ(byte_of(0.49 / 255), 0);
    EXPECT_EQ(byte_of(-3), 0);
    EXPECT_EQ(byte_of(1e300), 255);
    EXPECT_EQ(byte_of(std::numeric_limits<double>::infinity()), 255);
    EXPECT_EQ(byte_of(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Picture, IsTheSameForAnyNumberOfThreads) {
    const PreparedScene scene = scene_file("glass.toml");
    const Rendering one = rendering_of(scene);
    for (const int jobs : {2, 3, 7, 64}) {
        const Rendering many = rendering_of(scene, jobs);
        EXPECT_EQ(many.picture.bytes, one.picture.bytes) << jobs;
        EXPECT_EQ(many.work, one.work);
        EXPECT_EQ(to_png(many.picture), to_png(one.picture));
    }
}

TEST(Picture, HasItsFirstRowOnTop) {
    const PreparedScene scene = scenes::prepared(scenes::with_camera(
        "[render]\nbackground = [1, 0, 0]\n" + scenes::triangle("[[-99, 1, 0], [99, 1, 0], [0, 99, 0]]")));
    const Picture picture = rendering_of(scene).picture;
    EXPECT_EQ(picture.bytes.size(), 3U * 40U * 30U);
    EXPECT_EQ(picture.bytes[0], 128) << "the triangle is above";
    EXPECT_EQ(picture.bytes[picture.bytes.size() - 3], 255) << "the background below";
}

TEST(Png, ReadsBackAsTheSamePicture) {
    const Picture picture = rendering_of(scene_file("shadowed.toml")).picture;
    const std::string file = to_png(picture);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0) << image.message;
    EXPECT_EQ(image.width, 64U);
    EXPECT_EQ(image.height, 36U);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr), 0) << image.message;
    EXPECT_EQ(bytes, picture.bytes);
    const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);  // the last chunk, by the standard
    EXPECT_EQ(file.find(end), file.size() - end.size()) << "nothing comes after its end";
}

std::string digest(const std::vector<std::uint8_t>& bytes) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 1099511628211U;
    return fmt::format("{:016x}", hash);
}

/// The digests are the same on every machine and with all compiler flags. A changed digest means a changed picture:
/// look at the picture before you update the digest.
TEST(Picture, MatchesItsRecordedDigest) {
    const auto digest_of = [](const PreparedScene& scene) { return digest(rendering_of(scene).picture.bytes); };
    EXPECT_EQ(digest_of(scenes::prepared_assignment("a6-2021")), "9cf82c62202aaa90");
    EXPECT_EQ(digest_of(scene_file("lit.toml")), "e32b45d1e4b030fa");
    EXPECT_EQ(digest_of(scene_file("shadowed.toml")), "126cd4753a6ded5b");
    EXPECT_EQ(digest_of(scene_file("mirrors.toml")), "135ce8896a972929");
    EXPECT_EQ(digest_of(scene_file("glass.toml")), "39f6c741d71c9bca");
}

/// Each scene that comes with raygrade needs exactly the effects that its name says.
TEST(Scenes, NeedTheEffectsTheyAreNamedAfter) {
    const auto effects = [](const std::string& name) { return effects_of(decide_effects(scene_file(name))); };
    EXPECT_EQ(effects("lit.toml"), (Effects{true, false, false, false, false}));
    EXPECT_EQ(effects("shadowed.toml"), (Effects{true, true, false, false, false}));
    EXPECT_EQ(effects("mirrors.toml"), (Effects{true, true, true, false, false}));
    EXPECT_EQ(effects("glass.toml"), (Effects{true, true, true, true, true}));
}

TEST(PreparedScene, RefusesAPictureThatIsTooLarge) {
    const Assignment assignment = load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    EXPECT_THROW(prepare_scene(assignment, PictureSize{1 << 20, 1 << 20}), AssignmentError);
    EXPECT_THROW(prepare_scene(assignment, PictureSize{(1 << 20) + 1, 1}), AssignmentError);
}

TEST(PreparedScene, RefusesNumbersWhoseProductsLeaveTheRangeOfDouble) {
    EXPECT_THROW(scenes::prepared(scenes::with_camera(scenes::sphere("[0, 0, 1e31]", "1"))), AssignmentError);
    EXPECT_THROW(scenes::prepared(scenes::with_camera(scenes::sphere("[0, 0, 0]", "1e-31"))), AssignmentError);
}

/// A triangle can have an area as written and none in doubles.
TEST(PreparedScene, LeavesOutTrianglesWithoutArea) {
    const PreparedScene scene = scenes::prepared(
        scenes::with_camera(scenes::triangle("[[0, 0, 0], [1, 1, 1], [2, 2, 2.00000000000000000000000001]]") +
                            scenes::triangle("[[0, 0, 0], [1e20, 1e20, 1e20], [1e20, 1e20, 100000000000000016384.0]]") +
                            scenes::triangle("[[0, 0, 0], [1, 1, 1], [1, 1, 1.0000000000000002220446049250313]]")));
    EXPECT_EQ(scene.triangles.size(), 2U);
    ASSERT_EQ(scene.notes.size(), 1U);
    for (const Vec3<double>& normal : scene.triangle_normals)
        EXPECT_NEAR(length(normal), 1, 1e-15) << "the thinnest has a normal of unit length";
}

TEST(PreparedScene, ContainsARepeatedSphereOnce) {
    const PreparedScene scene = scenes::prepared(scenes::with_camera(
        scenes::sphere("[0, 0, 0]", "1") + scenes::sphere("[0, 0, 0]", "2") + scenes::sphere("[0, 0, 0]", "1")));
    EXPECT_EQ(scene.spheres.size(), 2U);
    EXPECT_EQ(scene.notes.size(), 1U);
}

}  // namespace
