// Textures from PNG files.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/toml/appearance.h"

namespace reference::render {

constexpr std::int64_t most_texels = std::int64_t{1} << 24U;

/// What the numbers of a picture and of a scene's colors mean.
enum class ColorSpace {
    as_written,  ///< the same: 0.5 is the byte 128, and light is added up in these numbers
    linear       ///< a scene's colors are amounts of light; pictures store them along sRGB's curve
};

class Texture {
  public:
    /// Transparent texels are laid over black. Throws AssignmentError, which names the file and the way out, where it
    /// is no PNG or holds more than most_texels.
    static Texture load(const TextureFile& file, ColorSpace space);
    /// Rows from the bottom.
    Texture(int width, int height, std::vector<Color> texels)
        : width_(width), height_(height), texels_(std::move(texels)) {}

    /// The color at (u, v), which is (0, 0) in the lower left corner, (1, 1) in the upper right one and repeats from
    /// there; between the middles of texels it changes evenly.
    Color at(double u, double v) const;

  private:
    const Color& texel(int x, int y) const {
        return texels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    }

    int width_;
    int height_;
    std::vector<Color> texels_;
};

/// The share of a whole turn from the direction (1, 0) to (x, y), from 0 to 1, within 1e-12: std::atan2 differs between
/// machines. 0 for (0, 0).
double share_of_turn(double x, double y);

}  // namespace reference::render
