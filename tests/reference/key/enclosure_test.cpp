// Compares every item's enclosure with 512-bit arithmetic on random scenes, by different formulas than the
// stages.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <map>

#include "reference/key/answer_key.h"
#include "tests/given/cases.h"
#include "tests/given/random_scene.h"

namespace {

using namespace reference;

/// 155 digits are 515 bits.
using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<155>, boost::multiprecision::et_off>;
struct P {
    Real x, y, z;
};
P operator+(const P& p, const P& q) {
    return {p.x + q.x, p.y + q.y, p.z + q.z};
}
P operator-(const P& p, const P& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}
P operator*(const Real& s, const P& p) {
    return {s * p.x, s * p.y, s * p.z};
}
Real operator*(const P& p, const P& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}
P cross_of(const P& p, const P& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
P unit(const P& p) {
    return Real(1 / sqrt(p * p)) * p;
}
std::vector<Real> list(const P& p) {
    return {p.x, p.y, p.z};
}

Real real(const Decimal& number) {
    return Real(number.text());
}
P real(const Vec3<Decimal>& p) {
    return {real(p.x), real(p.y), real(p.z)};
}

using Truth = std::map<ItemId, std::vector<Real>>;

/// Gets the axes by Gram-Schmidt; inverts no matrix. Returns the ray's start and direction.
std::pair<P, P> add_camera(Truth& truth, const Scene<Decimal>& scene) {
    const P eye = real(scene.camera.eye);
    const P up = real(scene.camera.vup);
    const P Z = unit(eye - real(scene.camera.lookat));
    const P Y = unit(up - (up * Z) * Z);
    const P X = cross_of(Y, Z);
    const auto& window = scene.window;
    const Real x = real(window.clip_left) + (Real(scene.pixel.x) + Real(0.5)) / window.width *
                                                (real(window.clip_right) - real(window.clip_left));
    const Real y = real(window.clip_bottom) + (Real(scene.pixel.y) + Real(0.5)) / window.height *
                                                  (real(window.clip_top) - real(window.clip_bottom));
    const Real z = -real(window.clip_near);
    const P step = x * X + y * Y + z * Z;
    truth[reference::item::P_VCS] = {x, y, z};
    truth[reference::item::X_vcs] = list(X);
    truth[reference::item::Y_vcs] = list(Y);
    truth[reference::item::Z_vcs] = list(Z);
    truth[reference::item::M_VCS_to_WCS] = {X.x, X.y, X.z, 0, Y.x,   Y.y,   Y.z,   0,
                                            Z.x, Z.y, Z.z, 0, eye.x, eye.y, eye.z, 1};
    truth[reference::item::P_WCS] = list(eye + step);
    truth[reference::item::V] = list(unit(step));
    return {eye + step, unit(step)};
}

/// Uses the point of the ray nearest to the centre.
void add_sphere(Truth& truth, const P& start, const P& V, const Sphere<Decimal>& sphere) {
    const P to_center = real(sphere.center) - start;
    const Real R = real(sphere.radius);
    const Real nearest = to_center * V;
    const Real half_chord_squared = R * R - (to_center * to_center - nearest * nearest);
    truth[reference::item::sphere::a] = {Real(1)};
    truth[reference::item::sphere::b] = {-2 * nearest};
    truth[reference::item::sphere::c] = {to_center * to_center - R * R};
    truth[reference::item::sphere::d] = {4 * half_chord_squared};
    if (half_chord_squared < 0) return;
    const Real half_chord = sqrt(half_chord_squared);
    const Real t = nearest > half_chord ? nearest - half_chord : nearest + half_chord;
    if (t < 0) return;
    truth[reference::item::sphere::t] = {t};
    truth[reference::item::sphere::hit] = list(start + t * V);
    truth[reference::item::sphere::normal] = list((1 / R) * (t * V - to_center));
}

/// Uses the triangle's plane, and gets u and v from the Gram matrix of the edges.
void add_triangle(Truth& truth, const P& start, const P& V, const Triangle<Decimal>& triangle) {
    const P A = real(triangle.A);
    const P p = real(triangle.B) - A;
    const P q = real(triangle.C) - A;
    const P N = cross_of(p, q);
    const Real t = (N * (A - start)) / (N * V);
    const P in_plane = start + t * V - A;
    const Real gram = (p * p) * (q * q) - (p * q) * (p * q);
    truth[reference::item::triangle::matrix] = {-V.x, -V.y, -V.z, p.x, p.y, p.z, q.x, q.y, q.z};
    truth[reference::item::triangle::rhs] = list(start - A);
    truth[reference::item::triangle::t] = {t};
    truth[reference::item::triangle::u] = {((q * q) * (in_plane * p) - (p * q) * (in_plane * q)) / gram};
    truth[reference::item::triangle::v] = {((p * p) * (in_plane * q) - (p * q) * (in_plane * p)) / gram};
    truth[reference::item::triangle::hit] = list(start + t * V);
    truth[reference::item::triangle::normal] = list(unit(N));
}

/// Takes the nearest of all points of the surface that are on the ray.
void add_cylinder(Truth& truth, const P& start, const P& V, const Cylinder<Decimal>& cylinder) {
    const P from_center = start - real(cylinder.center);
    const P flat_start{from_center.x, 0, from_center.z}, flat_V{V.x, 0, V.z};
    const Real R = real(cylinder.radius), half = real(cylinder.height) / 2;
    const Real a = flat_V * flat_V, b = 2 * (flat_V * flat_start), c = flat_start * flat_start - R * R;
    const Real d = b * b - 4 * a * c;
    truth[item::cylinder::a] = {a};
    truth[item::cylinder::b] = {b};
    truth[item::cylinder::c] = {c};
    truth[item::cylinder::d] = {d};
    std::map<Real, P> normals;
    const auto add = [&](const Real& t, bool is_cap) {
        const P at = from_center + t * V;
        const Real distance = sqrt(at.x * at.x + at.z * at.z);
        if (t < 0 || (is_cap ? distance > R : abs(at.y) > half)) return;
        normals[t] = is_cap ? P{0, at.y > 0 ? 1 : -1, 0} : (1 / R) * P{at.x, 0, at.z};
    };
    for (const int sign : {-1, 1}) {
        if (d >= 0) add((-b + sign * sqrt(d)) / (2 * a), false);
        add((sign * half - from_center.y) / V.y, true);
    }
    if (normals.empty()) return;
    const auto& [t, normal] = *normals.begin();
    truth[item::cylinder::t] = {t};
    truth[item::cylinder::hit] = list(start + t * V);
    truth[item::cylinder::normal] = list(normal);
}

void expect_enclosed(const Answer& answer, const std::vector<Real>& truth) {
    // The error bound of the 512-bit arithmetic itself.
    const Real slack("1e-140");
    ASSERT_EQ(answer.lo.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_TRUE(Real(answer.lo[i]) - slack <= truth[i]) << answer.lo[i] << " > " << truth[i];
        EXPECT_TRUE(truth[i] <= Real(answer.hi[i]) + slack) << answer.hi[i] << " < " << truth[i];
        EXPECT_LE(answer.hi[i], std::nextafter(answer.lo[i], HUGE_VAL)) << "not the tightest doubles";
        const double value = std::get<Numbers>(answer.value)[i];
        EXPECT_TRUE(value == answer.lo[i] || value == answer.hi[i]);
        const double other = value == answer.lo[i] ? answer.hi[i] : answer.lo[i];
        EXPECT_TRUE(abs(Real(value) - truth[i]) <= abs(Real(other) - truth[i]) + slack) << "not the nearer double";
    }
}

TEST(Enclosure, ContainsTheTruthOfEveryItemOnRandomScenes) {
    std::uint64_t sphere_hits = 0;
    std::uint64_t triangle_hits = 0;
    std::uint64_t cylinder_hits = 0;
    const std::uint64_t scenes = std::max<std::uint64_t>(cases(30), 15);
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE(seed);
        Assignment assignment = random_assignment_with_cylinder(seed);
        assignment.rubric.pixel_conventions = {PixelConvention::centre};
        assignment.rubric.boundary = BoundaryPolicy::nonnegative;
        const AnswerKey key = make_key(assignment, Precision::certified);
        Truth truth;
        const auto [start, V] = add_camera(truth, assignment.scene);
        add_sphere(truth, start, V, assignment.scene.spheres[0]);
        add_triangle(truth, start, V, assignment.scene.triangles[0]);
        add_cylinder(truth, start, V, assignment.scene.cylinders[0]);
        for (const KeyQuestion& question : key.questions) {
            for (const KeyItem& item : question.items) {
                SCOPED_TRACE(item.spec.name);
                const Answer& answer = item.answers.front();
                const auto found = truth.find(item.spec.id);
                ASSERT_EQ(found != truth.end(), std::holds_alternative<Numbers>(answer.value));
                if (found != truth.end()) expect_enclosed(answer, found->second);
            }
        }
        sphere_hits += key.decisions.of(reference::Subject::sphere) == "hit" ? 1 : 0;
        triangle_hits += key.decisions.of(reference::Subject::triangle) == "hit" ? 1 : 0;
        cylinder_hits += key.decisions.of(reference::Subject::cylinder) == "hit" ? 1 : 0;
    }
    // The random scenes must include enough hits.
    EXPECT_GT(sphere_hits, scenes / 5);
    EXPECT_GT(triangle_hits, scenes / 20);
    EXPECT_GT(cylinder_hits, scenes / 5);
}

}  // namespace
