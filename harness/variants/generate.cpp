#include "harness/variants/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "harness/variants/object_in_kinds.h"
#include "harness/variants/random/draw.h"
#include "reference/stages/item_values.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace harness::variants {
namespace {

using reference::Assignment;
using reference::Decimal;
using reference::Scene;
using reference::Variant;
using reference::Vec3;

bool is_zero(const Vec3<double>& p) {
    return p.x == 0 && p.y == 0 && p.z == 0;
}

/// Draws scenes of one kind. Lengths grow with the distance of its objects.
class Painter {
  public:
    Painter(const Assignment& assignment, const source::PartSet& located, Kind kind, bool moves_pixel)
        : base_(in_double(assignment.scene)),
          convention_(assignment.rubric.pixel_conventions.front()),
          located_(located),
          kind_(kind),
          moves_pixel_(moves_pixel),
          size_(kind == Kind::grazing ? 8 : 1) {}

    Scene<double> paint(Draw& draw) const {
        Scene<double> scene = base_;
        paint_camera(scene, draw);
        const auto ray = reference::answer_camera(scene, convention_);
        const Vec3<double> side = across(ray.V, draw);
        const double distance = size_ * draw.between(4, 8);
        const Room room{{kind_, located_, ray}, size_, distance, side};
        reference::for_each_kind(
            [&](reference::Subject /*kind*/, auto& objects) {
                if (!objects.empty()) draw_object(objects.front(), room, draw);
            },
            scene);
        return scene;
    }

  private:
    void paint_camera(Scene<double>& scene, Draw& draw) const {
        reference::Camera<double>& camera = scene.camera;
        if (located_.contains(source::part::lookat)) camera.lookat = draw.vector(2);
        if (located_.contains(source::part::vup)) camera.vup = draw.vector(2);
        if (located_.contains(source::part::eye)) camera.eye = camera.lookat + rounded(size_ * draw.vector(6));
        if (moves_pixel_ && located_.contains(source::part::pixel)) {
            const auto within = [&](int count) {
                return std::clamp(draw.whole(count / 4, count - count / 4), 0, count - 1);
            };
            scene.pixel = {within(scene.window.width), within(scene.window.height)};
        }
    }

    Scene<double> base_;
    reference::PixelConvention convention_;
    source::PartSet located_;
    Kind kind_;
    bool moves_pixel_;
    double size_;
};

using Answers = reference::SceneAnswers<double>;

Answers answer(const Scene<double>& scene, const Assignment& assignment) {
    return reference::answer_scene(scene, assignment.rubric.pixel_conventions.front(),
                                   reference::Boundary::nonnegative);
}

/// Whether the camera is far from any undefined case.
bool is_sound(const Scene<double>& scene) {
    const Vec3<double> view = scene.camera.eye - scene.camera.lookat;
    if (reference::dot(view, view) < 4 || is_zero(scene.camera.vup)) return false;
    return reference::length(reference::cross(reference::normalized(scene.camera.vup), reference::normalized(view))) >
           0.3;
}

/// An object, and where the ray hits it.
struct Hit {
    double t;
    const ObjectInKinds& object;
};

/// Whether no two objects are hit at nearly the same t, and the kind's leader is hit first. If an object may be
/// anywhere, only the kind with an object in front needs its leader first.
bool are_in_order(const std::vector<Hit>& hits, bool have_distances, Kind kind) {
    constexpr double apart = 0.3;
    for (const Hit& hit : hits) {
        const bool leads = hit.object.leads == kind && (have_distances || kind == Kind::in_front);
        for (const Hit& other : hits) {
            if (&other == &hit) continue;
            if (leads ? !(other.t - hit.t > apart) : std::abs(hit.t - other.t) <= apart) return false;
        }
    }
    return true;
}

/// Whether the scene has its kind's property, as far as the located parts allow it.
bool has_property(const Answers& answers, const Scene<double>& scene, const source::PartSet& located, Kind kind) {
    std::vector<Hit> hits;
    bool all_wanted = true;
    bool have_distances = false;
    reference::for_each_object_asked(
        [&](reference::Subject object, const auto& objects, const auto& asked) {
            if (objects.empty() || !located.contains(source::ScenePart{object, 0})) return;
            all_wanted = all_wanted && is_as_wanted(objects.front(), *asked, {kind, located, answers.camera});
            if (asked->t) hits.push_back({*asked->t, in_kinds(object)});
            have_distances = have_distances || in_kinds(object).has_distances;
        },
        scene, answers);
    return all_wanted && are_in_order(hits, have_distances, kind);
}

/// How the ray meets the objects that do not move.
std::vector<Meeting> meetings_left(const Answers& answers, const Scene<double>& scene, const source::PartSet& located) {
    std::vector<Meeting> meetings;
    reference::for_each_object_asked(
        [&](reference::Subject object, const auto& objects, const auto& asked) {
            if (objects.empty() || located.contains(source::ScenePart{object, 0})) return;
            meetings.push_back(meeting(objects.at(asked.index), *asked, answers.camera));
        },
        scene, answers);
    return meetings;
}

/// Whether the ray is the same, as happens if the camera turns about a pixel in the middle.
bool is_same_ray(const Answers& answers, const Answers& other) {
    constexpr double nearly = 1e-9;
    return reference::length(answers.camera.P_WCS - other.camera.P_WCS) < nearly &&
           reference::length(answers.camera.V - other.camera.V) < nearly;
}

/// Whether two values differ by more than rounding and short decimals can explain.
bool differ(const reference::ItemValue<double>& item_value, const reference::ItemValue<double>& other) {
    const auto* a = std::get_if<std::vector<double>>(&item_value);
    const auto* b = std::get_if<std::vector<double>>(&other);
    if (a == nullptr || b == nullptr) return item_value.index() != other.index();
    constexpr double apart = 0.05;
    for (std::size_t i = 0; i < a->size(); ++i) {
        if (std::abs(a->at(i) - b->at(i)) > apart) return true;
    }
    return false;
}

int differences(const Answers& answers, const reference::ItemValues<double>& base) {
    int count = 0;
    for (const auto& [id, value] : reference::values_of(answers, reference::Boundary::nonnegative)) {
        const auto found = base.find(id);
        if (found != base.end() && differ(value, found->second)) ++count;
    }
    return count;
}

/// The properties that a scene should have.
struct Wish {
    Kind kind;
    bool moves_pixel;
    std::optional<reference::Subject> first = {};  ///< the object that the ray should hit first; any if empty
};

Wish plain_wish(Kind kind) {
    return {kind, kind == Kind::in_front || kind == Kind::grazing};
}

bool is_first(const Answers& answers, std::optional<reference::Subject> object) {
    return !object || answers.first_object == reference::FirstObject(*object);
}

/// Empty if no scene of the kind could be drawn.
std::optional<Scene<double>> draw_scene(const Assignment& assignment, const source::PartSet& located, const Wish& wish,
                                        Draw draw) {
    const Kind kind = wish.kind;
    const Painter painter(assignment, located, kind, wish.moves_pixel);
    const Scene<double> base_scene = in_double(assignment.scene);
    const Answers base_answers = answer(base_scene, assignment);
    const auto base = reference::values_of(base_answers, reference::Boundary::nonnegative);
    const std::vector<Meeting> base_meetings = meetings_left(base_answers, base_scene, located);
    constexpr int attempts = 400;
    constexpr int property = 1000;  // weighs more than all differences
    // Three items need not differ: a is always 1, because V has length 1; P_VCS only depends on the pixel; and the
    // verdict has few values.
    const int enough = property + static_cast<int>(base.size()) - 3;
    std::optional<Scene<double>> best;
    int most = -1;
    for (int i = 0; i < attempts && most < enough; ++i) {
        Scene<double> scene = painter.paint(draw);
        if (!is_sound(scene)) continue;
        const Answers answers = answer(scene, assignment);
        bool wanted = has_property(answers, scene, located, kind) && is_first(answers, wish.first);
        if (!is_same_ray(answers, base_answers)) {
            const std::vector<Meeting> meetings = meetings_left(answers, scene, located);
            if (!std::ranges::all_of(meetings, &Meeting::is_clear)) continue;
            wanted = wanted && std::ranges::equal(meetings, base_meetings, {}, &Meeting::is_hit, &Meeting::is_hit);
        }
        if (!wanted && most >= property) continue;
        const int worth = differences(answers, base) + (wanted ? property : 0);
        if (worth <= most) continue;
        most = worth;
        best = std::move(scene);
    }
    return most > 0 ? best : std::nullopt;
}

source::PartSet had_by(const source::DecimalScene& scene, const source::PartSet& parts) {
    source::PartSet had;
    for (const source::ScenePart part : source::all_parts()) {
        if (parts.contains(part) && source::has_part(scene, part)) had.insert(part);
    }
    return had;
}

/// The assignment's scene with the located parts taken from `other`.
source::DecimalScene restricted(const source::DecimalScene& scene, const source::DecimalScene& other,
                                const source::PartSet& located) {
    source::DecimalScene result = scene;
    for (const source::ScenePart part : source::all_parts()) {
        if (located.contains(part)) source::copy_part(result, other, part);
    }
    return result;
}

bool is_new_and_valid(const source::DecimalScene& scene, const Assignment& assignment) {
    if (reference::scene_toml(scene) == reference::scene_toml(assignment.scene)) return false;
    try {
        reference::check_scene(scene, "another scene");
        return true;
    } catch (const reference::AssignmentError&) {
        return false;  // e.g. the eye was moved onto a lookat that was not located
    }
}

}  // namespace

std::vector<Variant> variants_for(const Assignment& assignment, const source::PartSet& found, int count,
                                  std::uint64_t seed) {
    const source::PartSet located = had_by(assignment.scene, found);
    std::vector<Variant> scenes;
    if (located.empty()) return scenes;
    const auto wanted = static_cast<std::size_t>(count);
    for (const Variant& given : assignment.variants) {
        source::DecimalScene scene = restricted(assignment.scene, given.scene, located);
        if (scenes.size() < wanted && is_new_and_valid(scene, assignment))
            scenes.push_back({given.name, std::move(scene)});
    }
    for (std::uint64_t drawn = 0; scenes.size() < wanted && drawn < 2 * wanted; ++drawn) {
        const Kind kind = all_kinds.at(drawn % all_kinds.size());
        const auto scene = draw_scene(assignment, located, plain_wish(kind), Draw(seed * 1000003 + drawn));
        if (!scene) continue;
        source::DecimalScene exact = in_decimal(*scene);
        const std::string again = drawn < all_kinds.size() ? "" : fmt::format(" ({})", drawn / all_kinds.size() + 1);
        if (is_new_and_valid(exact, assignment))
            scenes.push_back({std::string(name_of(kind, assignment.scene)) + again, std::move(exact)});
    }
    return scenes;
}

std::vector<Variant> scenes_with_all_hit(const Assignment& assignment, const source::PartSet& found, int count) {
    const source::PartSet located = had_by(assignment.scene, found);
    std::vector<reference::Subject> objects;
    for (const reference::Subject object : reference::objects) {
        if (located.contains(source::ScenePart{object, 0})) objects.push_back(object);
    }
    std::vector<Variant> scenes;
    const auto wanted = static_cast<std::size_t>(count);
    for (std::uint64_t drawn = 0; !located.empty() && scenes.size() < wanted && drawn < 2 * wanted; ++drawn) {
        Wish wish{Kind::off_axis, /*moves_pixel=*/true};
        if (!objects.empty()) wish.first = objects[drawn % objects.size()];
        if (wish.first && in_kinds(*wish.first).leads == Kind::in_front) wish.kind = Kind::in_front;
        const auto scene = draw_scene(assignment, located, wish, Draw(2 * drawn + 1));
        if (!scene) continue;
        source::DecimalScene exact = in_decimal(*scene);
        if (is_new_and_valid(exact, assignment))
            scenes.push_back({fmt::format("experiment {}", scenes.size() + 1), std::move(exact)});
    }
    return scenes;
}

}  // namespace harness::variants
