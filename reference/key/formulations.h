// The handout's stages as students usually write them: the camera's here, the objects' in the file of each
// (object_programs.h). Every function lists results that are equal over the real numbers and differ in their roundings
// only; `roundings` numbers these as Alternatives. Sources: the handout; GLM; Möller and Trumbore (1997); Ericson,
// "Real-Time Collision Detection" (2005); Haines et al., "Precision Improvements for Ray/Sphere Intersection" (2019);
// Shirley and Marschner, "Fundamentals of Computer Graphics"; the tutorials of scratchapixel.com.
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
/// formula also covers the division.
AffineVec3 unit_vector(const AffineVec3& p);

/// One coordinate of question 1. `offset_halves` is 1 for a pixel's center and 0 for its corner; `steps` is the number
/// of pixels, or one less for the grid.
std::vector<Affine> window_coordinates(const Affine& from, const Affine& to, int index, int steps, int offset_halves);

/// Each component over the divisor.
AffineVec3 quotient(const AffineVec3& p, const Affine& divisor);

/// The matrix times p, each row's sum in any order.
AffineVec3 times(const Mat3<Affine>& M, const AffineVec3& p);

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

/// A root, for `choice` smaller or larger: by the textbook's formula, as a sum of two quotients, and without
/// cancellation.
std::vector<Affine> quadratic_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings);

}  // namespace reference
