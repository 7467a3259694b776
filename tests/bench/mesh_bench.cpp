// mesh_bench [ROUNDS [TRIANGLES]]: what a ray hits first, and whether it hits anything, in four kinds of meshes, one
// ray at a time on one core, beside Embree (Wald and others, 2014), fast and robust, with the same float rays for all.
// Also counts the rays, aimed at edges and vertices, that slip through the mesh.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "reference/render/trace/visibility.h"
#include "tests/bench/contest.h"
#include "tests/bench/embree.h"
#include "tests/given/render/meshes.h"

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using meshes::Mesh;
using meshes::Rays;

namespace {

std::size_t first_hits(const PreparedScene& scene, const Rays& rays) {
    std::size_t count = 0;
    for (const auto& ray : rays) {
        count += ObjectTree::first_hit(scene, CameraRay{kernel::as_double(ray)}).is_hit() ? 1 : 0;
    }
    return count;
}

std::size_t blocked(const PreparedScene& scene, const Rays& rays) {
    std::size_t count = 0;
    for (const auto& ray : rays) {
        count += ObjectTree::is_blocked(scene, CameraRay{kernel::as_double(ray)}, HUGE_VAL) ? 1 : 0;
    }
    return count;
}

double seconds_of(const auto& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The median of what the rounds of one contestant took by those of the other one, round by round.
double ratio(const Contestant& one, const Contestant& other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < one.rounds.size(); ++i) ratios.push_back(one.rounds[i] / other.rounds[i]);
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

void compare(const Mesh& mesh, int rounds) {
    const PreparedScene scene = meshes::scene_of(mesh);
    const Embree fast(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_NONE);
    const Embree robust(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_ROBUST);
    Random random(1);
    const Rays camera = meshes::camera_rays(500);
    const Rays scattered = meshes::scattered_rays(250'000, random);
    const std::size_t aimed = mesh.aimed.size();
    fmt::print("| {}, {} triangles | certified | Embree, fast | Embree, robust | × fast | × robust |\n", mesh.name,
               mesh.faces.size());
    fmt::print("|---|---:|---:|---:|---:|---:|\n");
    const auto row = [&](const char* what, const Rays& rays, std::vector<Contestant> ways) {
        contest(ways, rounds);
        fmt::print("| {} ", what);
        for (const Contestant& way : ways) {
            fmt::print("| {:.2f} ", static_cast<double>(rays.size()) / way.quartile(2) / 1e6);
        }
        fmt::print("| {:.2f} | {:.2f} |\n", ratio(ways[1], ways[0]), ratio(ways[2], ways[0]));
    };
    for (const auto& [what, rays] : {std::pair("camera", &camera), std::pair("scattered", &scattered)}) {
        row(fmt::format("first hit, {} rays, million/s", what).c_str(), *rays,
            {{"certified", [&, r = rays] { return first_hits(scene, *r); }},
             {"fast", [&, r = rays] { return fast.hits(*r); }},
             {"robust", [&, r = rays] { return robust.hits(*r); }}});
        row(fmt::format("any hit, {} rays, million/s", what).c_str(), *rays,
            {{"certified", [&, r = rays] { return blocked(scene, *r); }},
             {"fast", [&, r = rays] { return fast.blocked(*r); }},
             {"robust", [&, r = rays] { return robust.blocked(*r); }}});
    }
    fmt::print("| slip through, of {} | {} | {} | {} | | |\n", aimed, aimed - first_hits(scene, mesh.aimed),
               aimed - fast.hits(mesh.aimed), aimed - robust.hits(mesh.aimed));
    PreparedScene again = scene;
    const double ours = seconds_of([&] { add_tree(again); });
    const double theirs = seconds_of([&] { Embree(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_ROBUST, 2); });
    fmt::print("| build, ms | {:.0f} | | {:.0f} | | {:.2f} |\n", ours * 1e3, theirs * 1e3, theirs / ours);
    const double bytes =
        static_cast<double>(scene.tree->nodes.size() * sizeof(Node) + scene.tree->leaves.size() * sizeof(Leaf));
    const auto count = static_cast<double>(mesh.faces.size());
    fmt::print("| bytes a triangle | {:.0f} | {:.0f} | {:.0f} | | |\n\n", bytes / count,
               static_cast<double>(fast.bytes()) / count, static_cast<double>(robust.bytes()) / count);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    const int size = argc > 2 ? std::max(100, std::atoi(argv[2])) : 100'000;
    Random random(20211101);
    for (const Mesh& mesh : meshes::all_kinds(static_cast<unsigned>(size), random)) compare(mesh, rounds);
}
