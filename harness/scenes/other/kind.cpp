#include "harness/scenes/other/kind.h"

namespace harness::scenes {
namespace {

/// What a kind is called in a scene that has a sphere, a triangle or both.
std::string_view to_string(Kind kind) {
    switch (kind) {
        case Kind::off_axis: return "camera off every axis";
        case Kind::triangle_first: return "triangle in front";
        case Kind::sphere_missed: return "ray beside the sphere";
        case Kind::grazing: return "far sphere, grazed";
    }
    return "";
}

}  // namespace

std::string_view name_of(Kind kind, const DecimalScene& scene) {
    if (scene.cylinders.empty()) return to_string(kind);
    if (kind == Kind::triangle_first && scene.triangles.empty()) return "cylinder's cap hit";
    if (kind == Kind::sphere_missed && scene.spheres.empty()) return "cylinder in front";
    if (kind == Kind::grazing && scene.spheres.empty()) return "ray past the cylinder";
    return to_string(kind);
}

CylinderPlan cylinder_plan(Kind kind) {
    switch (kind) {
        case Kind::off_axis: return {CylinderRole::tube, 9, 14};
        case Kind::triangle_first: return {CylinderRole::cap, 4, 10};
        case Kind::sphere_missed: return {CylinderRole::tube, 3, 6};
        case Kind::grazing: return {CylinderRole::above, 4, 8};
    }
    return {CylinderRole::tube, 3, 6};
}

}  // namespace harness::scenes
