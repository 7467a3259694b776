#include "harness/experiment/identify/candidate.h"

namespace harness::experiment {

using reference::Shape;

std::size_t side_of(Shape shape) {
    return shape == Shape::matrix4 ? 4 : shape == Shape::matrix3 ? 3 : 1;
}

std::size_t size_of(Shape shape) {
    return static_cast<std::size_t>(reference::component_count(shape));
}

namespace {

std::vector<Pattern> patterns_of(Shape shape, std::size_t widest, std::size_t widest_in_matrix,
                                 std::size_t most_between_rows) {
    std::vector<Pattern> patterns;
    if (shape == Shape::scalar) return {{1, 1}};
    if (shape == Shape::vector) {
        for (std::size_t step = 1; step <= widest; ++step) patterns.push_back({step, 3 * step});
        return patterns;
    }
    const std::size_t side = side_of(shape);
    for (std::size_t step = 1; step <= widest_in_matrix; ++step) {
        for (std::size_t between = 0; between <= most_between_rows; ++between)
            patterns.push_back({step, side * step + between});
    }
    return patterns;
}

}  // namespace

std::vector<Pattern> all_patterns(Shape shape) {
    return patterns_of(shape, 16, 4, 8);
}

std::vector<Pattern> common_patterns(Shape shape) {
    return patterns_of(shape, 4, 2, 1);
}

}  // namespace harness::experiment
