#include "reference/render/scene/texture.h"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cmath>

#include "reference/render/scene/srgb.h"
#include "reference/toml/assignment_error.h"

namespace reference::render {
namespace {

struct Cell {
    int first;
    int second;
    double share;  ///< of the second
};

/// The two texels of `count` around x, and where between their middles it lies. x = 1 is x = 0.
Cell cell_of(double x, int count) {
    const double turn = x - std::floor(x);
    const double place = (turn < 1 ? turn : 0) * count - 0.5;
    const double below = std::floor(place);
    const int first = static_cast<int>(below) + (below < 0 ? count : 0);
    return {first, first + 1 < count ? first + 1 : 0, place - below};
}

Color between(const Color& one, const Color& other, double share) {
    return scaled(one, 1 - share) + scaled(other, share);
}

}  // namespace

Color Texture::at(double u, double v) const {
    if (!std::isfinite(u) || !std::isfinite(v)) return texel(0, 0);
    const Cell x = cell_of(u, width_);
    const Cell y = cell_of(v, height_);
    return between(between(texel(x.first, y.first), texel(x.second, y.first), x.share),
                   between(texel(x.first, y.second), texel(x.second, y.second), x.share), y.share);
}

Texture Texture::load(const TextureFile& file, ColorSpace space) {
    const std::string name = fmt::format("{}: {}", file.place, file.path.string());
    std::error_code error;
    if (!std::filesystem::is_regular_file(file.path, error)) {
        throw AssignmentError(fmt::format("{}: no such file; a texture is named from its scene's folder", name));
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto fail = [&](const std::string& what) {
        png_image_free(&image);
        throw AssignmentError(fmt::format("{}: {}", name, what));
    };
    if (png_image_begin_read_from_file(&image, file.path.c_str()) == 0) {
        fail(fmt::format("is no PNG file that can be read ({})", image.message));
    }
    if (std::int64_t{image.width} * image.height > most_texels) {
        fail(fmt::format("{} x {} texels are too many: {} million are the most; make the picture smaller", image.width,
                         image.height, most_texels / 1'000'000));
    }
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    const png_color black{0, 0, 0};
    // A negative stride: the first row in memory is the lowest.
    const auto stride = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image));
    if (png_image_finish_read(&image, &black, bytes.data(), stride, nullptr) == 0) {
        fail(fmt::format("is a damaged PNG file ({})", image.message));
    }
    std::array<double, 256> color_of{};
    for (std::size_t i = 0; i < color_of.size(); ++i) {
        const double stored = static_cast<double>(i) / 255;
        color_of.at(i) = space == ColorSpace::linear ? light_of_srgb(stored) : stored;
    }
    std::vector<Color> texels;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
        texels.emplace_back(color_of.at(bytes[i]), color_of.at(bytes[i + 1]), color_of.at(bytes[i + 2]));
    }
    return {static_cast<int>(image.width), static_cast<int>(image.height), std::move(texels)};
}

double share_of_turn(double x, double y) {
    constexpr double whole_turn = 6.283185307179586;
    if (x == 0 && y == 0) return 0;
    const double least = std::min(std::abs(x), std::abs(y)), most = std::max(std::abs(x), std::abs(y));
    // The tangent of a quarter of the angle, which is at most 11.25 degrees, by halving it twice.
    double t = least / most;
    for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
    double series = 0;
    for (int n = 15; n > 0; n -= 2) series = 1.0 / n - t * t * series;
    double share = 4 * t * series / whole_turn;
    if (std::abs(y) > std::abs(x)) share = 0.25 - share;
    if (x < 0) share = 0.5 - share;
    return y < 0 ? 1 - share : share;
}

}  // namespace reference::render
