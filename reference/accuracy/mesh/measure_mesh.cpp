#include "reference/accuracy/mesh/measure_mesh.h"

#include <algorithm>

#include "reference/accuracy/measure/statistics.h"
#include "reference/accuracy/measure/timing.h"
#include "reference/accuracy/mesh/mesh_judge.h"
#include "reference/accuracy/mesh/mesh_methods.h"

namespace reference::accuracy {
namespace {

/// Exact numbers take a thousand times as long as a filter, so only one hard ray in so many is timed.
constexpr std::size_t timed_share = 8;

/// What is true of each ray of a set.
struct MeshTruth {
    std::vector<MeshHit> first;
    std::vector<TrueAnswer> answers;
};

MeshTruth truth_of(const render::PreparedScene& scene, const MeshRays& set) {
    MeshTruth truth;
    for (const kernel::Ray<double>& ray : set.rays.doubles) {
        truth.first.push_back(certified_hit(scene, ray));
        truth.answers.push_back(true_answer(scene, ray, truth.first.back()));
    }
    return truth;
}

Row judged_row(const MeshMethod& method, const render::PreparedScene& scene, const MeshRays& set,
               const MeshTruth& truth, std::vector<MeshHit>& hits) {
    method.run(set.rays, hits.size(), hits);
    std::vector<Answer> right(hits.size());  // a wrong answer stays a miss, and is no part of t's error
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (verdict(scene, set.rays.doubles[i], truth.first[i], hits[i]) != MeshVerdict::right) {
            ++wrong;
        } else if (hits[i].is_hit) {
            right[i] = {Outcome::hit, hits[i].t, 0};
        }
    }
    Row row;
    row.primitive = Primitive::mesh;
    row.kernel = method.kernel;
    row.scalar = method.scalar;
    row.source = method.source;
    row.distribution = set.distribution;
    row.hard = set.hard;
    row.prepared = true;
    row.certain = method.certain;
    row.t_error = t_error(right, truth.answers);
    set_wrong(row, wrong, hits.size());
    return row;
}

}  // namespace

void measure_mesh(Measurement& measurement, const Mesh& mesh, const std::shared_ptr<const EmbreeLibrary>& embree,
                  const std::function<void(double)>& progress) {
    measurement.meshes.push_back({mesh.name, mesh.faces.size(), open_edges(mesh)});
    const auto is_told = [&](const std::string& note) { return note == embree_is_missing; };
    if (embree == nullptr && std::none_of(measurement.notes.begin(), measurement.notes.end(), is_told)) {
        measurement.notes.emplace_back(embree_is_missing);
    }
    render::PreparedScene scene = scene_of(mesh);
    const std::vector<MeshMethod> methods = mesh_methods(mesh, scene, embree);
    const std::vector<MeshRays> sets = rays_at(mesh, measurement.seed, measurement.rays);
    Random order(measurement.seed);
    for (std::size_t done = 0; done < sets.size(); ++done) {
        const MeshRays& set = sets[done];
        const MeshTruth truth = truth_of(scene, set);
        std::vector<MeshHit> hits(set.rays.doubles.size());
        std::vector<Row> rows;
        for (const MeshMethod& method : methods) {
            rows.push_back(judged_row(method, scene, set, truth, hits));
            rows.back().mesh = mesh.name;
        }
        const std::size_t timed =
            set.hard ? std::max(hits.size() / timed_share, std::min<std::size_t>(hits.size(), 64)) : hits.size();
        const auto times = interleaved(
            methods.size(), measurement.repetitions, order,
            [&](std::size_t i) { return time_of(timed, [&] { methods[i].run(set.rays, timed, hits); }); },
            [&](double share) { progress((static_cast<double>(done) + share) / static_cast<double>(sets.size())); });
        for (std::size_t i = 0; i < rows.size(); ++i) set_time(rows[i], times[i]);
        mark_pareto(rows);
        measurement.rows.insert(measurement.rows.end(), rows.begin(), rows.end());
    }
}

}  // namespace reference::accuracy
