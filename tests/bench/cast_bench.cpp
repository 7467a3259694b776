// cast_bench [QUERIES [ROUNDS [TRIANGLES]]]: how many rays a second `raygrade cast` answers, with reading and writing:
// at four kinds of meshes as JSON lines and as records, medians of ROUNDS in random order, of one core by its own time
// and of two threads by the clock on the wall; and at one object or two that come with the ray, on one core.
#include <fmt/format.h>

#include <bit>
#include <cstdlib>
#include <sstream>

#include "reference/accuracy/rays/distributions.h"
#include "reference/cast/queries.h"
#include "reference/cast/scene_queries.h"
#include "tests/bench/contest.h"
#include "tests/given/render/meshes.h"

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
        const double start = thread_seconds();
        const long malformed = reference::cast::answer_queries(in, out, 1);
        fmt::print("{:20} {:30} {:9.0f} queries/s ({} malformed)\n", kind, distribution.name,
                   static_cast<double>(count) / (thread_seconds() - start), malformed);
    }
}

/// The rays in both forms.
struct Forms {
    std::string lines;
    std::string records;

    explicit Forms(const meshes::Rays& rays) {
        for (const auto& given : rays) {
            const auto [origin, direction] = reference::kernel::as_double(given);
            lines += fmt::format("{{\"origin\":{},\"direction\":{}}}\n", text_of(origin), text_of(direction));
            for (const auto& p : {origin, direction}) {
                for (const double x : {p.x, p.y, p.z}) {
                    const auto bits = std::bit_cast<std::uint64_t>(x);
                    for (unsigned i = 0; i < 64; i += 8) records.push_back(static_cast<char>(bits >> i));
                }
            }
        }
    }
};

void measure(const meshes::Mesh& mesh, std::size_t count, int rounds) {
    const reference::render::PreparedScene scene = meshes::scene_of(mesh);
    accuracy::Random random(1);
    const meshes::Rays camera = meshes::camera_rays(static_cast<int>(std::sqrt(static_cast<double>(count))));
    for (const auto& [what, rays] :
         {std::pair("a camera's", camera), {"scattered", meshes::scattered_rays(count, random)}}) {
        const Forms forms(rays);
        const auto lines = [&](int jobs) {
            std::istringstream in(forms.lines);
            std::ostringstream out;
            reference::cast::answer_lines(scene, in, out, jobs);
            return out.str().size();
        };
        const auto records = [&](int jobs) {
            std::istringstream in(forms.records);
            std::ostringstream out;
            reference::cast::answer_records(scene, in, out, jobs);
            return out.str().size();
        };
        std::vector<Contestant> of_a_core{{"lines", [&] { return lines(1); }}, {"records", [&] { return records(1); }}};
        std::vector<Contestant> of_two{{"lines", [&] { return lines(2); }}, {"records", [&] { return records(2); }}};
        contest(of_a_core, rounds);
        contest(of_two, rounds, wall_seconds);
        fmt::print("| {} | {} ", mesh.name, what);
        for (const Contestant& way : {of_a_core[0], of_two[0], of_a_core[1], of_two[1]}) {
            fmt::print("| {:.2f} ", static_cast<double>(rays.size()) / way.quartile(2) / 1e6);
        }
        fmt::print("|\n");
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 200'000;
    const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 9;
    const int size = argc > 3 ? std::max(100, std::atoi(argv[3])) : 100'000;
    accuracy::Random random(20211101);
    fmt::print(
        "| million rays/s | rays | JSON, one core | JSON, 2 threads | records, one core | records, 2 threads |\n");
    fmt::print("|---|---|---:|---:|---:|---:|\n");
    for (const meshes::Mesh& mesh : meshes::all_kinds(static_cast<unsigned>(size), random)) {
        measure(mesh, static_cast<std::size_t>(count), rounds);
    }
    fmt::print("\n");
    measure("sphere and triangle", accuracy::order_distributions(), count);
    measure("sphere", accuracy::sphere_distributions(), count);
    measure("triangle", accuracy::triangle_distributions(), count);
    return 0;
}
