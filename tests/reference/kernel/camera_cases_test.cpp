// The hard cases of the camera and of keys, by id: certified_answers on scenes written in decimals.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

#include "reference/key/certified_answers.h"
#include "reference/stages/scene_numbers.h"

namespace reference {
namespace {

using Written = std::array<std::string, 3>;

Decimal number(const std::string& text) {
    return *Decimal::parse(text);
}
Vec3<Decimal> point(const Written& p) {
    return {number(p[0]), number(p[1]), number(p[2])};
}

Camera<Decimal> camera(const Written& eye, const Written& lookat, const Written& vup) {
    return {point(eye), point(lookat), point(vup)};
}

const Camera<Decimal> plain_camera = camera({"0", "0", "4"}, {"0", "0", "0"}, {"0", "1", "0"});

/// A window of one pixel, from -1 to 1 on both axes, at distance 2.
const Window<Decimal> plain_window{number("-1"), number("1"), number("-1"), number("1"), number("2"), 1, 1};

ReadingAnswers answers(const Camera<Decimal>& camera, const Window<Decimal>& window = plain_window,
                       Pixel pixel = {0, 0}, const std::vector<Triangle<Decimal>>& triangles = {}) {
    CorrectPrograms programs(rational_scene(Scene<Decimal>{camera, window, pixel, {}, triangles}));
    return certified_answers(programs, {PixelConvention::centre, Boundary::nonnegative});
}

void expect(const ReadingAnswers& run, const ItemId& id, const std::vector<double>& quoted, double within) {
    SCOPED_TRACE(id.name);
    const Answer& answer = run.answers.at(id);
    const Numbers& value = std::get<Numbers>(answer.value);
    ASSERT_EQ(value.size(), quoted.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        EXPECT_NEAR(value[i], quoted[i], within);
        EXPECT_LE(answer.lo[i], value[i]);
        EXPECT_GE(answer.hi[i], value[i]);
        EXPECT_LE(answer.hi[i], std::nextafter(answer.lo[i], HUGE_VAL));
    }
}

TEST(HardCases, H5_RotatedBase) {
    const Triangle<Decimal> triangle{point({"5", "-1", "11"}), point({"-7", "8", "11"}), point({"13", "2", "8"})};
    const ReadingAnswers run =
        answers(camera({"3", "4", "12"}, {"0", "0", "0"}, {"0", "0", "1"}), plain_window, {0, 0}, {triangle});
    EXPECT_EQ(run.decisions.of(reference::Subject::triangle), "boundary");
    EXPECT_EQ(run.decisions.first, "triangle");
    // The start (33, 44, 132)/13 is A + 46/117 (B-A) + 33/117 (C-A) exactly, so t is not small: it is 0.
    expect(run, reference::item::triangle::t, {0}, 0);
    EXPECT_EQ(run.answers.at(reference::item::triangle::t).lo, Numbers{0});
    EXPECT_EQ(run.answers.at(reference::item::triangle::t).hi, Numbers{0});
    expect(run, reference::item::triangle::u, {46.0 / 117.0}, 0);
    expect(run, reference::item::triangle::v, {33.0 / 117.0}, 0);
}

TEST(HardCases, H56_FarEye) {
    const ReadingAnswers one = answers(camera({"1e8", "0", "100000001"}, {"1e8", "0", "1e8"}, {"0", "1", "0"}));
    EXPECT_FALSE(
        std::isfinite(one.answers.at(reference::item::Z_vcs).allowance[0]));  // float cannot tell eye from lookat
    expect(answers(camera({"16777217", "0", "0"}, {"16777216", "0", "0"}, {"0", "1", "0"})), reference::item::Z_vcs,
           {1, 0, 0}, 0);
}

TEST(HardCases, H58_NearPlaneOfAnySize) {
    for (const char* size : {"1e-30", "1e-170"}) {
        const Window<Decimal> window{number("0"), number(size), number("-1"), number("1"), number(size), 1, 1};
        const ReadingAnswers run = answers(camera({"0", "0", "0"}, {"0", "0", "-1"}, {"0", "1", "0"}), window);
        expect(run, reference::item::V, {.447213595, 0, -.894427191}, 1e-9);
    }
}

TEST(HardCases, H59_OnePixel) {
    expect(answers(plain_camera), reference::item::P_VCS, {0, 0, -2}, 0);
}

TEST(HardCases, H60_MirroredWindow) {
    Window<Decimal> window = plain_window;
    std::swap(window.clip_left, window.clip_right);
    window.width = 640;
    expect(answers(plain_camera, window), reference::item::P_VCS, {639.0 / 640.0, 0, -2}, 0);
}

TEST(HardCases, H61_MorePixelsThanAFloatCounts) {
    Window<Decimal> window = plain_window;
    window.width = 16777217;
    expect(answers(plain_camera, window, {16777216, 0}), reference::item::P_VCS, {.99999994039535878, 0, -2}, 1e-16);
}

TEST(HardCases, H63_NonSquarePixels) {
    const Window<Decimal> window{number("-2"), number("2"), number("-0.5"), number("0.5"), number("2"), 2, 8};
    expect(answers(plain_camera, window, {0, 0}), reference::item::P_VCS, {-1, -.4375, -2}, 0);
    expect(answers(plain_camera, window, {1, 1}), reference::item::P_VCS, {1, -.3125, -2}, 0);
}

}  // namespace
}  // namespace reference
