#include <cmath>
#include <functional>

#include "reference/key/object_programs.h"

namespace reference {
namespace {

/// Question 6, a, b, c and d: c from S - C, from its length, or from S and C separately.
std::vector<Quadratic<Affine>> quadratics(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                                          Roundings& roundings) {
    const AffineVec3 from_center = start - sphere.center;
    const Affine b = Affine(2) * dot(V, from_center);
    const Affine& radius = sphere.radius;
    const Affine &x = from_center.x, &y = from_center.y, &z = from_center.z;
    const Affine square = radius * radius;
    const std::function<Affine()> ways_to_c[] = {
        [&] { return sum(x * x, y * y, z * z, -square); },
        [&] {
            const Affine twice = Affine(2) * dot(start, sphere.center);
            return sum(dot(start, start), -twice, dot(sphere.center, sphere.center), -square);
        },
        [&] {
            const Affine length = sqrt(dot(from_center, from_center));
            return either(length * length - square, (length - radius) * (length + radius));
        }};
    std::vector<Quadratic<Affine>> result;
    Alternatives ways(roundings);
    for (const bool a_is_one : {false, true}) {
        for (const auto& way_to_c : ways_to_c) {
            const Affine a = a_is_one ? Affine(1) : dot(V, V);
            const Affine c = way_to_c();
            result.push_back({a, b, c, b * b - Affine(4) * a * c});
            ways.next();
        }
    }
    return result;
}

/// Question 6, t: the quadratic's roots, also without dividing by a.
std::vector<Affine> sphere_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings) {
    std::vector<Affine> result = quadratic_roots(quadratic, choice, roundings);
    Alternatives ways(roundings);
    const Affine spread = sqrt(quadratic.d);
    const Affine signed_spread = choice == RootChoice::smaller ? -spread : spread;
    result.push_back((signed_spread - quadratic.b) / Affine(2));
    return result;
}

/// Question 6, t, without a quadratic: from the ray's point that is nearest to the center.
std::vector<Affine> geometric_roots(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                                    RootChoice choice, Roundings& roundings) {
    const AffineVec3 to_center = sphere.center - start;
    const Affine along = dot(to_center, V);
    const Affine square = sphere.radius * sphere.radius;
    const auto end = [&](const Affine& half) { return choice == RootChoice::smaller ? along - half : along + half; };
    Alternatives ways(roundings);
    std::vector<Affine> result{end(sqrt(sum(square, along * along, -dot(to_center, to_center))))};
    ways.next();
    const AffineVec3 nearest = to_center - scaled(V, along);
    result.push_back(end(sqrt(square - dot(nearest, nearest))));
    return result;
}

void add_sphere_hits(const AffineRay& ray, const Sphere<Affine>& sphere, const std::vector<Affine>& ts,
                     Roundings& roundings, Hulls& hulls) {
    Alternatives ways(roundings);
    for (const Affine& t : ts) {
        const AffineVec3 hit = point_on_ray(ray.start, ray.V, t);
        const AffineVec3 outward = hit - sphere.center;
        hulls.add(item::sphere::t, t);
        hulls.add(item::sphere::hit, hit);
        hulls.add(item::sphere::normal, unit_vector(outward));
        hulls.add(item::sphere::normal, scaled(outward, Affine(Affine(1) / sphere.radius)));
        ways.next();
    }
}

}  // namespace

SphereBranch branch_of(const SphereAnswers<Certified>& sphere) {
    return {sphere.choice};
}

void add_without_ray(const Sphere<Affine>& /*sphere*/, Roundings& /*roundings*/, Hulls& /*hulls*/) {}

void add_for_ray(const AffineRay& ray, const Sphere<Affine>& sphere, const SphereBranch& branch, Roundings& roundings,
                 Hulls& hulls) {
    const bool hits = branch.root == RootChoice::smaller || branch.root == RootChoice::larger;
    const std::vector<Quadratic<Affine>> all = quadratics(ray.start, ray.V, sphere, roundings);
    Alternatives ways(roundings);
    for (const Quadratic<Affine>& quadratic : all) {
        hulls.add(item::sphere::a, quadratic.a);
        hulls.add(item::sphere::b, quadratic.b);
        hulls.add(item::sphere::c, quadratic.c);
        hulls.add(item::sphere::d, quadratic.d);
        if (hits) add_sphere_hits(ray, sphere, sphere_roots(quadratic, branch.root, roundings), roundings, hulls);
        ways.next();
    }
    if (hits)
        add_sphere_hits(ray, sphere, geometric_roots(ray.start, ray.V, sphere, branch.root, roundings), roundings,
                        hulls);
}

std::vector<Reason> reasons_of(const Sphere<double>& sphere, const SphereAnswers<double>& answers,
                               const CameraAnswers<double>& camera) {
    std::vector<Reason> reasons;
    const Quadratic<double>& quadratic = answers.quadratic;
    const double distance = length(Vec3<double>(camera.P_WCS - sphere.center));
    const double far = std::pow(distance / sphere.radius, 2);
    const double grazing = 4 * quadratic.a * sphere.radius * sphere.radius / std::abs(quadratic.d);
    // Each factor amplifies the result of the other. The larger one is the reason.
    reasons.push_back({grazing > far ? grazing * far : grazing, "the ray almost touches the sphere",
                       "Choose another pixel or move the sphere"});
    reasons.push_back(
        {grazing > far ? far : grazing * far, "the sphere is small compared with its distance", "Move it closer"});
    reasons.push_back({sphere.radius * sphere.radius / std::abs(quadratic.c), "the ray starts almost on the sphere",
                       "Move the sphere"});
    reasons.push_back({std::pow(length(sphere.center) / distance, 2),
                       "the coordinates are large compared with the distances",
                       "Move everything closer to the origin"});
    return reasons;
}

}  // namespace reference
