#include "tests/given/student/names.h"

#include <map>

namespace student {

const Words& names_of(const reference::ItemId& id) {
    static const std::map<reference::ItemId, Words> names = {
        {reference::item::P_VCS,
         {"P_vcs", "pixel in view coordinates", "Pixel in VCS", "Pixel im VCS", "pixel en VCS", "píxel en VCS",
          "p_vcs"}},
        {reference::item::X_vcs, {"X_vcs", "X axis of the camera", "X_vcs", "X-Achse", "axe X", "eje X", "x_axis"}},
        {reference::item::Y_vcs, {"Y_vcs", "Y axis of the camera", "Y_vcs", "Y-Achse", "axe Y", "eje Y", "y_axis"}},
        {reference::item::Z_vcs, {"Z_vcs", "Z axis of the camera", "Z_vcs", "Z-Achse", "axe Z", "eje Z", "z_axis"}},
        {reference::item::M_VCS_to_WCS,
         {"M", "inverse of the view matrix", "M_VCS_to_WCS", "Matrix M", "matrice M", "matriz M", "view_inverse"}},
        {reference::item::P_WCS,
         {"P_wcs", "pixel in world coordinates", "Pixel in WCS", "Pixel im WCS", "pixel en WCS", "píxel en WCS",
          "p_wcs"}},
        {reference::item::V,
         {"V", "ray direction", "unit-length vector V", "Strahlrichtung V", "direction V", "dirección V", "ray_dir"}},
        {reference::item::sphere::a,
         {"a", "coefficient a", "a", "Koeffizient a", "coefficient a", "coeficiente a", "a"}},
        {reference::item::sphere::b,
         {"b", "coefficient b", "b", "Koeffizient b", "coefficient b", "coeficiente b", "b"}},
        {reference::item::sphere::c,
         {"c", "coefficient c", "c", "Koeffizient c", "coefficient c", "coeficiente c", "c"}},
        {reference::item::sphere::d,
         {"d", "discriminant", "discriminant d", "Diskriminante d", "discriminant d", "discriminante d", "disc"}},
        {reference::item::sphere::t,
         {"t", "ray parameter", "ray parameter t", "Strahlparameter t", "paramètre t", "parámetro t", "t_sphere"}},
        {reference::item::sphere::hit,
         {"P_s", "hit point on the sphere", "hit point P_s", "Schnittpunkt P_s", "point P_s", "punto P_s",
          "hit_point"}},
        {reference::item::sphere::normal,
         {"N", "surface normal", "normal N", "Normale N", "normale N", "normal N", "normal"}},
        {reference::item::triangle::matrix,
         {"A", "matrix of the system", "matrix A", "Matrix A", "matrice A", "matriz A", "mat_a"}},
        {reference::item::triangle::rhs,
         {"b", "right-hand side", "right-hand side", "rechte Seite b", "second membre b", "lado derecho b", "rhs"}},
        {reference::item::triangle::t,
         {"t", "ray parameter", "t", "Strahlparameter t", "paramètre t", "parámetro t", "t_tri"}},
        {reference::item::triangle::u, {"u", "u", "u", "u", "u", "u", "u"}},
        {reference::item::triangle::v, {"v", "v", "v", "v", "v", "v", "v"}},
        {reference::item::triangle::hit,
         {"P_t", "hit point on the triangle", "hit point P_t", "Schnittpunkt P_t", "point P_t", "punto P_t",
          "hit_point"}},
        {reference::item::triangle::normal,
         {"N", "triangle normal", "normal N", "Normale N", "normale N", "normal N", "normal"}},
        {reference::item::cylinder::a,
         {"a", "coefficient a", "a", "Koeffizient a", "coefficient a", "coeficiente a", "a"}},
        {reference::item::cylinder::b,
         {"b", "coefficient b", "b", "Koeffizient b", "coefficient b", "coeficiente b", "b"}},
        {reference::item::cylinder::c,
         {"c", "coefficient c", "c", "Koeffizient c", "coefficient c", "coeficiente c", "c"}},
        {reference::item::cylinder::d,
         {"d", "discriminant", "discriminant d", "Diskriminante d", "discriminant d", "discriminante d", "disc"}},
        {reference::item::cylinder::t,
         {"t", "ray parameter", "ray parameter t", "Strahlparameter t", "paramètre t", "parámetro t", "t_cylinder"}},
        {reference::item::cylinder::hit,
         {"P_c", "hit point on the cylinder", "hit point P_c", "Schnittpunkt P_c", "point P_c", "punto P_c",
          "hit_point"}},
        {reference::item::cylinder::normal,
         {"N", "cylinder normal", "normal N", "Normale N", "normale N", "normal N", "normal"}},
    };
    return names.at(id);
}

}  // namespace student
