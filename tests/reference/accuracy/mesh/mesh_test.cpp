// Meshes for the study, and rays at them. What a ray hits is found anew, in rationals and by trying every face.
#include "reference/accuracy/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/accuracy/mesh/mesh_rays.h"
#include "tests/reference/accuracy/mesh/every_face.h"

namespace {

using namespace reference;
using namespace reference::accuracy;

TEST(Mesh, IsClosedIfEachEdgeHasTwoFacesThatRunThroughItInOppositeWays) {
    Random random(1);
    EXPECT_EQ(open_edges(mesh_of(cube(), "cube")), 0U);
    EXPECT_EQ(open_edges(as_mesh(meshes::dented_ball(500, random))), 0U);
    EXPECT_EQ(open_edges(as_mesh(meshes::large_and_tiny(500, random))), 0U);
}

TEST(Mesh, CountsTheEdgesThatLackAFace) {
    std::vector<Triangle<double>> triangles = cube();
    triangles.pop_back();
    EXPECT_EQ(open_edges(mesh_of(triangles, "open")), 3U);
    Random random(1);
    EXPECT_EQ(open_edges(as_mesh(meshes::terrain(2 * 7 * 7, random))), 4U * 7);
}

TEST(Mesh, CountsTheEdgesOfAFaceThatIsTurned) {
    std::vector<Triangle<double>> triangles = cube();
    std::swap(triangles[4].A, triangles[4].B);
    // Each of its three edges is met twice in one way, and never in the other one.
    EXPECT_EQ(open_edges(mesh_of(triangles, "turned")), 6U);
}

TEST(Mesh, CountsAnEdgeOfFourFaces) {
    std::vector<Triangle<double>> triangles = cube();
    for (Triangle<double> triangle : cube()) {
        for (Vec3<double>* corner : {&triangle.A, &triangle.B, &triangle.C}) *corner += Vec3<double>(2, 2, 0);
        triangles.push_back(triangle);
    }
    EXPECT_EQ(open_edges(mesh_of(triangles, "two cubes that touch along an edge")), 4U);
}

TEST(Mesh, LeavesOutWhatFloatsMakeALine) {
    std::vector<Triangle<double>> triangles = cube();
    triangles.push_back({{1, 1, 1}, {1 + 1e-12, 1, 1}, {0, 5, 0}});
    const Mesh mesh = mesh_of(triangles, "cube");
    EXPECT_EQ(mesh.faces.size(), 12U);
    EXPECT_EQ(mesh.vertices.size(), 9U);
    EXPECT_THROW(mesh_of(std::span(triangles).last(1), "a line"), std::invalid_argument);
}

/// The ray's distance from a point, as a share of the way to it.
double beside(const Ray<double>& ray, const P& point) {
    const P way = point - ray.origin;
    const P off = cross(way, ray.direction);
    return std::sqrt(dot(off, off) / (dot(way, way) * dot(ray.direction, ray.direction)));
}

TEST(MeshRays, PassEdgesAndVerticesWithinTheRoundingOfFloats) {
    Random random(2);
    const Mesh mesh = as_mesh(meshes::dented_ball(200, random));
    const std::vector<MeshRays> sets = rays_at(mesh, 3, 200);
    ASSERT_EQ(sets.size(), 6U);
    EXPECT_EQ(sets[3].distribution, "at vertices");
    for (const Ray<double>& ray : sets[3].rays.doubles) {
        double least = 1;
        for (const auto& vertex : mesh.vertices) least = std::min(least, beside(ray, P(vertex)));
        EXPECT_LT(least, 1e-7);
    }
    EXPECT_EQ(sets[2].distribution, "at edges");
    for (const Ray<double>& ray : sets[2].rays.doubles) {
        double least = 1;
        for (const EdgeOfFace& edge : edges_of(mesh)) {
            // The edge's line and the ray are this far apart, if the ray crosses the edge between its ends.
            const P a(mesh.vertices[edge.from]);
            const P along = P(mesh.vertices[edge.to]) - a;
            const P normal = cross(ray.direction, along);
            const double s = dot(cross(P(a - ray.origin), ray.direction), normal) / dot(normal, normal);
            if (s >= 0 && s <= 1) least = std::min(least, beside(ray, a + scaled(along, s)));
        }
        EXPECT_LT(least, 1e-7);
    }
}

TEST(MeshRays, PassThroughVerticesAndMiddlesOfEdgesExactly) {
    Random random(2);
    const Mesh mesh = as_mesh(meshes::terrain(200, random));
    std::vector<P> middles;
    for (const EdgeOfFace& edge : edges_of(mesh)) {
        middles.push_back(scaled(P(mesh.vertices[edge.from]) + P(mesh.vertices[edge.to]), 0.5));
    }
    const std::vector<P> vertices(mesh.vertices.begin(), mesh.vertices.end());
    const std::vector<MeshRays> sets = rays_at(mesh, 3, 200);
    const auto met = [](const MeshRays& set, const std::vector<P>& places) {
        return std::count_if(set.rays.doubles.begin(), set.rays.doubles.end(), [&](const Ray<double>& ray) {
            return std::any_of(places.begin(), places.end(),
                               [&](const P& place) { return P(place - ray.origin) == ray.direction; });
        });
    };
    EXPECT_EQ(sets[4].distribution, "through edges");
    EXPECT_GE(met(sets[4], middles), 190);
    EXPECT_EQ(sets[5].distribution, "through vertices");
    EXPECT_GE(met(sets[5], vertices), 190);
}

TEST(MeshRays, ThatAimAtAClosedMeshAllHitIt) {
    Random random(4);
    for (const meshes::Mesh& given : {meshes::dented_ball(100, random), meshes::large_and_tiny(100, random)}) {
        const Mesh mesh = as_mesh(given);
        for (const MeshRays& set : rays_at(mesh, 5, 30)) {
            if (!set.hard) continue;
            for (const Ray<double>& ray : set.rays.doubles) {
                EXPECT_FALSE(hits_by_trying(mesh, ray).empty()) << mesh.name << ", " << set.distribution;
            }
        }
    }
}

TEST(MeshRays, AreTheSameForTheSameSeed) {
    const Mesh mesh = mesh_of(cube(), "cube");
    const auto numbers = [&](std::uint64_t seed) {
        std::vector<float> all;
        for (const MeshRays& set : rays_at(mesh, seed, 50)) {
            for (const auto& [origin, direction] : set.rays.floats) {
                for (const float x : {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z}) {
                    all.push_back(x);
                }
            }
        }
        return all;
    };
    EXPECT_EQ(numbers(1), numbers(1));
    EXPECT_NE(numbers(1), numbers(2));
}

}  // namespace
