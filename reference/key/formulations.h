// The handout's stages as students usually write them. Every function lists results that are equal over the real
// numbers and differ in their roundings only; `roundings` numbers these as Alternatives. Sources: the handout; GLM;
// Möller and Trumbore (1997); Ericson, "Real-Time Collision Detection" (2005); Haines et al., "Precision Improvements
// for Ray/Sphere Intersection" (2019); Shirley and Marschner, "Fundamentals of Computer Graphics"; the tutorials of
// scratchapixel.com.
//
// Not listed, because none of these is a formulation of its own: half of b and a quarter of d (a power of two changes
// no rounding), divisions by multiplying with the reciprocal, other orders of sums, fused products (affine.h covers
// them). Not listed because it fails on plain scenes too: elimination without looking for a pivot.
#pragma once

#include <vector>

#include "reference/numbers/affine.h"
#include "reference/stages/scene_answers.h"

namespace reference {

using AffineVec3 = Vec3<Affine>;

/// As GLM normalizes, by the reciprocal of the length. Dividing by the length has one rounding less, so a bound of this
/// formula holds for the division too.
AffineVec3 unit_vector(const AffineVec3& p);

/// One coordinate of question 1. `offset_halves` is 1 for a pixel's center and 0 for its corner; `steps` is the number
/// of pixels, or one less for the grid.
std::vector<Affine> window_coordinates(const Affine& from, const Affine& to, int index, int steps, int offset_halves);

/// Question 2, one of `bases`: from unit vectors, with vup as given or normalized, with Y normalized again, from vup
/// less its part along Z, and from vectors that are normalized last. glm::lookAt has the same axes in its rows.
inline constexpr int bases = 8;
Basis<Affine> basis(const Camera<Affine>& camera, int way);

/// Question 3, one of `inverse_views`: the axes and the eye as columns, and the view matrix inverted, as a rigid motion
/// or by glm::inverse.
inline constexpr int inverse_views = 3;
Mat4<Affine> inverse_view(const Basis<Affine>& basis, const AffineVec3& eye, int way);

/// Question 4: M times (P_VCS, 1), divided by its w or not.
std::vector<AffineVec3> points_in_wcs(const Mat4<Affine>& M, const AffineVec3& P_VCS);

/// Question 5: from the eye to the pixel, and what M makes of P_VCS as a direction, normalized before or after.
std::vector<AffineVec3> directions(const Mat4<Affine>& M, const AffineVec3& P_VCS, const AffineVec3& P_WCS,
                                   const AffineVec3& eye, Roundings& roundings);

/// Question 6, a, b, c and d: c from S - C, from its length, or from S and C each by itself.
std::vector<Quadratic<Affine>> quadratics(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                                          Roundings& roundings);

/// A root, for `choice` smaller or larger: by the textbook's formula, as a sum of two quotients, and without
/// cancellation.
std::vector<Affine> quadratic_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings);

/// Question 6, t: the quadratic's roots, also without dividing by a.
std::vector<Affine> sphere_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings);

/// Question 6, t, without a quadratic: from the ray's point that is nearest to the center.
std::vector<Affine> geometric_roots(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                                    RootChoice choice, Roundings& roundings);

/// Question 8: t, u and v in this order.
std::vector<AffineVec3> triangle_solutions(const LinearSystem<Affine>& system, Roundings& roundings);

/// The tube's a, b, c and d: c from S - C, from its length, or from S and C each by itself.
std::vector<Quadratic<Affine>> tube_quadratics(const AffineVec3& start, const AffineVec3& V,
                                               const Cylinder<Affine>& cylinder, Roundings& roundings);

/// The tube's t without a quadratic's c: from the ray's distance from the axis, with V as it is or normalized in x and
/// z.
std::vector<Affine> geometric_tube_roots(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder,
                                         RootChoice choice, Roundings& roundings);

/// The tube's normal: normalized, divided by the radius, or from the point of the axis at the hit's height.
std::vector<AffineVec3> tube_normals(const AffineVec3& hit, const Cylinder<Affine>& cylinder, Roundings& roundings);

/// Where a ray meets a cap's plane. The normal is a constant.
struct CapHit {
    Affine t;
    std::vector<AffineVec3> hits;  ///< S + tV, and the same with the y of the plane
};
CapHit cap_hit(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder, CylinderPart cap);

/// Question 9: from two edges at A, from these normalized, and from two edges at B.
std::vector<AffineVec3> triangle_normals(const Triangle<Affine>& triangle, Roundings& roundings);

}  // namespace reference
