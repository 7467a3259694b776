// Textures: PNG files in, colors at points out.
#include "reference/render/scene/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/render/picture/picture.h"
#include "reference/render/scene/srgb.h"
#include "reference/toml/assignment_error.h"
#include "tests/given/message_of.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace reference;
using namespace reference::render;
using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const std::filesystem::path& path) {
    const TextureFile file{path, "scene.toml:7: material[1].texture", {}};
    return message_of<AssignmentError>([&] { Texture::load(file, ColorSpace::as_written); }, "accepted");
}

/// Red and green above, blue and white below.
const Picture four{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};

TEST(Texture, HasItsLastRowBelow) {
    const TemporaryFolder folder;
    const Texture texture = Texture::load({folder.write("t.png", to_png(four)), "", {}}, ColorSpace::as_written);
    EXPECT_EQ(texture.at(0.25, 0.25), Color(0, 0, 1));
    EXPECT_EQ(texture.at(0.75, 0.25), Color(1, 1, 1));
    EXPECT_EQ(texture.at(0.25, 0.75), Color(1, 0, 0));
    EXPECT_EQ(texture.at(0.75, 0.75), Color(0, 1, 0));
}

TEST(Texture, RepeatsAndChangesEvenlyBetweenTexels) {
    const Texture texture(2, 1, {{0, 0, 0}, {1, 0.5, 0}});
    EXPECT_EQ(texture.at(0.5, 0.5), Color(0.5, 0.25, 0));
    EXPECT_EQ(texture.at(0, 0.5), Color(0.5, 0.25, 0)) << "between the last and the first";
    EXPECT_EQ(texture.at(0.375, 0.9), Color(0.25, 0.125, 0));
    for (const double turns : {-3.0, -1.0, 1.0, 64.0}) {
        EXPECT_EQ(texture.at(0.375 + turns, 0.5 - turns), texture.at(0.375, 0.5)) << turns;
    }
    for (const double far : {1e300, -1e300, HUGE_VAL, std::nan("")}) {
        EXPECT_LE(texture.at(far, far).x, 1) << far;
        EXPECT_LE(texture.at(-1e-300, far).x, 1) << far;
    }
}

TEST(Texture, HoldsAmountsOfLightWhereColorsAreLinear) {
    const TemporaryFolder folder;
    const Picture gray{1, 1, {188, 128, 10}};
    const Texture texture = Texture::load({folder.write("t.png", to_png(gray)), "", {}}, ColorSpace::linear);
    const auto light = [](double stored) { return std::pow((stored + 0.055) / 1.055, 2.4); };
    EXPECT_NEAR(texture.at(0, 0).x, light(188 / 255.0), 1e-12);
    EXPECT_NEAR(texture.at(0, 0).y, light(128 / 255.0), 1e-12);
    EXPECT_NEAR(texture.at(0, 0).z, 10 / 255.0 / 12.92, 1e-12);
}

TEST(Texture, IsRefusedWithTheFileAndTheWayOut) {
    const TemporaryFolder folder;
    EXPECT_THAT(complaint(folder.path() / "none.png"),
                AllOf(HasSubstr("scene.toml:7: material[1].texture"), HasSubstr("none.png: no such file")));
    EXPECT_THAT(complaint(folder.write("t.png", "GIF89a")), HasSubstr("is no PNG file"));
    const std::string good = to_png(four);
    EXPECT_THAT(complaint(folder.write("t.png", good.substr(0, good.size() - 20))), HasSubstr("damaged PNG"));
    EXPECT_EQ(complaint(folder.write("t.png", good)), "accepted");
    EXPECT_THAT(complaint(folder.write("t.png", to_png({5000, 5000, std::vector<std::uint8_t>(75'000'000)}))),
                HasSubstr("5000 x 5000 texels are too many"));
}

TEST(ShareOfTurn, MatchesTheArcTangent) {
    for (int i = -720; i <= 720; ++i) {
        const double angle = i / 720.0 * std::numbers::pi;
        for (const double size : {1e-200, 1.0, 1e200}) {
            const double expected = angle / (2 * std::numbers::pi);
            const double share = share_of_turn(size * std::cos(angle), size * std::sin(angle));
            const double difference = share - expected;
            EXPECT_NEAR(difference, std::round(difference), 1e-12) << i;
            EXPECT_TRUE(0 <= share && share <= 1) << i;
        }
    }
    EXPECT_EQ(share_of_turn(0, 0), 0);
}

}  // namespace
