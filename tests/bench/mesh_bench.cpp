// mesh_bench [ROUNDS [FOLDER]]: what a ray hits first, and whether it hits anything, in four kinds of meshes of 10,000,
// 100,000 and 1,000,000 triangles, one ray at a time on one core, beside Embree (Wald and others, 2014), fast and
// robust, with the same float rays for all. Also counts the rays, aimed at edges and vertices, that slip through the
// mesh. Prints a table for each mesh and writes mesh.svg, the chart of harness/manual/pictures, to FOLDER (.).
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "reference/accuracy/measure/machine.h"
#include "reference/accuracy/mesh/embree.h"
#include "reference/render/trace/visibility.h"
#include "tests/bench/contest.h"
#include "tests/bench/embree.h"
#include "tests/bench/mesh_chart.h"
#include "tests/given/render/meshes.h"

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using meshes::Mesh;
using meshes::Rays;

// What `raygrade accuracy --mesh` declares of Embree, beside Embree's own headers.
namespace abi = reference::accuracy::embree_abi;
static_assert(sizeof(abi::RayHit) == sizeof(RTCRayHit) && alignof(abi::RayHit) == alignof(RTCRayHit));
static_assert(offsetof(abi::RayHit, near) == offsetof(RTCRayHit, ray.tnear));
static_assert(offsetof(abi::RayHit, direction) == offsetof(RTCRayHit, ray.dir_x));
static_assert(offsetof(abi::RayHit, time) == offsetof(RTCRayHit, ray.time));
static_assert(offsetof(abi::RayHit, far) == offsetof(RTCRayHit, ray.tfar));
static_assert(offsetof(abi::RayHit, mask) == offsetof(RTCRayHit, ray.mask));
static_assert(offsetof(abi::RayHit, normal) == offsetof(RTCRayHit, hit.Ng_x));
static_assert(offsetof(abi::RayHit, primitive) == offsetof(RTCRayHit, hit.primID));
static_assert(offsetof(abi::RayHit, geometry) == offsetof(RTCRayHit, hit.geomID));
static_assert(sizeof(abi::Context) >= sizeof(RTCIntersectContext));
static_assert(offsetof(abi::Context, filter) == offsetof(RTCIntersectContext, filter));
static_assert(offsetof(abi::Context, instance) == offsetof(RTCIntersectContext, instID));
static_assert(abi::none == RTC_INVALID_GEOMETRY_ID && abi::triangles == RTC_GEOMETRY_TYPE_TRIANGLE);
static_assert(abi::index_buffer == RTC_BUFFER_TYPE_INDEX && abi::vertex_buffer == RTC_BUFFER_TYPE_VERTEX);
static_assert(abi::three_floats == RTC_FORMAT_FLOAT3 && abi::three_indices == RTC_FORMAT_UINT3);
static_assert(abi::robust == RTC_SCENE_FLAG_ROBUST);

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

/// The processor time of all threads.
double process_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The median of what the rounds of one contestant took by those of the other one, round by round.
double ratio(const Contestant& one, const Contestant& other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < one.rounds.size(); ++i) ratios.push_back(one.rounds[i] / other.rounds[i]);
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

/// Adds what the chart shows of the mesh to its panel.
void compare(const Mesh& mesh, int rounds, MeshPanel& panel) {
    const PreparedScene scene = meshes::scene_of(mesh);
    const Embree fast(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_NONE);
    const Embree robust(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_ROBUST);
    Random random(1);
    const Rays camera = meshes::camera_rays(200);
    const Rays scattered = meshes::scattered_rays(40'000, random);
    const std::size_t aimed = mesh.aimed.size();
    const std::vector<std::size_t> slipped{aimed - first_hits(scene, mesh.aimed), aimed - fast.hits(mesh.aimed),
                                           aimed - robust.hits(mesh.aimed)};
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
        return ways;
    };
    for (const auto& [what, rays] : {std::pair("camera", &camera), std::pair("scattered", &scattered)}) {
        const auto ways = row(fmt::format("first hit, {} rays, million/s", what).c_str(), *rays,
                              {{"certified", [&, r = rays] { return first_hits(scene, *r); }},
                               {"Embree, fast", [&, r = rays] { return fast.hits(*r); }},
                               {"Embree, robust", [&, r = rays] { return robust.hits(*r); }}});
        for (std::size_t i = 0; i < ways.size() && rays == &scattered; ++i) {
            const auto a_second = [&](int quartile) {
                return static_cast<double>(rays->size()) / ways[i].quartile(quartile);
            };
            panel.figures.push_back(
                {ways[i].name, mesh.faces.size(), a_second(2), a_second(3), a_second(1), slipped[i], aimed});
        }
        row(fmt::format("any hit, {} rays, million/s", what).c_str(), *rays,
            {{"certified", [&, r = rays] { return blocked(scene, *r); }},
             {"fast", [&, r = rays] { return fast.blocked(*r); }},
             {"robust", [&, r = rays] { return robust.blocked(*r); }}});
    }
    fmt::print("| slip through, of {} | {} | {} | {} | | |\n", aimed, slipped[0], slipped[1], slipped[2]);
    PreparedScene again = scene;
    // The round that is not timed is mostly the kernel's, for memory that nobody had before.
    std::vector<Contestant> builds{
        {"certified",
         [&] {
             add_tree(again);
             return again.tree->nodes.size();
         }},
        {"Embree, robust", [&] { return Embree(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_ROBUST).bytes(); }}};
    contest(builds, rounds, process_seconds);
    fmt::print("| build, ms of processor time | {:.0f} | | {:.0f} | | {:.2f} |\n", builds[0].quartile(2) * 1e3,
               builds[1].quartile(2) * 1e3, ratio(builds[1], builds[0]));
    const double bytes =
        static_cast<double>(scene.tree->nodes.size() * sizeof(Node) + scene.tree->leaves.size() * sizeof(Leaf));
    const auto count = static_cast<double>(mesh.faces.size());
    fmt::print("| bytes a triangle | {:.0f} | {:.0f} | {:.0f} | | |\n\n", bytes / count,
               static_cast<double>(fast.bytes()) / count, static_cast<double>(robust.bytes()) / count);
    std::fflush(stdout);
}

/// The numbers of programs that ran or waited for a core: the mean of the last minute, of 5 and of 15.
std::string load() {
    std::ifstream in("/proc/loadavg");
    std::string one;
    std::string five;
    std::string fifteen;
    in >> one >> five >> fifteen;
    return fmt::format("{}, {}, {}", one, five, fifteen);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    const std::string folder = argc > 2 ? argv[2] : ".";
    const std::string before = load();
    std::vector<MeshPanel> panels(4);
    for (const unsigned size : {10'000U, 100'000U, 1'000'000U}) {
        Random random(20211101);
        const std::vector<Mesh> kinds = meshes::all_kinds(size, random);
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            panels[i].mesh = kinds[i].name;
            compare(kinds[i], rounds, panels[i]);
        }
        const std::string machine = fmt::format(
            "One core of {}, {:%e %B %Y}, medians of {} rounds in turn, processor time; load of the machine before {}, "
            "after {}",
            accuracy::processor(), fmt::localtime(std::time(nullptr)), rounds, before, load());
        std::ofstream(folder + "/mesh.svg") << mesh_chart(panels, machine);  // also of those that are done by now
        fmt::print("{}\n\n", machine);
    }
}
