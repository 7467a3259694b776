// Methods in vector instructions: one loop over many rays and one object, whose numbers are stored by coordinate.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "reference/accuracy/methods/method.h"
#include "reference/kernel/batch.h"

namespace reference::accuracy {

/// Rays by coordinate: origin, then direction.
template <class T>
struct Columns {
    std::array<std::vector<T>, 6> numbers;

    kernel::Rays<T> rays() const {
        return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    }
};

/// Benign rays, all at the object of problems.front(), in both precisions.
template <template <class> class Problem>
struct BlockRays {
    Columns<float> floats;
    Columns<double> doubles;
    std::vector<Problem<double>> problems;  ///< one per ray
};

BlockRays<SphereProblem> rays_at_a_sphere(std::uint64_t seed, std::uint64_t count);
BlockRays<TriangleProblem> rays_at_a_triangle(std::uint64_t seed, std::uint64_t count);

template <template <class> class Problem>
struct BlockMethod {
    std::string kernel;
    std::string scalar;
    std::string source;
    bool gives_t = true;
    bool certain = false;
    std::function<std::vector<Answer>(const BlockRays<Problem>& rays)> judge{};  ///< returns the answers
    std::function<void(const BlockRays<Problem>& rays)> run{};                   ///< for timing

    std::string name() const { return kernel + " " + scalar; }
};

std::vector<BlockMethod<SphereProblem>> sphere_block_methods();
std::vector<BlockMethod<TriangleProblem>> triangle_block_methods();

/// All methods, each list in the order of its rows.
struct Ladder {
    std::vector<Method<SphereProblem>> spheres{};
    std::vector<Method<TriangleProblem>> triangles{};
    std::vector<Method<OrderProblem>> casts{};
    std::vector<BlockMethod<SphereProblem>> sphere_blocks{};
    std::vector<BlockMethod<TriangleProblem>> triangle_blocks{};
};

}  // namespace reference::accuracy
