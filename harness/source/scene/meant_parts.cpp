#include "harness/source/scene/meant_parts.h"

#include <algorithm>

#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"

namespace harness::source {

using reference::Subject;

std::vector<ScenePart> points_of(Subject object) {
    std::vector<ScenePart> points = parts_of(object);
    std::erase_if(points, [](ScenePart part) { return size_of(part) != 3; });
    return points;
}

bool MeantParts::is_called(std::string_view name, ScenePart part) const {
    return has_part(scene_, part) && may_name(name, part);
}

bool MeantParts::is_point_of_scene(ScenePart part, const std::array<double, 3>& value) const {
    return has_part(scene_, part) && size_of(part) == 3 && value_of(scene_, part) == value;
}

std::vector<ScenePart> MeantParts::parts_of_point(const StatedVector& vector) const {
    if (vector.name.empty()) return {};
    for (const Subject object : reference::objects) {
        if (reference::count_of(object, scene_) > 0 && mentions(vector.name, object))
            return first_called(vector.name, points_of(object));
    }
    std::vector<ScenePart> given;
    std::vector<ScenePart> of_objects;
    for (const ScenePart part : all_parts()) {
        if (size_of(part) != 3 || !is_called(vector.name, part)) continue;
        if (is_point_of_scene(part, vector.value)) given.push_back(part);
        if (part.subject != Subject::camera && !source_of(part.subject).needs_words) of_objects.push_back(part);
    }
    if (!given.empty()) return given;
    if (is_called(vector.name, part::vup)) return {part::vup};
    if (!of_objects.empty()) return {likeliest(of_objects)};
    return first_called(vector.name, {part::lookat, part::eye});
}

std::vector<ScenePart> MeantParts::first_called(std::string_view name, const std::vector<ScenePart>& parts) const {
    const auto found = std::ranges::find_if(parts, [&](ScenePart part) { return is_called(name, part); });
    return found == parts.end() ? std::vector<ScenePart>() : std::vector{*found};
}

bool MeantParts::is_any_called(ScenePart part) const {
    return std::ranges::any_of(vectors_, [&](const StatedVector& vector) { return may_name(vector.name, part); });
}

/// The handout calls both C: the sphere's center and the triangle's third vertex. It is the vertex if the source names
/// the others, too, and does not state this one elsewhere.
ScenePart MeantParts::likeliest(const std::vector<ScenePart>& parts) const {
    for (const ScenePart part : parts) {
        const std::vector<ScenePart> points = points_of(part.subject);
        const bool beside_others =
            std::ranges::all_of(points, [&](ScenePart other) { return other == part || is_any_called(other); });
        const bool is_unlike_others = std::ranges::none_of(all_parts(), [&](ScenePart other) {
            return other != part && is_point_of_scene(other, value_of(scene_, part));
        });
        const bool is_stated = std::ranges::any_of(vectors_, [&](const StatedVector& vector) {
            return is_point_of_scene(part, vector.value) && (is_unlike_others || may_name(vector.name, part));
        });
        if (points.size() > 1 && beside_others && !is_stated) return part;
    }
    const auto is_alone = [](ScenePart part) { return points_of(part.subject).size() == 1; };
    const auto alone = std::ranges::find_if(parts, is_alone);
    return alone == parts.end() ? parts.front() : *alone;
}

}  // namespace harness::source
