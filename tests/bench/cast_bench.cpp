// Prints how many certified queries per second `raygrade cast` answers on one core, including reading and writing JSON.
// Usage: cast_bench [queries]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <sstream>

#include "reference/accuracy/rays/distributions.h"
#include "reference/cast/queries.h"

namespace {

namespace accuracy = reference::accuracy;

std::string text_of(const reference::Vec3<double>& p) {
    return fmt::format("[{},{},{}]", p.x, p.y, p.z);
}

std::string text_of(const reference::Sphere<double>& sphere) {
    return fmt::format(R"({{"center":{},"radius":{}}})", text_of(sphere.center), sphere.radius);
}

std::string text_of(const reference::Triangle<double>& triangle) {
    return fmt::format("[{},{},{}]", text_of(triangle.A), text_of(triangle.B), text_of(triangle.C));
}

std::string query(const accuracy::Ray<double>& ray, const std::string& spheres, const std::string& triangles) {
    return fmt::format(R"({{"origin":{},"direction":{},"spheres":[{}],"triangles":[{}]}})", text_of(ray.origin),
                       text_of(ray.direction), spheres, triangles) +
           "\n";
}

std::string query(const accuracy::SphereCase& c) {
    return query(c.ray, text_of(c.sphere), "");
}
std::string query(const accuracy::TriangleCase& c) {
    return query(c.ray, "", text_of(c.triangle));
}
std::string query(const accuracy::OrderCase& c) {
    return query(c.ray, text_of(c.sphere), text_of(c.triangle));
}

/// Numbers with all 17 digits, as the distributions draw them.
template <class Case>
void measure(std::string_view kind, const std::vector<accuracy::Distribution<Case>>& all, long count) {
    for (const auto& distribution : all) {
        std::string text;
        for (long i = 0; i < count; ++i) text += query(distribution.make(static_cast<std::uint64_t>(i)));
        std::istringstream in(text);
        std::ostringstream out;
        const auto start = std::chrono::steady_clock::now();
        const long malformed = reference::cast::answer_queries(in, out, 1);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        fmt::print("{:20} {:30} {:9.0f} queries/s ({} malformed)\n", kind, distribution.name,
                   static_cast<double>(count) / seconds.count(), malformed);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 200'000;
    measure("sphere and triangle", accuracy::order_distributions(), count);
    measure("sphere", accuracy::sphere_distributions(), count);
    measure("triangle", accuracy::triangle_distributions(), count);
    return 0;
}
