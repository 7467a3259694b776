// A walk visits every object whose box the ray meets, whatever the size of the numbers, and few other ones.
#include "reference/render/scene/walk.h"

#include <gtest/gtest.h>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/numbers/rational.h"
#include "reference/render/scene/instructions.h"
#include "reference/render/scene/visitor.h"

namespace {

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using WalkedRay = kernel::Ray<double>;

/// Notes what is visited. Without triangles in the tree, that is every object of every leaf that the walk comes to.
class VisitedObjects final : public Visitor {
  public:
    explicit VisitedObjects(std::size_t objects) : visited(objects) {}

    bool visit(const Found& found, double& /*until*/) override {
        for (std::size_t lane = 0; lane < objects_per_leaf; ++lane) {
            if ((found.open >> lane & 1U) != 0) visited[found.leaf.objects[lane]] = true;
        }
        return false;
    }

    std::vector<bool> visited;
};

std::vector<bool> visited_by(const Tree& tree, std::size_t objects, const WalkedRay& ray, double uncertainty,
                             double until) {
    VisitedObjects visitor(objects);
    walk(tree, ray, uncertainty, until, visitor);
    return visitor.visited;
}

/// In exact numbers: whether origin + t direction is in the box for any t from 0 to `until`.
bool meets_exactly(const WalkedRay& ray, const Box& box, double until) {
    Rational from = 0;
    std::optional<Rational> to;
    if (until < HUGE_VAL) to = Rational(until);
    for (int axis = 0; axis < 3; ++axis) {
        const Rational o(ray.origin[axis]);
        const Rational d(ray.direction[axis]);
        const Rational low(box.low[axis]);
        const Rational high(box.high[axis]);
        if (d == 0) {
            if (o < low || o > high) return false;
            continue;
        }
        Rational enter = (low - o) / d;
        Rational leave = (high - o) / d;
        if (d < 0) std::swap(enter, leave);
        from = std::max(from, enter);
        to = to ? std::min(*to, leave) : leave;
    }
    return !to || from <= *to;
}

/// The least t of the ray in the box, in doubles.
double enters_at(const WalkedRay& ray, const Box& box) {
    double from = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        if (d == 0) continue;
        from = std::max(from, ((d < 0 ? box.high[axis] : box.low[axis]) - ray.origin[axis]) / d);
    }
    return from;
}

std::vector<Box> random_boxes(Random& random, std::size_t count, double size, const Vec3<double>& by) {
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        Box& box = boxes.emplace_back();
        const Vec3<double> corner = random.point(size) + by;
        Vec3<double> other = corner + random.point(size / 16);
        const int flat = random.whole(0, 5);
        if (flat < 3) other[flat] = corner[flat];
        box.cover({corner, corner});
        box.cover({other, other});
    }
    return boxes;
}

/// Toward a corner, an edge or a side of the box from `far` of its distance away, also along axes.
WalkedRay ray_at(const Box& box, double far, Random& random) {
    Vec3<double> target;
    Vec3<double> origin;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = random.whole(0, 2) / 2.0;
        target[axis] = share == 0.5 ? random.between(box.low[axis], box.high[axis])
                                    : (share == 0 ? box.low[axis] : box.high[axis]);
        origin[axis] = target[axis] + far * random.number();
        if (random.whole(0, 4) == 0) origin[axis] = target[axis];
    }
    WalkedRay ray{origin, target - origin};
    if (random.whole(0, 9) == 0) ray.direction[random.whole(0, 2)] = random.whole(0, 1) != 0 ? 0x1p-1074 : -0x1p-1040;
    if (ray.direction == Vec3<double>(0, 0, 0)) ray.direction.x = 1;
    return ray;
}

/// Without triangles.
Tree tree_of(const std::vector<Box>& boxes) {
    return build_tree(boxes, {}, static_cast<std::uint32_t>(boxes.size()));
}

struct Sizes {
    double scene;
    double distance;   ///< of the origins, in sizes of the scene
    double direction;  ///< by which directions are multiplied
    double offset;     ///< of the scene from 0, in its sizes
};

/// Compares with exact numbers.
void expect_no_loss(const Sizes& sizes, Random& random) {
    const Vec3<double> by(sizes.offset * sizes.scene, -sizes.offset * sizes.scene, 0);
    // Each as often as a leaf has objects, so that a leaf is no larger than they are.
    std::vector<Box> boxes;
    for (const Box& box : random_boxes(random, 10, sizes.scene, by)) boxes.insert(boxes.end(), objects_per_leaf, box);
    Tree tree = tree_of(boxes);
    for (const Instructions instructions : all_instructions()) {
        tree.instructions = instructions;
        for (int i = 0; i < 60; ++i) {
            const Box& box = boxes[static_cast<std::size_t>(random.whole(0, 39))];
            WalkedRay ray = ray_at(box, sizes.scene * sizes.distance, random);
            const double until = random.whole(0, 1) != 0 ? HUGE_VAL : enters_at(ray, box) / sizes.direction;
            ray.direction = scaled(ray.direction, sizes.direction);
            const double uncertainty = random.whole(0, 3) == 0 ? sizes.scene * 0x1p-30 : 0;
            const std::vector<bool> visited = visited_by(tree, boxes.size(), ray, uncertainty, until);
            WalkedRay moved = ray;
            moved.origin[random.whole(0, 2)] += uncertainty * 0.99 * random.number();
            for (std::size_t object = 0; object < boxes.size(); ++object) {
                EXPECT_TRUE(visited[object] || !meets_exactly(moved, boxes[object], until))
                    << sizes.scene << ' ' << sizes.distance << ' ' << sizes.direction << ' ' << sizes.offset;
            }
        }
    }
}

TEST(Walk, LosesNoBoxOfAnySize) {
    Random random(1);
    for (const double scene :
         {1.0, 0x1p-30, 1e30, 0x1p-399, 0x1p-402, 0x1p399, 0x1p402, 0x1p-899, 0x1p899, 0x1p-1000, 0x1p1000}) {
        for (const double distance : {0.5, 3.0, 1e6}) {
            if (scene * distance < 0x1p1010) expect_no_loss({scene, distance, 1, 0}, random);
        }
    }
}

TEST(Walk, LosesNoBoxOnRaysWithADirectionOfAnySize) {
    Random random(2);
    for (const double direction : {0x1p-1074, 0x1p-1040, 0x1p-1000, 0x1p-899, 0x1p-402, 0x1p-399, 0x1p-300, 0x1p300,
                                   0x1p399, 0x1p402, 0x1p899, 0x1p1000}) {
        for (const double distance : {0.5, 3.0, 1e9}) expect_no_loss({1, distance, direction, 0}, random);
    }
}

TEST(Walk, LosesNoBoxFarFromZeroOrFromTheRay) {
    Random random(3);
    for (const double offset : {1.0, 1e3, 1e8, 1e13}) expect_no_loss({1, 2, 1, offset}, random);
    for (const double distance : {7.0, 15.0, 15.9, 16.1, 1e3, 1e8, 1e13, 1e20}) {
        for (int i = 0; i < 5; ++i) expect_no_loss({1, distance, 1, 0}, random);
    }
}

/// A tree that visited everything would lose nothing either.
TEST(Walk, VisitsFewBoxesWhateverTheSizeOfTheNumbers) {
    constexpr int rays = 100;
    constexpr int objects = 500;
    Random random(4);
    for (const Sizes& sizes : {Sizes{1, 0.5, 1, 0}, {1, 1e6, 1, 0}, {1e-20, 3, 1e40, 0}, {1, 3, 1e-40, 1e6}}) {
        const Vec3<double> by(sizes.offset * sizes.scene, 0, 0);
        const std::vector<Box> boxes = random_boxes(random, objects, sizes.scene, by);
        Tree tree = tree_of(boxes);
        for (const Instructions instructions : all_instructions()) {
            tree.instructions = instructions;
            std::ptrdiff_t visits = 0;
            for (int i = 0; i < rays; ++i) {
                const Vec3<double> target = random.point(sizes.scene) + by;
                const Vec3<double> origin = target + scaled(random.direction(), sizes.scene * sizes.distance);
                const WalkedRay ray{origin, scaled(Vec3<double>(target - origin), sizes.direction)};
                const std::vector<bool> visited = visited_by(tree, boxes.size(), ray, 0, HUGE_VAL);
                visits += std::count(visited.begin(), visited.end(), true);
            }
            EXPECT_LT(visits, rays * objects / 30);
        }
    }
}

TEST(Walk, VisitsNothingOnARayThatMissesTheScene) {
    Random random(5);
    const std::vector<Box> boxes = random_boxes(random, 100, 1, {0, 0, 0});
    const Tree tree = tree_of(boxes);
    for (const WalkedRay& ray : {WalkedRay{{0, 5, 0}, {1, 0, 0}}, {{0, 5, 0}, {0, 1, 0}}, {{9, 9, 0}, {-1, 1, 0}}}) {
        const std::vector<bool> visited = visited_by(tree, boxes.size(), ray, 0, HUGE_VAL);
        EXPECT_EQ(std::count(visited.begin(), visited.end(), true), 0);
    }
}

}  // namespace
