// What is hit first in scenes with meshes, against every object of the file tried one by one in exact fractions, by
// formulas that are not the kernel's. The scenes are written as files, so the numbers of objects are the files' own.
#include "reference/cast/first_hit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/render/scene/instructions.h"
#include "tests/given/cylinder_parts.h"
#include "tests/given/render/meshes.h"
#include "tests/given/render/scenes.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace reference;
using accuracy::P;
using accuracy::Random;
using cast::FirstHit;
using kernel::Ray;
using Mesh = std::vector<Triangle<double>>;

struct File {
    std::vector<Sphere<double>> spheres = {};
    Mesh triangles = {};
    std::vector<Mesh> meshes = {};
    std::vector<Cylinder<double>> cylinders = {};
};

std::string text_of(const P& p) {
    return fmt::format("[{}, {}, {}]", p.x, p.y, p.z);
}

std::string obj_of(const Mesh& mesh) {
    std::string text;
    int last = 0;
    for (const auto& [A, B, C] : mesh) {
        for (const P& p : {A, B, C}) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
        text += fmt::format("f {} {} {}\n", last + 1, last + 2, last + 3);
        last += 3;
    }
    return text;
}

render::PreparedScene scene_of(const File& file) {
    const TemporaryFolder folder;
    std::string text;
    for (const auto& [center, radius] : file.spheres) text += scenes::sphere(text_of(center), fmt::to_string(radius));
    for (const auto& [A, B, C] : file.triangles) {
        text += scenes::triangle(fmt::format("[{}, {}, {}]", text_of(A), text_of(B), text_of(C)));
    }
    for (const auto& [center, radius, height] : file.cylinders) {
        text += scenes::cylinder(text_of(center), fmt::to_string(radius), fmt::to_string(height));
    }
    for (std::size_t i = 0; i < file.meshes.size(); ++i) {
        folder.write(fmt::format("{}.obj", i), obj_of(file.meshes[i]));
        text += fmt::format("[[mesh]]\nfile = \"{}.obj\"\n", i);
    }
    return cast::objects_of(load_scene(folder.write("scene.toml", scenes::with_camera(text))));
}

/// The first hit in exact numbers.
struct Truth {
    FirstHit hit;  ///< without t, u and v
    cylinder_parts::Surd t;
    accuracy::truth::Rational u = 0, v = 0;

    void take(const FirstHit& other, const cylinder_parts::Surd& other_t) {
        const int order = hit.kind == FirstHit::Kind::none ? -1 : cylinder_parts::order(other_t, t);
        if (order == 0) hit.is_tie = true;
        if (order >= 0) return;
        hit = other;
        t = other_t;
        u = v = 0;
    }
    void take(const Ray<double>& ray, const Triangle<double>& triangle, const FirstHit& other) {
        const auto truth = accuracy::truth::triangle(ray, triangle);
        if (truth.result != kernel::TriangleResult::hit) return;
        const FirstHit before = hit;
        take(other, {truth.t});
        const bool is_taken =
            std::tie(hit.kind, hit.index, hit.face) != std::tie(before.kind, before.index, before.face);
        if (is_taken) std::tie(u, v) = std::tie(truth.u, truth.v);
    }
};

Truth truth_of(const File& file, const Ray<double>& ray) {
    using Kind = FirstHit::Kind;
    Truth truth;
    for (std::uint32_t i = 0; i < file.spheres.size(); ++i) {
        const auto t = cylinder_parts::first_t(ray, file.spheres[i]);
        if (t) truth.take({Kind::sphere, i}, *t);
    }
    for (std::uint32_t i = 0; i < file.triangles.size(); ++i) truth.take(ray, file.triangles[i], {Kind::triangle, i});
    for (std::uint32_t i = 0; i < file.meshes.size(); ++i) {
        for (std::uint32_t face = 0; face < file.meshes[i].size(); ++face) {
            truth.take(ray, file.meshes[i][face], {Kind::mesh, i, face});
        }
    }
    for (std::uint32_t i = 0; i < file.cylinders.size(); ++i) {
        const auto hit = cylinder_parts::first_hit(ray, file.cylinders[i], Boundary::nonnegative);
        if (hit) truth.take({Kind::cylinder, i, 0, hit->part}, hit->t);
    }
    return truth;
}

std::string text_of(const FirstHit& hit) {
    return fmt::format("kind {}, {}, face {}, part {}{}", static_cast<int>(hit.kind), hit.index, hit.face,
                       static_cast<int>(hit.part), hit.is_tie ? ", tie" : "");
}

bool is_near(double given, const accuracy::truth::Real& truth) {
    if (abs(truth) > accuracy::truth::Real(std::numeric_limits<double>::max())) return std::isinf(given) && given > 0;
    return accuracy::truth::is_within_one_ulp(given, truth);
}

/// With each set of instructions. Returns how many rays hit several objects at once.
int expect_the_truth(const File& file, const std::vector<Ray<double>>& rays) {
    std::vector<render::PreparedScene> scenes;
    for (const render::Instructions instructions : render::all_instructions()) {
        scenes.push_back(scene_of(file));
        if (scenes.back().tree) scenes.back().tree->instructions = instructions;
    }
    int ties = 0;
    for (const Ray<double>& ray : rays) {
        const Truth truth = truth_of(file, ray);
        ties += truth.hit.is_tie ? 1 : 0;
        for (const render::PreparedScene& scene : scenes) {
            const FirstHit hit = cast::first_hit(scene, ray);
            EXPECT_EQ(text_of(hit), text_of(truth.hit)) << text_of(ray.origin) << ' ' << text_of(ray.direction);
            EXPECT_TRUE(is_near(hit.t, truth.t.value())) << hit.t;
            EXPECT_TRUE(is_near(hit.u, accuracy::truth::real(truth.u))) << hit.u;
            EXPECT_TRUE(is_near(hit.v, accuracy::truth::real(truth.v))) << hit.v;
            if (testing::Test::HasFailure()) return ties;
        }
    }
    return ties;
}

P whole_direction(Random& random, int size) {
    for (;;) {
        const P p = random.whole_point(size);
        if (p != P(0, 0, 0)) return p;
    }
}

/// Of whole numbers so small that faces share corners, edges and planes, cross each other, and often have no area.
Mesh small_mesh(Random& random, int faces) {
    Mesh mesh;
    for (int i = 0; i < faces; ++i) {
        mesh.push_back({random.whole_point(2), random.whole_point(2), random.whole_point(2)});
    }
    return mesh;
}

bool has_area(const Triangle<double>& triangle) {
    return cross(P(triangle.B - triangle.A), P(triangle.C - triangle.A)) != P(0, 0, 0);
}

File small_file(Random& random) {
    File file;
    for (int i = 0; i < 3; ++i)
        file.spheres.push_back({random.whole_point(2) + P(0, 0, i), random.whole(1, 2) + 0.125 * i});
    for (const auto& triangle : small_mesh(random, 6)) {
        if (has_area(triangle)) file.triangles.push_back(triangle);
    }
    file.meshes = {small_mesh(random, 20), small_mesh(random, 1), small_mesh(random, 25)};
    for (int i = 0; i < 2; ++i) file.cylinders.push_back({random.whole_point(2), 1 + 0.25 * i, 2});
    return file;
}

/// Most rays start on an object, run along edges and through corners, or lie in a plane.
TEST(FirstHit, IsTheTruthAmongSmallWholeNumbers) {
    Random random(1);
    int ties = 0;
    for (int i = 0; i < 20; ++i) {
        std::vector<Ray<double>> rays;
        for (int j = 0; j < 100; ++j) rays.push_back({random.whole_point(3), whole_direction(random, 2)});
        ties += expect_the_truth(small_file(random), rays);
    }
    EXPECT_GT(ties, 200);
}

/// Rays at corners, at points of edges and near them.
TEST(FirstHit, IsTheTruthAtTheEdgesOfAMesh) {
    Random random(2);
    int ties = 0;
    for (const meshes::Mesh& given : meshes::all_kinds(200, random)) {
        File file;
        Mesh& mesh = file.meshes.emplace_back();
        const auto corner = [&](unsigned i) { return P(given.vertices[i]); };
        for (const auto& [a, b, c] : given.faces) mesh.push_back({corner(a), corner(b), corner(c)});
        std::vector<Ray<double>> rays;
        for (int i = 0; i < 60; ++i) {
            const auto& aimed = given.aimed[random.bits() % given.aimed.size()];
            rays.push_back(kernel::as_double(aimed));
            // The difference of two floats is often a double, and then the ray meets the corner exactly.
            const P origin(aimed.origin);
            rays.push_back(
                {origin, random.nudged(corner(static_cast<unsigned>(random.bits() % given.vertices.size())) - origin)});
        }
        ties += expect_the_truth(file, rays);
    }
    EXPECT_GT(ties, 20);
}

/// Two faces around a point cross each other there, nearly along the ray: their t's differ by less than rounding costs.
TEST(FirstHit, IsTheTruthWhereFacesCrossAlongTheRay) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const P middle = random.point(1);
        const P direction = random.direction();
        const double length = std::ldexp(1, random.whole(5, 25));
        const auto face = [&] {
            const P one = random.point(1);
            const P other = random.point(1);
            return Triangle<double>{middle + scaled(direction, length) + one,
                                    middle - scaled(direction, length / 2) + other,
                                    middle - scaled(direction, length / 2) - one - other};
        };
        std::vector<Ray<double>> rays;
        for (int j = 0; j < 10; ++j) {
            rays.push_back({random.nudged(middle - scaled(direction, 3 * length)), direction});
        }
        expect_the_truth({{}, {}, {{face(), face(), face()}}, {}}, rays);
    }
}

/// Numbers for which products, and t itself, leave the range of doubles or become subnormal; also those of the mesh.
TEST(FirstHit, IsTheTruthForRaysOfAnyDoubles) {
    Random random(3);
    int ties = 0;
    const std::array sizes{0x1p-1074, 0x1p-1030, 0x1p-600, 0x1p-300, 1.0, 0x1p300, 0x1p600, 0x1p1022};
    for (int i = 0; i < 8; ++i) {
        const double scale = std::array{1.0, 0x1p-1000, 0x1p90, 0x1p-1070}.at(static_cast<std::size_t>(i % 4));
        Mesh mesh;
        for (const auto& [A, B, C] : small_mesh(random, 40)) {
            mesh.push_back({scaled(A, scale), scaled(B, scale), scaled(C, scale)});
        }
        const File file{{{P(0, 0, -3), 1}}, {}, {mesh}, {}};
        std::vector<Ray<double>> rays;
        for (const double near : {0.0, 0x1p-1074, 0x1p-700, 1.0, 0x1p40, 0x1p700, 0x1p1022}) {
            for (const double size : sizes) {
                const P direction = whole_direction(random, 1);
                const P origin = scaled(random.whole_point(1), scale) - scaled(direction, near);
                rays.push_back({origin, scaled(direction, size)});
                rays.push_back({scaled(random.whole_point(1), near), scaled(direction, size)});
            }
        }
        ties += expect_the_truth(file, rays);
    }
    EXPECT_GT(ties, 100) << "too few rays hit";
}

/// Two faces so near the start that their t's are subnormal and equal but for their last bits.
TEST(FirstHit, OrdersSubnormalTs) {
    const auto level = [](double z) { return Triangle<double>{P(-9, -9, z), P(9, -9, z), P(0, 9, z)}; };
    const File file{{}, {}, {{level(-1), level(-1 + 0x1p-52), level(-1 - 0x1p-52)}}, {}};
    expect_the_truth(file, {{P(0, 0, 0), P(0, 0, -0x1p1023)},
                            {P(0, 0, -2), P(0, 0, 0x1p1023)},
                            {P(0, 0, 0), P(0, 0, -0x1p-1074)},
                            {P(0, 0, -1), P(0, 0, 0x1p-1074)}});
}

TEST(FirstHit, CountsWhatIsLeftOut) {
    const auto level = [](double z) { return Triangle<double>{P(-9, -9, z), P(9, -9, z), P(0, 9, z)}; };
    const Triangle<double> flat{P(0, 0, 9), P(1, 1, 9), P(2, 2, 9)};
    const Sphere<double> ball{P(20, 0, 0), 1};
    const File file{{ball, ball, {P(30, 0, 0), 1}}, {level(-5)}, {{flat, flat}, {flat, level(1), flat, level(2)}}, {}};
    const render::PreparedScene scene = scene_of(file);
    EXPECT_EQ(scene.notes.size(), 3U);
    const auto from = [&](const P& origin) { return text_of(cast::first_hit(scene, {origin, P(0, 0, -1)})); };
    EXPECT_EQ(from(P(0, 0, 5)), text_of(FirstHit{FirstHit::Kind::mesh, 1, 3}));
    EXPECT_EQ(from(P(0, 0, 1.5)), text_of(FirstHit{FirstHit::Kind::mesh, 1, 1}));
    EXPECT_EQ(from(P(0, 0, 0)), text_of(FirstHit{FirstHit::Kind::triangle, 0}));
    EXPECT_EQ(from(P(20, 0, 5)), text_of(FirstHit{FirstHit::Kind::sphere, 0}));
    EXPECT_EQ(from(P(30, 0, 5)), text_of(FirstHit{FirstHit::Kind::sphere, 2}));
}

TEST(FirstHit, IsInvalidForARayThatIsNone) {
    const render::PreparedScene scene = scene_of({{{P(0, 0, 0), 1}}, {}, {}, {}});
    for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(cast::first_hit(scene, {P(0, bad, 5), P(0, 0, -1)}).kind, FirstHit::Kind::invalid);
        EXPECT_EQ(cast::first_hit(scene, {P(0, 0, 5), P(bad, 0, -1)}).kind, FirstHit::Kind::invalid);
    }
    EXPECT_EQ(cast::first_hit(scene, {P(0, 0, 5), P(0, 0, -0.0)}).kind, FirstHit::Kind::invalid);
}

TEST(FirstHit, IsNoneInASceneWithoutObjects) {
    EXPECT_EQ(cast::first_hit(scene_of({}), {P(0, 0, 5), P(0, 0, -1)}).kind, FirstHit::Kind::none);
}

}  // namespace
