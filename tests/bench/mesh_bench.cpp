// mesh_bench [ROUNDS]: compares primary visibility of a closed mesh of 100,000 triangles on one core with Embree (Wald
// and others, 2014), fast and robust, one ray at a time, with the same float rays for all. Also counts the rays from
// inside, aimed at edges and vertices, that miss the closed mesh.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/render/trace/visibility.h"
#include "reference/toml/assignment.h"

using namespace reference;
using namespace reference::render;
using Point = Vec3<float>;
using accuracy::Random;

namespace {

struct Mesh {
    std::vector<Point> vertices;
    std::vector<std::array<unsigned, 3>> faces;
};

/// A dented ball around the origin: rings of vertices between two poles.
Mesh dented_ball(unsigned rings, unsigned columns, Random& random) {
    Mesh mesh;
    const auto add = [&](double height, double turn) {
        const double size = random.between(0.97, 1);
        const double around = std::sqrt(1 - height * height) * size;
        mesh.vertices.emplace_back(static_cast<float>(around * std::cos(turn)), static_cast<float>(size * height),
                                   static_cast<float>(around * std::sin(turn)));
    };
    add(1, 0);
    for (unsigned ring = 0; ring < rings; ++ring) {
        for (unsigned column = 0; column < columns; ++column) {
            add(std::cos(std::numbers::pi * (ring + 1) / (rings + 1)), 2 * std::numbers::pi * column / columns);
        }
    }
    add(-1, 0);
    const auto vertex = [&](unsigned ring, unsigned column) { return 1 + ring * columns + column % columns; };
    const auto last = static_cast<unsigned>(mesh.vertices.size() - 1);
    for (unsigned column = 0; column < columns; ++column) {
        mesh.faces.push_back({0, vertex(0, column), vertex(0, column + 1)});
        mesh.faces.push_back({last, vertex(rings - 1, column + 1), vertex(rings - 1, column)});
        for (unsigned ring = 0; ring + 1 < rings; ++ring) {
            const unsigned a = vertex(ring, column);
            const unsigned b = vertex(ring, column + 1);
            const unsigned c = vertex(ring + 1, column + 1);
            const unsigned d = vertex(ring + 1, column);
            mesh.faces.push_back({a, d, c});
            mesh.faces.push_back({a, c, b});
        }
    }
    return mesh;
}

using Rays = std::vector<kernel::Ray<float>>;

/// The rays of a camera in front of the ball, row by row.
Rays camera_rays(int side) {
    Rays rays;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto place = [&](int i) { return static_cast<float>(-1.0 + 2.0 * (i + 0.5) / side); };
            rays.push_back({Point(0, 0, 3), Point(place(x), place(y), -2.5F)});
        }
    }
    return rays;
}

/// Rays from near the middle at each vertex and at a point of each edge.
Rays aimed_rays(const Mesh& mesh, Random& random) {
    Rays rays;
    const auto aim_at = [&](const Point& target) {
        const Point origin(random.point(0.3));
        rays.push_back({origin, target - origin});
    };
    for (const Point& vertex : mesh.vertices) aim_at(vertex);
    for (const auto& [a, b, c] : mesh.faces) {
        const Point along = mesh.vertices[b] - mesh.vertices[a];
        aim_at(mesh.vertices[a] + along * static_cast<float>(random.between(0, 1)));
    }
    return rays;
}

class Embree {
  public:
    Embree(const Mesh& mesh, RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* const vertices = static_cast<Point*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Point), mesh.vertices.size()));
        std::copy(mesh.vertices.begin(), mesh.vertices.end(), vertices);
        auto* const faces = static_cast<std::array<unsigned, 3>*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(mesh.faces[0]), mesh.faces.size()));
        std::copy(mesh.faces.begin(), mesh.faces.end(), faces);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    std::size_t hits(const Rays& rays) const {
        std::size_t count = 0;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (const auto& [origin, direction] : rays) {
            RTCRayHit hit{};
            hit.ray = {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, HUGE_VALF, ~0U, 0, 0};
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &hit);
            count += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
        return count;
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

std::size_t certified_hits(const PreparedScene& scene, const Rays& rays) {
    std::size_t count = 0;
    for (const auto& ray : rays) {
        count += ObjectTree::first_hit(scene, CameraRay{kernel::as_double(ray)}).is_hit() ? 1 : 0;
    }
    return count;
}

PreparedScene scene_of(const Mesh& mesh) {
    PreparedScene scene{};
    scene.boundary = Boundary::nonnegative;
    std::vector<Box> boxes;
    for (const auto& [a, b, c] : mesh.faces) {
        const Triangle<double> triangle{Vec3<double>(mesh.vertices[a]), Vec3<double>(mesh.vertices[b]),
                                        Vec3<double>(mesh.vertices[c])};
        scene.triangles.emplace_back(triangle);
        boxes.push_back(box_of(triangle));
    }
    scene.object_count = static_cast<std::uint32_t>(mesh.faces.size());
    scene.tree = build_tree(boxes);
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    Random random(20211101);
    const Mesh mesh = dented_ball(223, 224, random);
    const Rays rays = camera_rays(1000);
    const Rays aimed = aimed_rays(mesh, random);
    const PreparedScene scene = scene_of(mesh);
    const Embree fast(mesh, RTC_SCENE_FLAG_NONE);
    const Embree robust(mesh, RTC_SCENE_FLAG_ROBUST);
    struct Way {
        const char* name;
        std::function<std::size_t(const Rays&)> hits;
        std::vector<double> seconds;
    };
    std::array ways{Way{"certified", [&](const Rays& r) { return certified_hits(scene, r); }, {}},
                    Way{"Embree, fast", [&](const Rays& r) { return fast.hits(r); }, {}},
                    Way{"Embree, robust", [&](const Rays& r) { return robust.hits(r); }, {}}};
    for (int round = 0; round < rounds; ++round) {
        for (Way& way : ways) {
            const auto start = std::chrono::steady_clock::now();
            way.hits(rays);
            way.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
    }
    fmt::print("| {} triangles, one core | million rays/s | misses of {} at edges and vertices |\n|---|---:|---:|\n",
               mesh.faces.size(), aimed.size());
    for (Way& way : ways) {
        std::sort(way.seconds.begin(), way.seconds.end());
        const double median = way.seconds[way.seconds.size() / 2];
        fmt::print("| {} | {:.2f} | {} |\n", way.name, static_cast<double>(rays.size()) / median / 1e6,
                   aimed.size() - way.hits(aimed));
    }
}
