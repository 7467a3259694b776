// Optional settings of a scene file for rendering a picture. The ten questions do not use them. Colors are red, green
// and blue, from 0 (dark) to 1 (full); lengths are in world units. There are no default lights or materials.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/numbers/vector.h"
#include "reference/stages/items.h"

namespace reference {

using Color = Vec3<double>;

struct PointLight {
    Vec3<double> position;
    Color color;  ///< the same at any distance
};

/// A light so far away that its rays are parallel.
struct DirectionalLight {
    Vec3<double> direction;  ///< the direction in which the light travels; not zero
    Color color;
};

/// A material after Phong, with reflection and refraction. reflectivity + transparency <= 1; the rest is the surface's
/// own color.
struct Material {
    Color ambient{0, 0, 0};
    Color diffuse{0, 0, 0};
    Color specular{0, 0, 0};
    int shininess = 1;            ///< the exponent of the highlight, 1 to 100,000
    double reflectivity = 0;      ///< the share that acts as a mirror, 0 to 1
    double transparency = 0;      ///< the share that acts as glass, 0 to 1: refracts and reflects after Fresnel
    double refractive_index = 1;  ///< of the inside; the outside has 1
};

/// The index of each object's material; objects beyond the end have none.
using MaterialChoices = std::vector<std::optional<std::size_t>>;

struct Appearance {
    std::vector<PointLight> point_lights;
    std::vector<DirectionalLight> directional_lights;
    Color ambient_light{0, 0, 0};
    Color background{0, 0, 0};
    int samples_per_pixel = 1;  ///< a square number: they form a grid in the pixel
    std::vector<Material> materials;
    std::map<Subject, MaterialChoices> object_materials;  ///< by kind of object
};

}  // namespace reference
