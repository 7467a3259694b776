#include "tests/given/student/names.h"

#include <map>

namespace student {

const Words& names_of(const reference::ItemId& id) {
    static const std::map<reference::ItemId, Words> names = {
        {reference::item::P_VCS, {"P_vcs", "pixel in view coordinates", "Pixel in VCS", "p_vcs"}},
        {reference::item::X_vcs, {"X_vcs", "X axis of the camera", "X_vcs", "x_axis"}},
        {reference::item::Y_vcs, {"Y_vcs", "Y axis of the camera", "Y_vcs", "y_axis"}},
        {reference::item::Z_vcs, {"Z_vcs", "Z axis of the camera", "Z_vcs", "z_axis"}},
        {reference::item::M_VCS_to_WCS, {"M", "inverse of the view matrix", "M_VCS_to_WCS", "view_inverse"}},
        {reference::item::P_WCS, {"P_wcs", "pixel in world coordinates", "Pixel in WCS", "p_wcs"}},
        {reference::item::V, {"V", "ray direction", "unit-length vector V", "ray_dir"}},
        {reference::item::sphere::a, {"a", "coefficient a", "a", "a"}},
        {reference::item::sphere::b, {"b", "coefficient b", "b", "b"}},
        {reference::item::sphere::c, {"c", "coefficient c", "c", "c"}},
        {reference::item::sphere::d, {"d", "discriminant", "discriminant d", "disc"}},
        {reference::item::sphere::t, {"t", "ray parameter", "ray parameter t", "t_sphere"}},
        {reference::item::sphere::hit, {"P_s", "hit point on the sphere", "hit point P_s", "hit_point"}},
        {reference::item::sphere::normal, {"N", "surface normal", "normal N", "normal"}},
        {reference::item::triangle::matrix, {"A", "matrix of the system", "matrix A", "mat_a"}},
        {reference::item::triangle::rhs, {"b", "right-hand side", "right-hand side", "rhs"}},
        {reference::item::triangle::t, {"t", "ray parameter", "t", "t_tri"}},
        {reference::item::triangle::u, {"u", "u", "u", "u"}},
        {reference::item::triangle::v, {"v", "v", "v", "v"}},
        {reference::item::triangle::hit, {"P_t", "hit point on the triangle", "hit point P_t", "hit_point"}},
        {reference::item::triangle::normal, {"N", "triangle normal", "normal N", "normal"}},
        {reference::item::cylinder::a, {"a", "coefficient a", "a", "a"}},
        {reference::item::cylinder::b, {"b", "coefficient b", "b", "b"}},
        {reference::item::cylinder::c, {"c", "coefficient c", "c", "c"}},
        {reference::item::cylinder::d, {"d", "discriminant", "discriminant d", "disc"}},
        {reference::item::cylinder::t, {"t", "ray parameter", "ray parameter t", "t_cylinder"}},
        {reference::item::cylinder::hit, {"P_c", "hit point on the cylinder", "hit point P_c", "hit_point"}},
        {reference::item::cylinder::normal, {"N", "cylinder normal", "normal N", "normal"}},
    };
    return names.at(id);
}

}  // namespace student
