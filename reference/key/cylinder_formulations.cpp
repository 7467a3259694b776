#include <functional>

#include "reference/key/formulations.h"

namespace reference {
namespace {

/// The ray beside the axis.
struct AlongAxis {
    Affine x, z;      ///< S - center
    Affine V_x, V_z;  ///< V
};

AlongAxis along_axis(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder) {
    return {start.x - cylinder.center.x, start.z - cylinder.center.z, V.x, V.z};
}

}  // namespace

std::vector<Quadratic<Affine>> tube_quadratics(const AffineVec3& start, const AffineVec3& V,
                                               const Cylinder<Affine>& cylinder, Roundings& roundings) {
    const auto [x, z, V_x, V_z] = along_axis(start, V, cylinder);
    const Affine a = V_x * V_x + V_z * V_z;
    const Affine b = Affine(2) * (x * V_x + z * V_z);
    const AffineVec3& center = cylinder.center;
    const Affine square = cylinder.radius * cylinder.radius;
    const auto expanded = [](const Affine& p, const Affine& q) { return sum(p * p, -(Affine(2) * p * q), q * q); };
    const std::function<Affine()> ways_to_c[] = {
        [&] { return sum(x * x, z * z, -square); },
        [&] {
            return sum(start.x * start.x + start.z * start.z, -(Affine(2) * (start.x * center.x + start.z * center.z)),
                       center.x * center.x + center.z * center.z, -square);
        },
        [&] { return sum(expanded(start.x, center.x), expanded(start.z, center.z), -square); },
        [&] {
            const Affine length = sqrt(x * x + z * z);
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

CapHit cap_hit(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder, CylinderPart cap) {
    const Affine half = cylinder.height / Affine(2);
    const Affine& center = cylinder.center.y;
    const bool is_top = cap == CylinderPart::top_cap;
    const Affine t = sum(center, is_top ? half : -half, -start.y) / V.y;
    const AffineVec3 hit = point_on_ray(start, V, t);
    return {t, {hit, AffineVec3(hit.x, is_top ? center + half : center - half, hit.z)}};
}

}  // namespace reference
