// Prints how many certified queries a second `raygrade cast` answers on one core, JSON in and out included.
// Usage: cast_bench [queries]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <sstream>

#include "reference/cast.h"
#include "tests/kernel/distributions.h"

namespace {

std::string text_of(const reference::Vec3<double>& p) {
    return fmt::format("[{},{},{}]", p.x, p.y, p.z);
}

/// A ray, a sphere and a triangle a line, as the distribution draws them: numbers with all their 17 digits.
std::string queries(const distributions::Distribution<distributions::OrderCase>& distribution, long count) {
    std::string text;
    for (long i = 0; i < count; ++i) {
        const distributions::OrderCase c = distribution.make(static_cast<std::uint64_t>(i));
        text +=
            fmt::format(
                R"({{"origin":{},"direction":{},"spheres":[{{"center":{},"radius":{}}}],"triangles":[[{},{},{}]]}})",
                text_of(c.ray.origin), text_of(c.ray.direction), text_of(c.sphere.center), c.sphere.radius,
                text_of(c.triangle.A), text_of(c.triangle.B), text_of(c.triangle.C)) +
            "\n";
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 200'000;
    for (const auto& distribution : distributions::orders()) {
        std::istringstream in(queries(distribution, count));
        std::ostringstream out;
        const auto start = std::chrono::steady_clock::now();
        const long malformed = reference::cast(in, out);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        fmt::print("{:20} {:9.0f} queries/s ({} malformed)\n", distribution.name,
                   static_cast<double>(count) / seconds.count(), malformed);
    }
    return 0;
}
