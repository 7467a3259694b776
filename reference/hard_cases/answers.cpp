#include "reference/hard_cases/answers.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "reference/numbers/rational.h"
#include "reference/stages/cylinder.h"
#include "reference/stages/scene_numbers.h"
#include "reference/stages/sphere.h"
#include "reference/stages/triangle.h"

namespace reference::hard_cases {
namespace {

constexpr std::string_view not_a_number = "nan";

bool is_hit(std::string_view decision) {
    return decision == "hit" || decision == "tangent" || decision == "boundary";
}

std::string_view closed(std::string_view decision) {
    if (decision == "boundary") return "hit";  // the catalog's boundary is t >= 0
    return decision == "unsure" ? not_a_number : decision;
}

/// The answers of the stages in the rounding scalar S.
template <class S>
struct Rounding {
    kernel::Ray<double> ray;

    template <class Object>
    Answer operator()(const Object& object) const {
        CameraAnswers<S> start{};
        start.P_WCS = kernel::over<S>(ray.origin);
        start.V = kernel::over<S>(ray.direction);
        const auto answers = answer_object(start, kernel::over<S>(object), Boundary::nonnegative);
        const std::string_view decided = closed(decision(answers));
        Answer answer{decided, {}};
        if (!is_hit(decided)) return answer;
        answer.numbers.push_back(static_cast<double>(*answers.t));
        if constexpr (std::is_same_v<Object, Triangle<double>>)
            answer.numbers.insert(answer.numbers.end(),
                                  {static_cast<double>(*answers.u), static_cast<double>(*answers.v)});
        return answer;
    }
    Answer operator()(const SphereAndTriangle& both) const {
        const Answer sphere = (*this)(both.sphere), triangle = (*this)(both.triangle);
        if (sphere.numbers.empty() || triangle.numbers.empty()) return {not_a_number, {}};
        const double s = sphere.numbers.front(), t = triangle.numbers.front();
        return {s < t ? "sphere" : s == t ? "tie" : "triangle", {std::min(s, t)}};
    }
    Answer operator()(const Camera<double>& camera) const {
        const Vec3<S> X = view_basis(Camera<S>{kernel::over<S>(camera.eye), kernel::over<S>(camera.lookat),
                                               kernel::over<S>(camera.vup)})
                              .X_vcs;
        if (!std::isfinite(X.x + X.y + X.z)) return {not_a_number, {}};
        return {"axis", {static_cast<double>(X.x), static_cast<double>(X.y), static_cast<double>(X.z)}};
    }
};

std::string_view name_of(kernel::SphereResult result) {
    return std::array{"hit", "miss", "tangent", "invalid"}.at(static_cast<std::size_t>(result));
}
std::string_view name_of(kernel::TriangleResult result) {
    return std::array{"hit", "miss", "coplanar", "degenerate", "invalid"}.at(static_cast<std::size_t>(result));
}

struct Exact {
    kernel::Ray<double> ray;

    template <class Object>
    Answer operator()(const Object& object) const {
        const auto hit = kernel::intersect(ray, object);
        Answer answer{name_of(hit.result), {}};
        if (!kernel::is_hit(hit.result)) return answer;
        answer.numbers.push_back(hit.t);
        if constexpr (std::is_same_v<Object, Triangle<double>>)
            answer.numbers.insert(answer.numbers.end(), {hit.u, hit.v});
        return answer;
    }
    Answer operator()(const SphereAndTriangle& both) const {
        kernel::Cast cast;
        kernel::cast_ray(ray, {{both.sphere}, {both.triangle}}, cast);
        const double sphere = cast.spheres.front().t, triangle = cast.triangles.front().t;
        if (cast.first.object == FirstObject::tie) return {"tie", {sphere}};
        const bool is_sphere = cast.first.object == FirstObject(Subject::sphere);
        return {is_sphere ? "sphere" : "triangle", {is_sphere ? sphere : triangle}};
    }
    Answer operator()(const Camera<double>& camera) const {
        using kernel::over;
        const Scene<Rational> scene{
            {over<Rational>(camera.eye), over<Rational>(camera.lookat), over<Rational>(camera.vup)}, {}, {}};
        try {
            const Vec3<Certified> X = view_basis(certified_scene(scene).camera).X_vcs;
            return {"axis", {X.x.enclosure().nearest, X.y.enclosure().nearest, X.z.enclosure().nearest}};
        } catch (const std::domain_error&) {
            return {"invalid", {}};
        }
    }
};

}  // namespace

std::string_view to_string(Arithmetic arithmetic) {
    return std::array{"float", "double", "certified"}.at(static_cast<std::size_t>(arithmetic));
}

Answer answer(const Case& hard, Arithmetic arithmetic) {
    switch (arithmetic) {
        case Arithmetic::float_: return std::visit(Rounding<float>{hard.ray}, hard.target);
        case Arithmetic::double_: return std::visit(Rounding<double>{hard.ray}, hard.target);
        case Arithmetic::certified: break;
    }
    return std::visit(Exact{hard.ray}, hard.target);
}

Quoted quoted(std::string_view number) {
    Quoted result{0, 1};
    const char* const end = number.data() + number.size();
    std::from_chars(number.data(), end, result.value);
    const std::string_view mantissa = number.substr(0, number.find('e'));
    const std::size_t point = mantissa.find('.');
    int exponent = 0;
    if (mantissa.size() < number.size()) std::from_chars(mantissa.data() + mantissa.size() + 1, end, exponent);
    if (point != std::string_view::npos) exponent -= static_cast<int>(mantissa.size() - point - 1);
    result.unit = std::pow(10.0, exponent);
    return result;
}

bool is_right(const Case& hard, const Answer& answer) {
    constexpr double five_digits = 1e-5;
    if (hard.numbers.empty() || answer.numbers.empty()) return hard.numbers.empty() == answer.numbers.empty();
    const bool names_the_first = std::holds_alternative<SphereAndTriangle>(hard.target);
    bool is_right = !names_the_first || hard.decision == answer.decision;
    for (std::size_t i = 0; i < hard.numbers.size(); ++i) {
        if (hard.numbers[i].empty()) continue;
        const double value = quoted(hard.numbers[i]).value;
        const double size = hard.decision == "axis" || value == 0 ? 1 : std::abs(value);
        is_right = is_right && std::abs(answer.numbers[i] - value) <= five_digits * size;
    }
    return is_right;
}

}  // namespace reference::hard_cases
