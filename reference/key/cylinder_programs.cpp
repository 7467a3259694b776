#include <cmath>
#include <functional>

#include "reference/key/object_programs.h"

namespace reference {
namespace {

/// The ray relative to the axis.
struct AlongAxis {
    Affine x, z;      ///< S - center
    Affine V_x, V_z;  ///< V
};

AlongAxis along_axis(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder) {
    return {start.x - cylinder.center.x, start.z - cylinder.center.z, V.x, V.z};
}

/// The tube's a, b, c and d: c from S - C, from its length, or from S and C separately.
std::vector<Quadratic<Affine>> tube_quadratics(const AffineVec3& start, const AffineVec3& V,
                                               const Cylinder<Affine>& cylinder, Roundings& roundings) {
    const AlongAxis ray = along_axis(start, V, cylinder);
    const Affine a = ray.V_x * ray.V_x + ray.V_z * ray.V_z;
    const Affine b = Affine(2) * (ray.x * ray.V_x + ray.z * ray.V_z);
    const AffineVec3& center = cylinder.center;
    const Affine square = cylinder.radius * cylinder.radius;
    const auto expanded = [](const Affine& p, const Affine& q) { return sum(p * p, -(Affine(2) * p * q), q * q); };
    const std::function<Affine()> ways_to_c[] = {
        [&] { return sum(ray.x * ray.x, ray.z * ray.z, -square); },
        [&] {
            return sum(start.x * start.x + start.z * start.z, -(Affine(2) * (start.x * center.x + start.z * center.z)),
                       center.x * center.x + center.z * center.z, -square);
        },
        [&] { return sum(expanded(start.x, center.x), expanded(start.z, center.z), -square); },
        [&] {
            const Affine length = sqrt(ray.x * ray.x + ray.z * ray.z);
            return either(length * length - square, (length - cylinder.radius) * (length + cylinder.radius));
        }};
    std::vector<Quadratic<Affine>> result;
    Alternatives ways(roundings);
    for (const auto& way_to_c : ways_to_c) {
        const Affine c = way_to_c();
        result.push_back({a, b, c, b * b - Affine(4) * a * c});
        ways.next();
    }
    return result;
}

/// The tube's t without a quadratic's c: from the ray's distance from the axis, with V as it is or normalized in x and
/// z.
std::vector<Affine> geometric_tube_roots(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder,
                                         RootChoice choice, Roundings& roundings) {
    const auto [x, z, V_x, V_z] = along_axis(start, V, cylinder);
    const Affine square = cylinder.radius * cylinder.radius;
    const auto end = [&](const Affine& middle, const Affine& half) {
        return choice == RootChoice::smaller ? middle - half : middle + half;
    };
    Alternatives ways(roundings);
    const Affine a = V_x * V_x + V_z * V_z;
    const Affine beside = x * V_z - z * V_x;
    std::vector<Affine> result{end(-(x * V_x + z * V_z), sqrt(a * square - beside * beside)) / a};
    ways.next();
    const Affine speed = sqrt(V_x * V_x + V_z * V_z);
    const Affine u_x = V_x / speed, u_z = V_z / speed;
    const Affine distance = x * u_z - z * u_x;
    result.push_back(end(-(x * u_x + z * u_z), sqrt(square - distance * distance)) / speed);
    return result;
}

/// The tube's normal: normalized, divided by the radius, or from the point of the axis at the hit's height.
std::vector<AffineVec3> tube_normals(const AffineVec3& hit, const Cylinder<Affine>& cylinder, Roundings& roundings) {
    const AffineVec3& center = cylinder.center;
    const AffineVec3 outward(hit.x - center.x, Affine(), hit.z - center.z);
    Alternatives ways(roundings);
    std::vector<AffineVec3> result{unit_vector(outward)};
    ways.next();
    result.push_back(scaled(outward, Affine(Affine(1) / cylinder.radius)));
    ways.next();
    const Affine on_axis = center.y + (hit.y - center.y);
    result.push_back(unit_vector(AffineVec3(outward.x, hit.y - on_axis, outward.z)));
    return result;
}

/// Where a ray meets a cap's plane. The normal is a constant.
struct CapHit {
    Affine t;
    std::vector<AffineVec3> hits;  ///< S + tV, and the same with the y of the plane
};

CapHit cap_hit(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder, CylinderPart cap) {
    const Affine half = cylinder.height / Affine(2);
    const Affine& center = cylinder.center.y;
    const bool is_top = cap == CylinderPart::top_cap;
    const Affine t = sum(center, is_top ? half : -half, -start.y) / V.y;
    const AffineVec3 hit = point_on_ray(start, V, t);
    return {t, {hit, AffineVec3(hit.x, is_top ? center + half : center - half, hit.z)}};
}

void add_tube_hits(const AffineRay& ray, const Cylinder<Affine>& cylinder, const std::vector<Affine>& ts,
                   Roundings& roundings, Hulls& hulls) {
    Alternatives ways(roundings);
    for (const Affine& t : ts) {
        const AffineVec3 hit = point_on_ray(ray.start, ray.V, t);
        hulls.add(item::cylinder::t, t);
        hulls.add(item::cylinder::hit, hit);
        for (const AffineVec3& normal : tube_normals(hit, cylinder, roundings))
            hulls.add(item::cylinder::normal, normal);
        ways.next();
    }
}

void add_cap_hits(const AffineRay& ray, const Cylinder<Affine>& cylinder, CylinderPart cap, Hulls& hulls) {
    const CapHit met = cap_hit(ray.start, ray.V, cylinder, cap);
    hulls.add(item::cylinder::t, met.t);
    for (const AffineVec3& hit : met.hits) hulls.add(item::cylinder::hit, hit);
}

}  // namespace

CylinderBranch branch_of(const CylinderAnswers<Certified>& cylinder) {
    return {cylinder.part, cap_at_rim(cylinder.equations, cylinder.part)};
}

void add_without_ray(const Cylinder<Affine>& /*cylinder*/, Roundings& /*roundings*/, Hulls& /*hulls*/) {}

void add_for_ray(const AffineRay& ray, const Cylinder<Affine>& cylinder, const CylinderBranch& branch,
                 Roundings& roundings, Hulls& hulls) {
    const CylinderPart part = branch.part;
    const RootChoice choice = tube_root(part);
    const bool hits_tube = choice == RootChoice::smaller || choice == RootChoice::larger;
    const std::vector<Quadratic<Affine>> all = tube_quadratics(ray.start, ray.V, cylinder, roundings);
    Alternatives ways(roundings);
    for (const Quadratic<Affine>& quadratic : all) {
        hulls.add(item::cylinder::a, quadratic.a);
        hulls.add(item::cylinder::b, quadratic.b);
        hulls.add(item::cylinder::c, quadratic.c);
        hulls.add(item::cylinder::d, quadratic.d);
        if (hits_tube) add_tube_hits(ray, cylinder, quadratic_roots(quadratic, choice, roundings), roundings, hulls);
        ways.next();
    }
    if (hits_tube)
        add_tube_hits(ray, cylinder, geometric_tube_roots(ray.start, ray.V, cylinder, choice, roundings), roundings,
                      hulls);
    ways.next();
    const bool hits_cap = part == CylinderPart::top_cap || part == CylinderPart::bottom_cap;
    if (hits_cap) {
        add_cap_hits(ray, cylinder, part, hulls);
        hulls.add(item::cylinder::normal,
                  AffineVec3(Affine(), Affine(part == CylinderPart::top_cap ? 1 : -1), Affine()));
    }
    if (branch.rim_cap) add_cap_hits(ray, cylinder, *branch.rim_cap, hulls);
}

std::vector<Reason> reasons_of(const Cylinder<double>& cylinder, const CylinderAnswers<double>& answers,
                               const CameraAnswers<double>& camera) {
    std::vector<Reason> reasons;
    const Quadratic<double>& tube = answers.equations.tube;
    const CylinderPart part = answers.part;
    const Vec3<double> from_center = camera.P_WCS - cylinder.center;
    const double distance = length(from_center);
    const double square = cylinder.radius * cylinder.radius;
    const double far = (from_center.x * from_center.x + from_center.z * from_center.z) / square;
    if (part == CylinderPart::top_cap || part == CylinderPart::bottom_cap) {
        reasons.push_back(
            {1 / std::abs(camera.V.y), "the ray is almost parallel to the cylinder's caps", "Choose another pixel"});
    } else if (tube.a > 0) {
        const double grazing = 4 * tube.a * square / std::abs(tube.d);
        reasons.push_back({grazing > far ? grazing * far : grazing, "the ray almost touches the cylinder's tube",
                           "Choose another pixel or move the cylinder"});
        reasons.push_back(
            {grazing > far ? far : grazing * far, "the cylinder is thin compared with its distance", "Move it closer"});
        reasons.push_back(
            {square / std::abs(tube.c), "the ray starts almost on the cylinder's tube", "Move the cylinder"});
        reasons.push_back({1 / tube.a, "the ray is almost parallel to the cylinder's axis", "Choose another pixel"});
    }
    reasons.push_back({std::pow(length(cylinder.center) / distance, 2),
                       "the coordinates are large compared with the distances",
                       "Move everything closer to the origin"});
    return reasons;
}

}  // namespace reference
