#include "reference/render/picture.h"

#include <png.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <stdexcept>
#include <thread>

namespace reference::render {
namespace {

/// The processor time of the calling thread.
std::chrono::duration<double> processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

/// A thread's part of the rendering, except its rows.
struct Share {
    Work work;
    std::chrono::duration<double> processor_time{};
    std::exception_ptr failure;
};

/// Renders rows, taken from the top, until none is left.
Share render_rows(const PreparedScene& scene, const Effects& effects, std::atomic<int>& next_row, Picture& picture) {
    Share share;
    try {
        const auto start = processor_time();
        std::vector<Color> colors(static_cast<std::size_t>(scene.width));
        for (int row = next_row++; row < scene.height; row = next_row++) {
            render_row(scene, effects, scene.height - 1 - row, colors, share.work);
            std::uint8_t* byte = picture.bytes.data() + static_cast<std::size_t>(row) * colors.size() * 3;
            for (const Color& color : colors) {
                for (const double x : {color.x, color.y, color.z}) *byte++ = byte_of(x);
            }
        }
        share.processor_time = processor_time() - start;
    } catch (...) {
        share.failure = std::current_exception();
    }
    return share;
}

}  // namespace

std::uint8_t byte_of(double x) {
    if (!(x > 0)) return 0;
    return x < 1 ? static_cast<std::uint8_t>(x * 255 + 0.5) : 255;
}

Rendering render(const PreparedScene& scene, const Effects& effects, int jobs) {
    Rendering result;
    const auto pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    result.picture = {scene.width, scene.height, std::vector<std::uint8_t>(3 * pixels)};
    std::atomic<int> next_row = 0;
    std::vector<Share> shares(static_cast<std::size_t>(std::min(jobs, scene.height)));
    {
        std::vector<std::jthread> threads;
        for (Share& share : shares) {
            if (&share == &shares.front()) continue;
            threads.emplace_back([&] { share = render_rows(scene, effects, next_row, result.picture); });
        }
        shares.front() = render_rows(scene, effects, next_row, result.picture);
    }
    for (const Share& share : shares) {
        if (share.failure) std::rethrow_exception(share.failure);
        result.work += share.work;
        result.processor_time += share.processor_time;
    }
    return result;
}

std::string to_png(const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    const auto fail = [&] {
        const std::string why = image.message;
        png_image_free(&image);
        throw std::runtime_error("no PNG of the picture: " + why);
    };
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string file(size, '\0');
    if (png_image_write_to_memory(&image, file.data(), &size, 0, picture.bytes.data(), 0, nullptr) == 0) fail();
    file.resize(size);
    return file;
}

}  // namespace reference::render
