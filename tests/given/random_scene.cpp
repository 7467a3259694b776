#include "tests/given/random_scene.h"

#include <fmt/format.h>

#include "reference/accuracy/rays/random_numbers.h"

namespace {

using namespace reference;
using reference::accuracy::Random;

Decimal decimal(Random& random, double size) {
    return *Decimal::parse(fmt::format("{:.{}f}", size * random.number(), random.whole(0, 3)));
}

Vec3<Decimal> point(Random& random, double size) {
    return {decimal(random, size), decimal(random, size), decimal(random, size)};
}

Decimal positive(Random& random, double least, double most) {
    return *Decimal::parse(fmt::format("{:.2f}", random.between(least, most)));
}

}  // namespace

Assignment random_assignment(std::uint64_t seed) {
    Random random(seed);
    Assignment assignment;
    assignment.name = fmt::format("scene {}", seed);
    Scene<Decimal>& scene = assignment.scene;
    scene.camera = {point(random, 9), point(random, 2), point(random, 3)};
    scene.camera.eye.z = positive(random, 5, 12);
    scene.camera.vup.y = positive(random, 4, 9);
    scene.window = {*Decimal::parse("-2"),  positive(random, 1, 3), *Decimal::parse("-1.1"), positive(random, 1, 2),
                    positive(random, 1, 3), random.whole(2, 640),   random.whole(2, 480)};
    const auto inner = [&](int count) { return random.whole(count / 3, count - 1 - count / 3); };
    scene.pixel = {inner(scene.window.width), inner(scene.window.height)};
    scene.spheres.push_back({point(random, 2), positive(random, 1, 4)});
    scene.triangles.push_back({point(random, 6), point(random, 6), point(random, 6)});
    return assignment;
}

Assignment random_assignment_with_cylinder(std::uint64_t seed) {
    Assignment assignment = random_assignment(seed);
    Random random(~seed);
    assignment.scene.cylinders.push_back({point(random, 2), positive(random, 1, 3), positive(random, 3, 9)});
    Question question{11, "ray and cylinder", {}};
    for (const Item& item : known_items()) {
        if (item.id.subject == Subject::cylinder) question.items.push_back(item.id);
    }
    assignment.questions.push_back(question);
    return assignment;
}
