// A scene prepared for rendering: in doubles, with everything computed that is the same for all rays.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/kernel/triangle.h"
#include "reference/stages/sphere.h"
#include "reference/toml/assignment.h"

namespace reference::render {

/// A material with the values that follow from it in this scene.
struct Surface {
    Material material;
    bool is_lit = false;   ///< the scene has a light, and the surface a material; else the normal gives the color
    double own_share = 1;  ///< the share of the surface's own color: neither mirrored nor transmitted
};

struct RowOfRays;

/// The rays of the picture: question 1 to 5 of the handout, in doubles. A pixel's samples are a grid in it.
struct Eye {
    Basis<double> basis;
    Vec3<double> position;
    std::vector<double> columns;         ///< P_VCS.x of each column of pixels, from the left
    std::vector<double> rows;            ///< P_VCS.y of each row of pixels, from the bottom
    std::vector<double> sample_columns;  ///< the same for samples, samples_per_side per pixel
    std::vector<double> sample_rows;     ///< the same for samples
    double z;                            ///< P_VCS.z
    /// The corners of the window, in world coordinates.
    std::array<Vec3<double>, 4> corners;

    RowOfRays row(double y) const;
};

/// The rays through one row of the window, with their common values.
struct RowOfRays {
    Vec3<double> X;
    Vec3<double> up;     ///< Y_vcs times P_VCS.y
    Vec3<double> ahead;  ///< Z_vcs times P_VCS.z
    Vec3<double> eye;

    /// The ray through x of the window. It starts at P_WCS with direction V, both equal to the last bit to what the
    /// stages compute.
    kernel::Ray<double> ray(double x) const {
        const Vec3<double> P_WCS = scaled(X, x) + up + ahead + eye;
        return {P_WCS, ray_direction(P_WCS, eye)};
    }
};

inline RowOfRays Eye::row(double y) const {
    return {basis.X_vcs, scaled(basis.Y_vcs, y), scaled(basis.Z_vcs, z), position};
}

enum class ObjectKind { sphere, triangle, cylinder };

/// Objects are numbered: the spheres in the file's order, then the triangles, then the cylinders, not counting objects
/// left out.
struct PreparedScene {
    Eye eye;
    int width;   ///< pixels
    int height;  ///< pixels
    int samples_per_side;
    /// Whether a ray that starts on an object hits it there.
    Boundary boundary;
    std::vector<Sphere<double>> spheres;
    std::vector<kernel::PreparedTriangle> triangles;
    std::vector<Vec3<double>> triangle_normals;  ///< of unit length
    std::vector<Cylinder<double>> cylinders;
    std::vector<Surface> surfaces;                     ///< the first is that of objects without a material
    std::vector<std::uint32_t> surface_of;             ///< by object
    std::vector<PointLight> point_lights;              ///< without black ones
    std::vector<DirectionalLight> directional_lights;  ///< the same; the directions of unit length
    Color ambient_light;
    Color background;
    std::vector<std::string> notes;  ///< what was left out, in whole sentences

    std::uint32_t object_count() const {
        return static_cast<std::uint32_t>(spheres.size() + triangles.size() + cylinders.size());
    }
    ObjectKind kind_of(std::uint32_t object) const {
        if (object < spheres.size()) return ObjectKind::sphere;
        return object < spheres.size() + triangles.size() ? ObjectKind::triangle : ObjectKind::cylinder;
    }
    const kernel::PreparedTriangle& triangle(std::uint32_t object) const { return triangles[object - spheres.size()]; }
    const Cylinder<double>& cylinder(std::uint32_t object) const {
        return cylinders[object - spheres.size() - triangles.size()];
    }
};

struct PictureSize {
    int width;
    int height;
};

/// Prepares the scene for a picture of `size`, or of the window's size. Triangles without area in doubles and duplicate
/// spheres and cylinders are left out, with a note. Throws AssignmentError for a coordinate beyond 1e30 or a size below
/// 1e-30 (products of six numbers must stay within the range of doubles), and for a picture with too many samples.
PreparedScene prepare_scene(const Assignment& assignment, std::optional<PictureSize> size);

}  // namespace reference::render
