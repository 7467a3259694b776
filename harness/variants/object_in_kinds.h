// How each kind of object is placed in the other scenes, and the result to check. Each kind's file defines its
// functions.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "harness/source/scene/scene_part.h"
#include "harness/variants/random/draw.h"
#include "reference/stages/scene_answers.h"

namespace harness::variants {

/// The kinds of other scenes.
enum class Kind {
    off_axis,
    in_front,  ///< an object before those that the assignment's ray may hit first; the pixel moves
    beside,    ///< the ray misses an object
    grazing,   ///< far objects, one of which the ray grazes; the pixel moves
};
inline constexpr std::array all_kinds{Kind::off_axis, Kind::in_front, Kind::beside, Kind::grazing};

struct Situation {
    Kind kind;
    const source::PartSet& located;  ///< only these parts may change
    const reference::CameraAnswers<double>& ray;
};

/// The size and position for placing the objects.
struct Room : Situation {
    double size;                     ///< lengths are proportional to it
    double distance;                 ///< from the ray's start, for an object without its own distance
    reference::Vec3<double> beside;  ///< a unit vector perpendicular to the ray, for objects that need only one
};

// Draws the located parts of the object, so that the ray mostly meets it as the kind of scene requires.
void draw_object(reference::Sphere<double>& sphere, const Room& room, Draw& draw);
void draw_object(reference::Triangle<double>& triangle, const Room& room, Draw& draw);
void draw_object(reference::Cylinder<double>& cylinder, const Room& room, Draw& draw);

// Whether the ray does so clearly: no float program may get it wrong. Called for objects whose first part was located.
bool is_as_wanted(const reference::Sphere<double>& sphere, const reference::SphereAnswers<double>& answers,
                  const Situation& situation);
bool is_as_wanted(const reference::Triangle<double>& triangle, const reference::TriangleAnswers<double>& answers,
                  const Situation& situation);
bool is_as_wanted(const reference::Cylinder<double>& cylinder, const reference::CylinderAnswers<double>& answers,
                  const Situation& situation);

/// How the ray meets an object that does not change, because it was not located.
struct Meeting {
    bool is_hit;    ///< at its start or in front of it, wherever the other objects are
    bool is_clear;  ///< no float program may get it wrong, or divide by nearly zero
};
Meeting meeting(const reference::Sphere<double>& sphere, const reference::SphereAnswers<double>& answers,
                const reference::CameraAnswers<double>& ray);
Meeting meeting(const reference::Triangle<double>& triangle, const reference::TriangleAnswers<double>& answers,
                const reference::CameraAnswers<double>& ray);
Meeting meeting(const reference::Cylinder<double>& cylinder, const reference::CylinderAnswers<double>& answers,
                const reference::CameraAnswers<double>& ray);

struct ObjectInKinds {
    /// The name of each kind's scene if it is about this object; else empty.
    std::array<std::string_view, all_kinds.size()> names;
    /// The kind in which this object is hit before all others.
    std::optional<Kind> leads = {};
    /// Whether each kind has distances for it. If not, it may be anywhere, and other objects need not be hit before it.
    bool has_distances = false;
};

/// Each kind of object defines its own.
template <reference::Subject object>
const ObjectInKinds& in_kinds();

const ObjectInKinds& in_kinds(reference::Subject object);

/// The name of a scene of this kind, by the objects that the assignment's scene has.
std::string_view name_of(Kind kind, const source::DecimalScene& scene);

}  // namespace harness::variants
