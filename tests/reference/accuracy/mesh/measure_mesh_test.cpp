// Which answers of a method count as wrong, and what is measured. No test depends on a measured time.
#include "reference/accuracy/mesh/measure_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/accuracy/measure/measure.h"
#include "reference/accuracy/mesh/mesh_judge.h"
#include "reference/accuracy/mesh/mesh_methods.h"
#include "reference/render/scene/instructions.h"
#include "tests/reference/accuracy/mesh/every_face.h"

namespace {

using namespace reference;
using namespace reference::accuracy;
using testing::ElementsAre;
using testing::IsEmpty;

const Ray<double> at_the_diagonal{{0, 0, 5}, {0, 0, -1}};  ///< at t = 4, and at t = 6 at the diagonal behind

TEST(CertifiedHit, IsTheFirstOfAllFacesThatTheRayHits) {
    Random random(1);
    int tied = 0;
    for (const meshes::Mesh& given : meshes::all_kinds(60, random)) {
        const Mesh mesh = as_mesh(given);
        const render::PreparedScene scene = scene_of(mesh);
        for (const MeshRays& set : rays_at(mesh, 2, 25)) {
            for (const Ray<double>& ray : set.rays.doubles) {
                const auto hits = hits_by_trying(mesh, ray);
                const MeshHit certified = certified_hit(scene, ray);
                ASSERT_EQ(certified.is_hit, !hits.empty()) << mesh.name << ", " << set.distribution;
                if (hits.empty()) continue;
                ASSERT_TRUE(hits.contains(certified.face));
                EXPECT_EQ(hits.at(certified.face), first_of(hits)) << mesh.name << ", " << set.distribution;
                tied += std::count_if(hits.begin(), hits.end(),
                                      [&](const auto& hit) { return hit.second == first_of(hits); }) > 1;
            }
        }
    }
    EXPECT_GT(tied, 0) << "no ray meets an edge exactly";
}

TEST(Verdict, OnACubeWhoseAnswersAreKnown) {
    const Mesh mesh = mesh_of(cube(), "cube");
    const render::PreparedScene scene = scene_of(mesh);
    const MeshHit first = certified_hit(scene, at_the_diagonal);
    ASSERT_TRUE(first.is_hit);
    EXPECT_EQ(first.face, 0U);
    const auto given = [&](const MeshHit& hit) { return verdict(scene, at_the_diagonal, first, hit); };
    EXPECT_EQ(given({true, 0, 4}), MeshVerdict::right);
    EXPECT_EQ(given({true, 1, 4.0000001}), MeshVerdict::right) << "the other face at the diagonal";
    EXPECT_EQ(given({}), MeshVerdict::slipped);
    EXPECT_EQ(given({true, 2, 6}), MeshVerdict::slipped) << "the back";
    EXPECT_EQ(given({true, 2, 4}), MeshVerdict::slipped) << "the back, whatever its t";
    EXPECT_EQ(given({true, 0, NAN}), MeshVerdict::slipped);
    EXPECT_EQ(given({true, 5, 4.1}), MeshVerdict::right) << "a side that the ray misses, near the front";
    EXPECT_EQ(given({true, 5, 5.9}), MeshVerdict::slipped) << "a side that the ray misses, near the back";
    const Ray<double> beside{{3, 0, 5}, {0, 0, -1}};
    const MeshHit none = certified_hit(scene, beside);
    EXPECT_EQ(verdict(scene, beside, none, {}), MeshVerdict::right);
    EXPECT_EQ(verdict(scene, beside, none, {true, 0, 4}), MeshVerdict::phantom);
}

/// The rule in rationals. `hits` are all that the ray hits.
MeshVerdict verdict_by_trying(const std::map<std::uint32_t, Rational>& hits, const MeshHit& given) {
    if (hits.empty()) return given.is_hit ? MeshVerdict::phantom : MeshVerdict::right;
    if (!given.is_hit) return MeshVerdict::slipped;
    const Rational first = first_of(hits);
    if (const auto named = hits.find(given.face); named != hits.end()) {
        return named->second == first ? MeshVerdict::right : MeshVerdict::slipped;
    }
    const auto off = [&](const Rational& t) { return Rational(abs(Rational(t - Rational(given.t)))); };
    return std::all_of(hits.begin(), hits.end(), [&](const auto& hit) { return off(first) <= off(hit.second); })
               ? MeshVerdict::right
               : MeshVerdict::slipped;
}

TEST(Verdict, IsWhatTryingEveryFaceGivesForEveryMethod) {
    Random random(3);
    std::map<std::string, int> slipped;
    for (const meshes::Mesh& given : meshes::all_kinds(60, random)) {
        const Mesh mesh = as_mesh(given);
        render::PreparedScene scene = scene_of(mesh);
        const std::vector<MeshMethod> methods = mesh_methods(mesh, scene, load_embree());
        for (const MeshRays& set : rays_at(mesh, 4, 30)) {
            std::vector<std::map<std::uint32_t, Rational>> true_hits;
            for (const Ray<double>& ray : set.rays.doubles) true_hits.push_back(hits_by_trying(mesh, ray));
            for (const MeshMethod& method : methods) {
                std::vector<MeshHit> hits(true_hits.size());
                method.run(set.rays, hits.size(), hits);
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    const Ray<double>& ray = set.rays.doubles[i];
                    const MeshVerdict found = verdict(scene, ray, certified_hit(scene, ray), hits[i]);
                    EXPECT_EQ(found, verdict_by_trying(true_hits[i], hits[i]))
                        << mesh.name << ", " << set.distribution << ", " << method.kernel << " " << method.scalar;
                    if (found == MeshVerdict::slipped) ++slipped[method.kernel + " " + method.scalar];
                }
            }
        }
    }
    EXPECT_GT(slipped["textbook float"], 0);
    EXPECT_GT(slipped["textbook double"], 0);
    EXPECT_EQ(slipped["certified double"], 0);
    EXPECT_EQ(slipped["certified, AVX2 double"], 0);
}

/// Large triangles in any position, whose boxes overlap, and rays that aim at nothing.
TEST(MeshMethods, AllFindWhatTryingEveryFaceFinds) {
    Random random(5);
    std::vector<Triangle<double>> heap;
    for (int i = 0; i < 60; ++i) heap.push_back({random.point(1), random.point(1), random.point(1)});
    const Mesh mesh = mesh_of(heap, "heap");
    render::PreparedScene scene = scene_of(mesh);
    const MeshRays set = rays_at(mesh, 6, 100)[1];
    ASSERT_EQ(set.distribution, "scattered");
    std::vector<std::map<std::uint32_t, Rational>> true_hits;
    for (const Ray<double>& ray : set.rays.doubles) true_hits.push_back(hits_by_trying(mesh, ray));
    for (const MeshMethod& method : mesh_methods(mesh, scene, load_embree())) {
        SCOPED_TRACE(method.kernel + " " + method.scalar);
        std::vector<MeshHit> hits(100);
        method.run(set.rays, hits.size(), hits);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            ASSERT_EQ(hits[i].is_hit, !true_hits[i].empty());
            if (true_hits[i].empty()) continue;
            ASSERT_TRUE(true_hits[i].contains(hits[i].face));
            EXPECT_EQ(true_hits[i].at(hits[i].face), first_of(true_hits[i]));
            const auto t = first_of(true_hits[i]).convert_to<double>();
            EXPECT_NEAR(hits[i].t, t, 1e-4 * t);
        }
    }
}

Measurement measured(const Mesh& mesh, std::uint64_t seed, std::uint64_t rays,
                     const std::shared_ptr<const EmbreeLibrary>& embree) {
    MeasureOptions options;
    options.seed = seed;
    options.rays = rays;
    options.quick = true;
    Measurement measurement = nothing_measured(options);
    measure_mesh(measurement, mesh, embree, [](double) {});
    return measurement;
}

TEST(MeasureMesh, FindsThatOnlyTheCertifiedWalkLetsNoRaySlip) {
    Random random(7);
    const Measurement measurement = measured(as_mesh(meshes::dented_ball(2'000, random)), 1, 400, load_embree());
    for (const Row& row : measurement.rows) {
        SCOPED_TRACE(row.kernel + " " + row.scalar + ", " + row.distribution);
        EXPECT_EQ(row.primitive, Primitive::mesh);
        EXPECT_EQ(row.mesh, "ball");
        EXPECT_EQ(row.rays, 400U);
        EXPECT_EQ(row.certain, row.kernel.starts_with("certified"));
        EXPECT_TRUE(!row.certain || row.wrong == 0) << row.wrong;
        ASSERT_TRUE(row.t_error.has_value());
    }
    for (const char* scalar : {"float", "double"}) {
        EXPECT_TRUE(std::any_of(measurement.rows.begin(), measurement.rows.end(), [&](const Row& row) {
            return row.kernel == "textbook" && row.scalar == scalar && row.hard && row.wrong > 0;
        })) << scalar;
    }
    ASSERT_EQ(measurement.meshes.size(), 1U);
    EXPECT_EQ(measurement.meshes[0].open_edges, 0U);
}

TEST(MeasureMesh, SaysThatEmbreeIsMissingOnceAndMeasuresTheRest) {
    EXPECT_EQ(load_embree("libof-nobody.so.3"), nullptr);
    const Mesh mesh = mesh_of(cube(), "cube");
    Measurement measurement = measured(mesh, 1, 100, nullptr);
    measure_mesh(measurement, mesh_of(cube(), "again"), nullptr, [](double) {});
    EXPECT_THAT(measurement.notes, ElementsAre(embree_is_missing));
    EXPECT_EQ(measurement.meshes.size(), 2U);
    EXPECT_EQ(measurement.rows.size(), 2U * 6 * (render::all_instructions().size() + 2));
}

TEST(MeasureMesh, AddsTheRowsOfEmbreeWhereItIs) {
    const auto embree = load_embree();
    ASSERT_NE(embree, nullptr) << embree_is_missing;
    const Measurement measurement = measured(mesh_of(cube(), "cube"), 1, 100, embree);
    EXPECT_THAT(measurement.notes, IsEmpty());
    for (const char* kernel : {"Embree, fast", "Embree, robust"}) {
        EXPECT_EQ(std::count_if(measurement.rows.begin(), measurement.rows.end(),
                                [&](const Row& row) { return row.kernel == kernel && row.scalar == "float"; }),
                  6);
    }
}

TEST(MeasureMesh, GivesTheSameCountsForTheSameSeed) {
    Random random(8);
    const Mesh mesh = as_mesh(meshes::dented_ball(500, random));
    const auto counts = [&](std::uint64_t seed) {
        std::vector<std::uint64_t> all;
        for (const Row& row : measured(mesh, seed, 200, nullptr).rows) all.push_back(row.wrong);
        return all;
    };
    EXPECT_EQ(counts(1), counts(1));
    EXPECT_NE(counts(1), counts(2));
}

TEST(MeasureMesh, ReportsItsProgressUpToTheEnd) {
    std::vector<double> told;
    Measurement measurement = nothing_measured({1, 50, true, {}, {}});
    measure_mesh(measurement, mesh_of(cube(), "cube"), nullptr, [&](double done) { told.push_back(done); });
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
}

}  // namespace
