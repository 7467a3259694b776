#include "reference/key/wide_allowances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "reference/key/graded_allowance.h"
#include "reference/key/object_programs.h"
#include "reference/stages/scene_answers.h"
#include "reference/toml/rubric.h"

namespace reference {
namespace {

/// A note mentions allowances above this share of the value.
constexpr double widest_untold = 0.01;

/// The note gives a reason that amplifies the errors of the scene's numbers by more than this.
constexpr double amplifies = 1e3;

using Point = Vec3<double>;

/// The strongest reason for an object's uncertain items; a general sentence if none is strong.
std::string reason_for(Subject subject, const Scene<double>& scene, const SceneAnswers<double>& answers) {
    const Point view = scene.camera.eye - scene.camera.lookat;
    const Point to_pixel = answers.camera.P_WCS - scene.camera.eye;
    std::vector<Reason> reasons{
        {narrowness(view, scene.camera.vup), "vup almost points along the view", "Turn vup or the camera"},
        {length(scene.camera.eye) / std::min(length(to_pixel), length(view)),
         "the eye's coordinates are large compared with the distance to the pixel",
         "Move everything closer to the origin"}};
    for_each_object_asked(
        [&](Subject kind, const auto& of_scene, const auto& asked) {
            if (kind != subject || !asked) return;
            const std::vector<Reason> more = reasons_of(of_scene.at(asked.index), *asked, answers.camera);
            reasons.insert(reasons.end(), more.begin(), more.end());
        },
        scene, answers);
    const auto strongest = std::max_element(reasons.begin(), reasons.end(),
                                            [](const Reason& p, const Reason& q) { return p.factor < q.factor; });
    if (!(strongest->factor > amplifies))
        return "A value is small compared with the numbers that it is computed from. Move the object or the pixel a "
               "little to tighten the check.";
    return fmt::format("The reason: {}. {} to tighten the check.", strongest->what, strongest->way_out);
}

/// An answer's allowance relative to its size; infinite if float cannot give the answer; 0 if it is not a number.
double share_of(const Answer& answer) {
    const Numbers* numbers = std::get_if<Numbers>(&answer.value);
    if (numbers == nullptr || answer.allowance.empty()) return 0;
    if (!float_can_answer(answer)) return std::numeric_limits<double>::infinity();
    const double size = largest_component(*numbers);
    return *std::max_element(answer.allowance.begin(), answer.allowance.end()) / (size > 0 ? size : 1);
}

/// The widest share of the item's answers, under any pixel convention; empty if it is too small to mention.
std::optional<double> wide_share(const KeyItem& item) {
    double widest = 0;
    for (const Answer& answer : item.answers) widest = std::max(widest, share_of(answer));
    return widest > widest_untold ? std::optional(widest) : std::nullopt;
}

std::string name_of(Subject subject) {
    return subject == Subject::camera ? "the ray" : fmt::format("the {}", to_string(subject));
}

}  // namespace

std::vector<std::string> tell_wide_allowances(const std::vector<KeyQuestion>& questions, const Scene<Decimal>& scene) {
    const Scene<double> numbers = convert_scene<double>(scene, [](const Decimal& x) { return x.to_double(); });
    const SceneAnswers<double> answers = answer_scene(numbers, PixelConvention::centre, Boundary::nonnegative);
    std::vector<std::string> paragraphs;
    std::vector<Subject> subjects{Subject::camera};
    subjects.insert(subjects.end(), std::begin(objects), std::end(objects));
    for (const Subject subject : subjects) {
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
        std::string text = fmt::format("Float is inaccurate for {} of this scene.", name_of(subject));
        if (!off.empty())
            text += fmt::format(" The answers of a correct program may be off by this share of the value: {}.", off);
        if (!any.empty())
            text += fmt::format(
                " A correct program may print any number here; it counts unless the student's other answers "
                "rule it out: {}.",
                any);
        paragraphs.push_back(text + " " + reason_for(subject, numbers, answers));
    }
    return paragraphs;
}

}  // namespace reference
