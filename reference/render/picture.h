// The picture of a scene, row by row on several threads. It is the same to the last byte for any number of them.
#pragma once

#include <chrono>
#include <string>

#include "reference/render/trace.h"

namespace reference::render {

struct Picture {
    int width;
    int height;
    std::vector<std::uint8_t> bytes;  ///< red, green and blue of each pixel, row by row from the top
};

struct Rendering {
    Picture picture;
    Work work;
    std::chrono::duration<double> processor_time{};  ///< of all threads together
};

/// `effects` may differ from the scene's: extra effects change nothing; without a needed effect the picture is
/// incomplete. jobs >= 1.
Rendering render(const PreparedScene& scene, const Effects& effects, int jobs);

/// The integer nearest to 255 x. x below 0 and NaN give 0, x above 1 gives 255.
std::uint8_t byte_of(double x);

/// The picture as a PNG file marked as sRGB: 8 bits per channel, the same bytes for the same picture. Throws
/// std::runtime_error if there is not enough memory.
std::string to_png(const Picture& picture);

}  // namespace reference::render
