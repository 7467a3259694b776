// What a scene may say beyond the ten questions, for a picture of it. Colors are red, green and blue, 0 dark and 1
// full; lengths are in world units. What is not written does not exist: no light, no material, no mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reference/vector.h"

namespace reference {

using Color = Vec3<double>;

struct PointLight {
    Vec3<double> position;
    Color color;  ///< at any distance
};

/// From so far away that its light is parallel.
struct DirectionalLight {
    Vec3<double> direction;  ///< in which the light travels; not zero
    Color color;
};

/// After Phong, with what a surface passes on. reflectivity + transparency <= 1; the rest is the surface's own color.
struct Material {
    Color ambient{0, 0, 0};
    Color diffuse{0, 0, 0};
    Color specular{0, 0, 0};
    int shininess = 1;            ///< the exponent of the highlight, 1 to 100,000
    double reflectivity = 0;      ///< the share of a mirror, 0 to 1
    double transparency = 0;      ///< the share of glass, 0 to 1: refracted and reflected after Fresnel
    double refractive_index = 1;  ///< of what lies inside; outside it is 1
};

struct MeshFile {
    std::filesystem::path path;  ///< from the scene file's folder, or absolute
    std::optional<std::size_t> material;
    std::string place;  ///< for messages: file, line and key
};

struct Look {
    std::vector<PointLight> point_lights;
    std::vector<DirectionalLight> directional_lights;
    Color ambient_light{0, 0, 0};
    Color background{0, 0, 0};
    int samples_per_pixel = 1;  ///< a square number: a grid in the pixel
    std::vector<Material> materials;
    std::vector<std::optional<std::size_t>> sphere_materials;    ///< of the first spheres; others have none
    std::vector<std::optional<std::size_t>> triangle_materials;  ///< of the first triangles; others have none
    std::vector<MeshFile> meshes;
};

}  // namespace reference
