// What is drawn of each kind of object.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/picture/sketch.h"
#include "reference/key/answer_key.h"
#include "reference/stages/scene.h"

namespace harness::report::picture {

/// What the key tells of a kind of object, by the object that the questions are about.
struct RightHit {
    std::optional<Point> hit, normal;
    std::size_t index = 0;  ///< of that object
};

/// The key's values as pictures need them. A value is empty if the scene does not ask for it or the ray misses.
struct RightValues {
    std::optional<Point> P_VCS, X_vcs, Y_vcs, Z_vcs, P_WCS, V;
    std::map<reference::Subject, RightHit> objects = {};

    RightHit of(reference::Subject kind) const {
        const auto found = objects.find(kind);
        return found == objects.end() ? RightHit() : found->second;
    }
};

/// Adds the object; `named` also what its points are called.
void draw_object(const reference::Sphere<double>& sphere, bool named, Sketch& sketch);
void draw_object(const reference::Triangle<double>& triangle, bool named, Sketch& sketch);
void draw_object(const reference::Cylinder<double>& cylinder, bool named, Sketch& sketch);

/// Adds where the ray meets the object that the questions are about.
void draw_hit(const reference::Sphere<double>& sphere, const RightValues& right, const reference::AnswerKey& key,
              Sketch& sketch);
void draw_hit(const reference::Triangle<double>& triangle, const RightValues& right, const reference::AnswerKey& key,
              Sketch& sketch);
void draw_hit(const reference::Cylinder<double>& cylinder, const RightValues& right, const reference::AnswerKey& key,
              Sketch& sketch);

/// Where a normal without a hit point is drawn.
Point middle_of(const reference::Sphere<double>& sphere);
Point middle_of(const reference::Triangle<double>& triangle);
Point middle_of(const reference::Cylinder<double>& cylinder);

/// What a frame holds if it holds the object: these points, and so much around each.
struct Extent {
    std::vector<Point> points;
    double around = 0;
};
Extent extent_of(const reference::Sphere<double>& sphere);
Extent extent_of(const reference::Triangle<double>& triangle);
Extent extent_of(const reference::Cylinder<double>& cylinder);

// For these functions.

/// The key's numbers for an item; null without any.
const reference::Numbers* numbers_of(const reference::AnswerKey& key, const reference::ItemId& id);
/// Empty without three finite numbers.
std::optional<Point> point_of(const reference::AnswerKey& key, const reference::ItemId& id);
/// NaN without a single number.
double number_of(const reference::AnswerKey& key, const reference::ItemId& id);

/// "P_s: the ray hits the sphere, t = 2."
std::string hit_note(std::string_view object, std::string_view point, double t);

}  // namespace harness::report::picture
