#include "reference/key/wide_allowances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/key/graded_allowance.h"
#include "reference/stages/scene_answers.h"

namespace reference {
namespace {

/// An allowance above this share of the value is told.
constexpr double widest_untold = 0.01;

/// A scene amplifies the errors of its numbers by more than this where a reason is looked for.
constexpr double amplifies = 1e3;

using Point = Vec3<double>;

/// A reason why float is inaccurate, and the way out.
struct Reason {
    double factor;  ///< by which it amplifies errors
    std::string_view what;
    std::string_view way_out;
};

/// How much narrower than a right angle the angle of p and q is: 1 over its sine.
double narrowness(const Point& p, const Point& q) {
    return length(p) * length(q) / length(cross(p, q));
}

/// Of the reasons for an object's uncertain items the strongest; empty where none is strong.
std::string reason_for(Subject subject, const Scene<double>& scene, const SceneAnswers<double>& answers) {
    const Point view = scene.camera.eye - scene.camera.lookat;
    const Point to_pixel = answers.camera.P_WCS - scene.camera.eye;
    std::vector<Reason> reasons{
        {narrowness(view, scene.camera.vup), "vup almost points along the view", "Turn vup or the camera"},
        {length(scene.camera.eye) / std::min(length(to_pixel), length(view)),
         "the eye's coordinates are large beside the distance to the pixel", "Move everything nearer to the origin"}};
    if (subject == Subject::sphere && answers.sphere) {
        const Sphere<double>& sphere = scene.spheres.at(answers.sphere.index);
        const Quadratic<double>& quadratic = answers.sphere->quadratic;
        const double distance = length(Point(answers.camera.P_WCS - sphere.center));
        const double far = std::pow(distance / sphere.radius, 2);
        const double grazing = 4 * quadratic.a * sphere.radius * sphere.radius / std::abs(quadratic.d);
        // Each amplifies what the other leaves. The larger one is the reason.
        reasons.push_back({grazing > far ? grazing * far : grazing, "the ray almost touches the sphere",
                           "Take another pixel, or move the sphere"});
        reasons.push_back(
            {grazing > far ? far : grazing * far, "the sphere is small beside its distance", "Bring it nearer"});
        reasons.push_back({sphere.radius * sphere.radius / std::abs(quadratic.c), "the ray starts almost on the sphere",
                           "Move the sphere"});
        reasons.push_back({std::pow(length(sphere.center) / distance, 2),
                           "the coordinates are large beside the distances", "Move everything nearer to the origin"});
    }
    if (subject == Subject::triangle && answers.triangle) {
        const Mat3<double>& M = answers.triangle->system.matrix;
        const double narrow = narrowness(M[1], M[2]);
        const double edge = std::min(length(M[1]), length(M[2]));
        reasons.push_back({narrow * narrow, "the triangle is narrow", "Move a vertex"});
        reasons.push_back({length(scene.triangles.at(answers.triangle.index).A) / edge,
                           "an edge of the triangle is short beside its coordinates", "Move a vertex"});
        reasons.push_back({1 / std::abs(dot(normalized(M[0]), normalized(cross(M[1], M[2])))),
                           "the ray runs almost in the triangle's plane", "Take another pixel, or turn the triangle"});
    }
    if (subject == Subject::cylinder && answers.cylinder) {
        const Cylinder<double>& cylinder = scene.cylinders.at(answers.cylinder.index);
        const Quadratic<double>& tube = answers.cylinder->equations.tube;
        const CylinderPart part = answers.cylinder->part;
        const Point from_center = answers.camera.P_WCS - cylinder.center;
        const double distance = length(from_center);
        const double square = cylinder.radius * cylinder.radius;
        const double far = (from_center.x * from_center.x + from_center.z * from_center.z) / square;
        if (part == CylinderPart::top_cap || part == CylinderPart::bottom_cap) {
            reasons.push_back({1 / std::abs(answers.camera.V.y), "the ray is almost parallel to the cylinder's caps",
                               "Take another pixel"});
        } else if (tube.a > 0) {
            const double grazing = 4 * tube.a * square / std::abs(tube.d);
            reasons.push_back({grazing > far ? grazing * far : grazing, "the ray almost touches the cylinder's tube",
                               "Take another pixel, or move the cylinder"});
            reasons.push_back(
                {grazing > far ? far : grazing * far, "the cylinder is thin beside its distance", "Bring it nearer"});
            reasons.push_back(
                {square / std::abs(tube.c), "the ray starts almost on the cylinder's tube", "Move the cylinder"});
            reasons.push_back({1 / tube.a, "the ray is almost parallel to the cylinder's axis", "Take another pixel"});
        }
        reasons.push_back({std::pow(length(cylinder.center) / distance, 2),
                           "the coordinates are large beside the distances", "Move everything nearer to the origin"});
    }
    const auto strongest = std::max_element(reasons.begin(), reasons.end(),
                                            [](const Reason& p, const Reason& q) { return p.factor < q.factor; });
    if (!(strongest->factor > amplifies)) return "A value is small beside the numbers that it is computed from.";
    return fmt::format("The reason: {}. {}, and answers are judged more sharply.", strongest->what, strongest->way_out);
}

/// An item's allowance beside its size; infinite where float can't answer; empty where it is not worth telling.
std::optional<double> wide_share(const KeyItem& item) {
    const Answer& answer = item.answers.front();
    const Numbers* numbers = std::get_if<Numbers>(&answer.value);
    if (numbers == nullptr || answer.allowance.empty()) return std::nullopt;
    if (!float_can_answer(answer)) return std::numeric_limits<double>::infinity();
    const double size = largest_component(*numbers);
    const double share = *std::max_element(answer.allowance.begin(), answer.allowance.end()) / (size > 0 ? size : 1);
    return share > widest_untold ? std::optional(share) : std::nullopt;
}

std::string_view name_of(Subject subject) {
    switch (subject) {
        case Subject::camera: return "the ray";
        case Subject::sphere: return "the sphere";
        case Subject::triangle: return "the triangle";
        case Subject::cylinder: return "the cylinder";
        case Subject::first_hit: return "the first hit";
    }
    return "";
}

}  // namespace

std::vector<std::string> tell_wide_allowances(const std::vector<KeyQuestion>& questions, const Scene<Decimal>& scene) {
    const Scene<double> numbers = convert_scene<double>(scene, [](const Decimal& x) { return x.to_double(); });
    const SceneAnswers<double> answers = answer_scene(numbers, PixelConvention::centre, Boundary::nonnegative);
    std::vector<std::string> paragraphs;
    for (const Subject subject : {Subject::camera, Subject::sphere, Subject::triangle, Subject::cylinder}) {
        std::string off, any;
        for (const KeyQuestion& question : questions) {
            for (const KeyItem& item : question.items) {
                const std::optional<double> share = wide_share(item);
                if (item.spec.id.subject != subject || !share) continue;
                std::string& list = std::isfinite(*share) ? off : any;
                list += fmt::format("{}{} of question {}", list.empty() ? "" : ", ", item.spec.name, question.number);
                if (std::isfinite(*share)) list += fmt::format(" ({:.2g} %)", 100 * *share);
            }
        }
        if (off.empty() && any.empty()) continue;
        std::string text = fmt::format("Float is coarse for {} of this scene.", name_of(subject));
        if (!off.empty()) text += fmt::format(" A correct program may be off by so much of the value: {}.", off);
        if (!any.empty())
            text += fmt::format(" A correct program may print any number, and every number counts as right: {}.", any);
        paragraphs.push_back(text + " " + reason_for(subject, numbers, answers));
    }
    return paragraphs;
}

}  // namespace reference
