// What a ray of any doubles hits first in a scene with meshes: the objects that a walk through the scene's tree finds,
// each decided and put in order by the kernel.
#pragma once

#include "reference/kernel/cylinder.h"
#include "reference/kernel/ray.h"
#include "reference/render/scene/prepared_scene.h"

namespace reference::cast {

struct FirstHit {
    enum class Kind : std::uint32_t {
        none,  ///< nothing is hit
        sphere,
        triangle,
        mesh,
        cylinder,
        invalid,  ///< a number of the ray is not finite, or its direction is zero
    };
    Kind kind = Kind::none;
    std::uint32_t index = 0;  ///< of the object or the mesh in its list of the file, counted from 0
    std::uint32_t face = 0;   ///< of a mesh: the number of the triangle, counted from 0
    kernel::CylinderPart part = kernel::CylinderPart::tube;  ///< of a cylinder
    /// Whether several objects are hit at exactly this t. This one is the first of them among the spheres, the
    /// triangles, the meshes and the cylinders, each in the file's order.
    bool is_tie = false;
    double t = 0;  ///< by the rules of kernel::SphereHit::t
    double u = 0;  ///< of a triangle: the hit is A + u(B-A) + v(C-A), by the same rules
    double v = 0;
};

/// The objects of a scene file, with a tree. Throws AssignmentError as render::prepare_scene does.
render::PreparedScene objects_of(const Assignment& scene);

/// Exact: t >= 0 is a hit, edges and vertices belong to a triangle. `scene` is from objects_of.
FirstHit first_hit(const render::PreparedScene& scene, const kernel::Ray<double>& ray);

}  // namespace reference::cast
