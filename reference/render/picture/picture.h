// The picture of a scene, row by row on several threads. It is the same to the last byte for any number of them.
#pragma once

#include <chrono>
#include <string>

#include "reference/render/rows.h"

namespace reference::render {

struct Picture {
    int width;
    int height;
    std::vector<std::uint8_t> bytes;  ///< red, green and blue of each pixel, row by row from the top
};

struct Rendering {
    Picture picture;
    std::uint64_t camera_rays = 0;
    RayCounts rays;
    std::chrono::duration<double> processor_time{};  ///< of all threads together
};

/// `effects` may be others than the scene calls for: more change nothing, with fewer something is missing. jobs >= 1.
Rendering render(const PreparedScene& scene, const Effects& effects, int jobs);

/// 0 to 255, the nearest to 255 x; x below 0, and what is no number, is 0, x above 1 is 255.
std::uint8_t byte_of(double x);

/// The picture as a PNG file: 8 bits a channel, the same bytes for the same picture. Throws std::runtime_error where
/// the memory does not suffice.
std::string to_png(const Picture& picture);

}  // namespace reference::render
